// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure, body, inertia and lift forces and the torque against closed forms.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/physics/fluid_forces/force_cases.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using forces::cross;
using forces::dot;
using forces::FluidState;
using forces::ForceSettings;
using forces::ForceTerms;
using forces::kPi;
using forces::MomentumModel;
using forces::norm;
using forces::ParticleState;
using forces::scaled;
using forces::Vec3;
using test::argon;
using test::busy_fluid;
using test::busy_particle;
using test::kRounding;
using test::make_force;
using test::steel;

/// States at which the creeping limits are read: corrections are of this size or less.
constexpr double kCreep = 1e-5;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

double ball(double d) { return 4.0 / 3.0 * kPi * std::pow(d / 2, 3); }

ForceSettings model_b() {
  ForceSettings s;
  s.model = MomentumModel::B;
  return s;
}

void check_pressure_gradient() {
  const FluidState f = busy_fluid();
  const ParticleState p = busy_particle();
  const Vec3 force = make_force("pressure_gradient")->evaluate(f, p).force_N;
  const Vec3 expected = scaled(-ball(p.diameter_m), f.pressure_gradient_Pa_m);
  expect_near(force, expected, kRounding * norm(expected));
  EXPECT_EQ(norm(make_force("pressure_gradient", model_b())->evaluate(f, p).force_N), 0.0);
}

void check_viscous_stress() {
  FluidState f = busy_fluid();
  const ParticleState p = busy_particle();
  // Developed pipe flow: grad p = div tau, so that pressure and stress cancel on the particle.
  f.viscous_stress_divergence_N_m3 = f.pressure_gradient_Pa_m;
  ForceTerms t = make_force("viscous_stress")->evaluate(f, p);
  const Vec3 expected = scaled(ball(p.diameter_m), f.viscous_stress_divergence_N_m3);
  expect_near(t.force_N, expected, kRounding * norm(expected));
  t += make_force("pressure_gradient")->evaluate(f, p);
  expect_near(t.force_N, {0, 0, 0}, kRounding * norm(expected));
  EXPECT_EQ(norm(make_force("viscous_stress", model_b())->evaluate(f, p).force_N), 0.0);
}

void check_buoyancy() {
  const FluidState f = busy_fluid();
  ParticleState p = busy_particle();
  const double volume = ball(p.diameter_m);
  const double net = (p.density_kg_m3 - f.density_kg_m3) * volume;
  for (const ForceSettings& s : {ForceSettings{}, model_b()}) {
    expect_near(make_force("buoyancy", s)->evaluate(f, p).force_N, scaled(net, f.gravity_m_s2),
                kRounding * net * norm(f.gravity_m_s2));
  }
  // With m g from the DEM code the sum is the same: the weight is not counted twice.
  ForceSettings dem;
  dem.weight_in_dem = true;
  const Vec3 lift = make_force("buoyancy", dem)->evaluate(f, p).force_N;
  const Vec3 weight = scaled(p.density_kg_m3 * volume, f.gravity_m_s2);
  expect_near(forces::sum(lift, weight), scaled(net, f.gravity_m_s2), kRounding * norm(weight));
  p.density_kg_m3 = f.density_kg_m3;
  EXPECT_EQ(norm(make_force("buoyancy")->evaluate(f, p).force_N), 0.0) << "neutral";
}

void check_virtual_mass() {
  FluidState f = busy_fluid();
  f.pressure_gradient_Pa_m = scaled(-f.density_kg_m3, f.acceleration_m_s2);  // Euler
  ParticleState p = busy_particle();
  const double displaced = f.density_kg_m3 * ball(p.diameter_m);
  // (m + m_a) dv/dt = m_a Du/Dt + rho V Du/Dt: a bubble runs ahead threefold, a neutral
  // particle follows.
  for (const double ratio : {1e-9, 1.0, 5.0}) {
    p.density_kg_m3 = ratio * f.density_kg_m3;
    ForceTerms t = make_force("virtual_mass")->evaluate(f, p);
    EXPECT_NEAR(t.added_mass_kg, displaced / 2, kRounding * displaced);
    t += make_force("pressure_gradient")->evaluate(f, p);
    const Vec3 dv = scaled(1 / (ratio * displaced + t.added_mass_kg), t.force_N);
    const double lead = 1.5 / (ratio + 0.5);
    expect_near(dv, scaled(lead, f.acceleration_m_s2),
                kRounding * lead * norm(f.acceleration_m_s2));
  }
  ForceSettings other;
  other.virtual_mass_coefficient = 0.0;
  EXPECT_EQ(make_force("virtual_mass", other)->evaluate(f, p).added_mass_kg, 0.0);
  for (const double bad : {-0.1, std::nan("")}) {
    other.virtual_mass_coefficient = bad;
    EXPECT_TRUE(
        test::refuses([&] { make_force("virtual_mass", other); }, "virtual_mass_coefficient"));
  }
}

