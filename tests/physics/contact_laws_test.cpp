// SPDX-License-Identifier: GPL-3.0-or-later
// The small laws beside JKR: damping, friction load, Rayleigh time, Tabor parameter.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include "physics/contact/friction_load.h"
#include "physics/contact/jkr_law.h"
#include "physics/contact/normal_damping.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/contact/tabor_parameter.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using physics::JkrLaw;
using test::refuses;

constexpr double kRounding = 1e-13;  // of a few products and roots

/// Restitution of a sphere that hits a plate with the Hertz force and the damping of the law, from
/// first touch until the overlap is zero again.
double restitution_of_a_collision(double e, double modulus, double radius, double mass,
                                  double speed) {
  using State = std::array<double, 2>;  // overlap, its rate
  const double beta = physics::damping_ratio(e);
  const JkrLaw hertz(modulus, 0.0);
  const auto rhs = [&](const State& s, State& rate, double) {
    const double overlap = std::fmax(s[0], 0.0);
    const double root = hertz.first_root(overlap, radius);
    const double damping = physics::normal_damping_kg_s(beta, modulus, root * root, mass);
    rate = {s[1], -(hertz.force_N(root, radius) + damping * s[1]) / mass};
  };
  namespace ode = boost::numeric::odeint;
  ode::runge_kutta4<State> stepper;
  const double contact_time =
      2.87 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
  const double dt = contact_time / 20000;
  State s = {0.0, speed};
  State before = s;
  for (double t = 0; s[0] > 0.0 || t == 0.0; t += dt) {
    before = s;
    stepper.do_step(rhs, s, t, dt);
  }
  const double share = before[0] / (before[0] - s[0]);  // of the last step, to zero overlap
  return -(before[1] + share * (s[1] - before[1])) / speed;
}

TEST(NormalDamping, GivesBackTheRestitution) {
  // The damped Hertz contact with damping ~ delta^(1/4) maps onto the linear oscillator (Antypov
  // and Elliott 2011), so e is exact at any speed; what remains is the integrator at the kinks in
  // delta^(1/4) at both ends.
  constexpr double integrator = 2e-5;
  for (const double e : {0.2, 0.5, 0.7, 0.9, 0.99, 1.0}) {
    for (const double speed : {0.01, 3.0}) {
      EXPECT_NEAR(restitution_of_a_collision(e, 3.2e9, 23e-6, 4.07e-10, speed), e, integrator)
          << "speed " << speed;
    }
  }
}

TEST(NormalDamping, DampingRatioOfTheLinearOscillator) {
  for (const double e : {0.05, 0.3, 0.8, 0.999}) {
    const double beta = physics::damping_ratio(e);
    EXPECT_LT(beta, 0.0);
    EXPECT_NEAR(std::exp(JkrLaw::kPi * beta / std::sqrt(1 - beta * beta)), e, kRounding);
  }
  EXPECT_EQ(physics::damping_ratio(1.0), 0.0);
}

TEST(NormalDamping, CoefficientOfTheContact) {
  EXPECT_NEAR(physics::kTwoSqrtFiveSixths, 2 * std::sqrt(5.0 / 6.0), kRounding);
  const double beta = physics::damping_ratio(0.6);
  const double stiffness = 2 * 3e9 * 1e-6;
  const double expected = 2 * std::sqrt(5.0 / 6.0) * -beta * std::sqrt(stiffness * 4e-10);
  EXPECT_NEAR(physics::normal_damping_kg_s(beta, 3e9, 1e-6, 4e-10), expected, kRounding * expected);
  EXPECT_EQ(physics::normal_damping_kg_s(physics::damping_ratio(1.0), 3e9, 1e-6, 4e-10), 0.0);
}

TEST(NormalDamping, RefusesImpossibleRestitution) {
  for (const double bad : {0.0, -0.1, 1.0001, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(refuses([bad] { physics::damping_ratio(bad); }, "restitution coefficient"));
  }
}

TEST(FrictionLoad, IsCoulombWithoutAdhesionAndNeverVanishesWithIt) {
  EXPECT_EQ(physics::friction_load_N(3e-6, 0.0), 3e-6);
  const JkrLaw law(3.2e9, 17.0);
  const double radius = 23e-6;
  const double pull_off = law.pull_off_force_N(radius);
  const double a0 = law.equilibrium_contact_radius_m(radius);
  EXPECT_EQ(physics::friction_load_N(0.0, pull_off), 2 * pull_off);
  EXPECT_EQ(physics::friction_load_N(-pull_off, pull_off), pull_off);
  for (double y = -0.275; y < 2.0; y += 0.05) {
    const double force = law.force_N(law.first_root(y * a0 * a0 / radius, radius), radius);
    EXPECT_GE(physics::friction_load_N(force, pull_off), pull_off * (1 - kRounding)) << y;
  }
}

/// Speed of Rayleigh's surface wave over the shear wave's, from Rayleigh's own equation
/// (2 - q)^2 = 4 sqrt(1 - q) sqrt(1 - q k), q = (c/c_s)^2, k = (c_s/c_p)^2.
double rayleigh_speed_ratio(double nu) {
  const double k = (1 - 2 * nu) / (2 - 2 * nu);
  const auto f = [k](double q) {
    return (2 - q) * (2 - q) - 4 * std::sqrt(1 - q) * std::sqrt(1 - q * k);
  };
  boost::uintmax_t turns = 100;
  const auto root = boost::math::tools::toms748_solve(
      f, 0.5, 1.0, boost::math::tools::eps_tolerance<double>(40), turns);
  return std::sqrt(root.first);
}

TEST(RayleighTime, IsHalfTheWayAroundAtTheSpeedOfTheSurfaceWave) {
  // 0.8766 + 0.1631 nu is a straight line through the true speed ratio.
  constexpr double straight_line = 6e-3;
  for (const double nu : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const physics::Material m{"m", 2510.0, 7.3e10, nu};
    const double shear_wave = std::sqrt(m.youngs_modulus_Pa / (2 * (1 + nu)) / m.density_kg_m3);
    const double exact = JkrLaw::kPi * 25e-6 / (rayleigh_speed_ratio(nu) * shear_wave);
    EXPECT_NEAR(physics::rayleigh_time_s(25e-6, m), exact, straight_line * exact) << nu;
  }
}

TEST(RayleighTime, Scaling) {
  const physics::Material m{"m", 2510.0, 7.3e10, 0.2};
  physics::Material softer = m;
  softer.youngs_modulus_Pa /= 100;
  const double t = physics::rayleigh_time_s(25e-6, m);
  EXPECT_NEAR(physics::rayleigh_time_s(50e-6, m), 2 * t, kRounding * t);
  EXPECT_NEAR(physics::rayleigh_time_s(25e-6, softer), 10 * t, 10 * kRounding * t);
}

TEST(TaborParameter, ComparesTheNeckWithTheRangeOfTheForces) {
  const double radius = 23e-6, gamma = 0.05, modulus = 3.8e10;
  const double mu = physics::tabor_parameter(radius, gamma, modulus);
  // The neck at tear-off is some (R Gamma^2/E*^2)^(1/3) long.
  const JkrLaw law(modulus, gamma);
  const double neck = -law.tear_off_overlap_m(radius);
  const double per_length = 0.75 * std::cbrt(std::pow(2 * JkrLaw::kPi, 2) / 4);
  EXPECT_NEAR(mu, neck / (per_length * 0.3e-9), kRounding * mu);
  EXPECT_NEAR(physics::tabor_parameter(radius, gamma, modulus, 0.6e-9), mu / 2, kRounding * mu);
  EXPECT_NEAR(physics::tabor_parameter(8 * radius, gamma, modulus), 2 * mu, kRounding * mu);
}

TEST(TaborParameter, NamesTheTheory) {
  EXPECT_STREQ(physics::adhesion_theory(5.01), "JKR");
  EXPECT_STREQ(physics::adhesion_theory(1.0), "Maugis-Dugdale");
  EXPECT_STREQ(physics::adhesion_theory(0.09), "DMT");
}

}  // namespace
}  // namespace powderlink