/// u = G y e_x past a particle at the origin that lags behind by `slip`.
FluidState shear(double rate, double slip) {
  FluidState f = argon();
  f.velocity_m_s = {slip, 0.0, 0.0};
  f.velocity_curl_1_s = {0.0, 0.0, -rate};
  return f;
}

double mei(double re, double beta) {
  if (re >= 40) return 0.0524 * std::sqrt(beta * re);
  return (1 - 0.3314 * std::sqrt(beta)) * std::exp(-re / 10) + 0.3314 * std::sqrt(beta);
}

void check_saffman_mei() {
  const ParticleState p = steel();
  const double a = p.diameter_m / 2, nu = argon().kinematic_viscosity_m2_s;
  const double mu = argon().density_kg_m3 * nu;
  const auto law = make_force("saffman_mei");
  // Saffman's own form, 6.46 mu a^2 V sqrt(G/nu), for Re << sqrt(Re_w) << 1.
  const double small = 1e-7 * nu / p.diameter_m, slow = 1e-4 * nu / std::pow(p.diameter_m, 2);
  const Vec3 creeping = law->evaluate(shear(slow, small), p).force_N;
  const double saffman = 6.46 * mu * a * a * small * std::sqrt(slow / nu);
  expect_near(creeping, {0.0, saffman, 0.0}, kCreep * saffman);
  for (const double re : {0.1, 1.0, 10.0, 39.9, 40.0, 100.0}) {
    for (const double beta : {0.005, 0.1, 0.4}) {
      const double slip = re * nu / p.diameter_m;
      const double rate = 2 * beta * slip / p.diameter_m;  // Re_w = 2 beta Re
      const double expected = 1.615 * std::pow(p.diameter_m, 2) *
                              std::sqrt(argon().density_kg_m3 * mu / rate) * mei(re, beta) * slip *
                              rate;
      expect_near(law->evaluate(shear(rate, slip), p).force_N, {0.0, expected, 0.0},
                  kRounding * expected);
    }
  }
  EXPECT_LT(law->evaluate(shear(100.0, -0.1), p).force_N[1], 0.0) << "leads: to slower fluid";
  EXPECT_LT(law->evaluate(shear(-100.0, 0.1), p).force_N[1], 0.0) << "lags: to faster fluid";
  constexpr double print = 0.005;  // the header gives the step at Re 40 in per cent
  EXPECT_NEAR(1 - mei(40.0, 0.1) / mei(40.0 * (1 - 1e-9), 0.1), 0.14, print);
  EXPECT_NEAR(1 - mei(40.0, 0.4) / mei(40.0 * (1 - 1e-9), 0.4), 0.06, print);
}

void check_magnus() {
  const ParticleState at_rest = steel();
  const double d = at_rest.diameter_m, nu = argon().kinematic_viscosity_m2_s;
  const double rho = argon().density_kg_m3;
  const auto law = make_force("magnus");
  // Rubinow and Keller: pi a^3 rho omega x v of a particle in fluid at rest.
  ParticleState p = at_rest;
  p.velocity_m_s = {1e-12 * nu / d, 0.0, 0.0};
  p.spin_rad_s = {0.0, 0.0, 1e-14 * nu / (d * d)};
  const Vec3 creeping = scaled(kPi * std::pow(d / 2, 3) * rho, cross(p.spin_rad_s, p.velocity_m_s));
  expect_near(law->evaluate(argon(), p).force_N, creeping, 1e2 * kCreep * norm(creeping));
  // The printed form in gamma = |omega| d/(2 V).
  for (const double re : {10.0, 50.0, 140.0}) {
    for (const double gamma : {0.5, 1.0, 6.0}) {
      const double speed = re * nu / d;
      p.velocity_m_s = {speed, 0.0, 0.0};
      p.spin_rad_s = {0.0, 0.0, 2 * gamma * speed / d};
      const double cl =
          0.45 + (2 * gamma - 0.45) * std::exp(-0.075 * std::pow(gamma, 0.4) * std::pow(re, 0.7));
      const double expected = 0.5 * rho * speed * speed * kPi / 4 * d * d * cl;
      constexpr double rounded = 2e-4;  // 0.05684 is 0.075 2^-0.4 to four digits
      expect_near(law->evaluate(argon(), p).force_N, {0.0, expected, 0.0}, rounded * expected);
    }
  }
  // Only the spin relative to the fluid counts.
  FluidState vortex = argon();
  vortex.velocity_curl_1_s = scaled(2.0, p.spin_rad_s);
  EXPECT_EQ(norm(law->evaluate(vortex, p).force_N), 0.0);
}

void check_rotational_drag() {
  ParticleState p = steel();
  const double d = p.diameter_m, nu = argon().kinematic_viscosity_m2_s;
  const double rho = argon().density_kg_m3;
  const auto law = make_force("rotational_drag");
  for (const double re : {0.0, 1e-3, 1.0, 32.0, 32.001, 100.0, 1000.0}) {
    const double spin = re * nu / (d * d);
    p.spin_rad_s = {0.0, spin, 0.0};
    const ForceTerms t = law->evaluate(argon(), p);
    // Lamb below; above Dennis et al. in R = a^2 |omega|/nu: M = T/(rho a^5 omega^2/2).
    double expected = 8 * kPi * rho * nu * std::pow(d / 2, 3);
    if (re > 32.0 + 1e-9) {
      const double r = re / 4;
      expected = (6.45 / std::sqrt(r) + 32.1 / r) * 0.5 * rho * std::pow(d / 2, 5) * spin;
    }
    constexpr double seam = 1e-9;  // Re of 32 itself may round to either side
    EXPECT_NEAR(t.rotational_drag_Nms, expected,
                (std::fabs(re - 32.0) < seam ? 2e-3 : kRounding) * expected)
        << re;
    const Vec3 torque = test::total_torque_Nm(t, argon(), p);
    EXPECT_NEAR(torque[1], -t.rotational_drag_Nms * spin, kRounding * expected * (spin + 1));
    EXPECT_LE(dot(torque, p.spin_rad_s), 0.0) << "must brake";
  }
  const auto torque_factor = forces::RotationalDrag::stokes_factor;
  constexpr double step = 0.002;  // the header states 0.16 %
  EXPECT_NEAR(torque_factor(32.0 * (1 + kRounding)), torque_factor(32.0), step);
  // A particle that turns with the fluid feels nothing.
  FluidState vortex = argon();
  vortex.velocity_curl_1_s = scaled(2.0, p.spin_rad_s);
  EXPECT_EQ(norm(test::total_torque_Nm(law->evaluate(vortex, p), vortex, p)), 0.0);
}

TEST(Lift, DoesNoWorkOnTheSlip) {
  const FluidState f = busy_fluid();
  const ParticleState p = busy_particle();
  const Vec3 slip = forces::slip_velocity_m_s(f, p);
  for (const char* name : {"saffman_mei", "magnus"}) {
    const Vec3 force = make_force(name)->evaluate(f, p).force_N;
    ASSERT_GT(norm(force), 0.0);
    EXPECT_NEAR(dot(force, slip), 0.0, kRounding * norm(force) * norm(slip)) << name;
  }
}

}  // namespace

namespace test {
AnalyticChecks other_force_checks() {
  return {{"pressure_gradient", check_pressure_gradient},
          {"viscous_stress", check_viscous_stress},
          {"buoyancy", check_buoyancy},
          {"virtual_mass", check_virtual_mass},
          {"saffman_mei", check_saffman_mei},
          {"magnus", check_magnus},
          {"rotational_drag", check_rotational_drag}};
}
}  // namespace test
}  // namespace powderlink
