// SPDX-License-Identifier: GPL-3.0-or-later
// One settling and one spinning sphere: terminal velocities in print, the transient against the
// differential equation, and the stability and order of the semi-implicit step.
#include "liggghts_styles/couple_bridge/fluid_relaxation.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include "tests/physics/fluid_forces/force_cases.h"

namespace powderlink {
namespace {

using forces::FluidState;
using forces::ForceTerms;
using forces::ParticleState;
using forces::Vec3;
using test::argon;
using test::kRounding;
using test::make_force;
using test::steel;

/// Half a unit of the last digit that the source prints.
constexpr double kThreeDecimals = 0.0005;

ForceTerms settling_terms(const ParticleState& p) {
  static const auto drag = make_force("schiller_naumann");
  static const auto weight = make_force("buoyancy");
  ForceTerms t = drag->evaluate(argon(), p);
  t += weight->evaluate(argon(), p);
  return t;
}

ForceTerms settling_terms(double diameter, const Vec3& velocity) {
  ParticleState p = steel(diameter);
  p.velocity_m_s = velocity;
  return settling_terms(p);
}

double mass(double diameter) { return test::kSteelDensity * forces::volume_m3(steel(diameter)); }

double stokes_time(double diameter) {
  return mass(diameter) / (3 * forces::kPi * test::kArgonViscosity * diameter);
}

double terminal_speed(double diameter) {
  const auto net = [&](double speed) {
    ParticleState p = steel(diameter);
    p.velocity_m_s = {0, 0, -speed};
    return test::total_force_N(settling_terms(p), argon(), p)[2];
  };
  std::uintmax_t rounds = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      net, 0.0, 100.0, boost::math::tools::eps_tolerance<double>(50), rounds);
  return 0.5 * (bracket.first + bracket.second);
}

TEST(Settling, TerminalVelocitiesOfSteelInArgon) {
  const std::vector<std::pair<double, double>> printed = {
      {20e-6, 0.075}, {45e-6, 0.338}, {75e-6, 0.775}, {105e-6, 1.247}};
  for (const auto& [diameter, speed] : printed) {
    EXPECT_NEAR(terminal_speed(diameter), speed, kThreeDecimals) << diameter;
  }
}

using Step = std::function<Vec3(const Vec3& v, double diameter, double dt)>;

/// One step of fix couple/bridge.
Vec3 relaxed(const Vec3& v, const Vec3& fluid, double k, const Vec3& force, double mass,
             double dt) {
  const auto step = host::fluid_relaxation(k, fluid.data(), force.data(), mass, dt);
  return forces::sum(forces::scaled(step.a, v), {step.d[0], step.d[1], step.d[2]});
}
Vec3 exponential(const Vec3& v, double diameter, double dt) {
  const ForceTerms t = settling_terms(diameter, v);
  return relaxed(v, {}, t.drag_kg_s, t.force_N, mass(diameter), dt);
}
/// The drag coefficient taken anew at the velocity of half a step.
Vec3 exponential_midpoint(const Vec3& v, double diameter, double dt) {
  const ForceTerms t = settling_terms(diameter, exponential(v, diameter, 0.5 * dt));
  return relaxed(v, {}, t.drag_kg_s, t.force_N, mass(diameter), dt);
}

Vec3 run(const Step& step, Vec3 v, double diameter, double time, int steps) {
  for (int i = 0; i < steps; ++i) v = step(v, diameter, time / steps);
  return v;
}

/// Sideways throw into argon at rest: both components are coupled by the drag.
const Vec3 kThrow = {1.5, 0.0, 0.0};

Vec3 by_differential_equation(double diameter, double time) {
  using State = std::array<double, 3>;
  State v = kThrow;
  const auto rate = [&](const State& x, State& dxdt, double) {
    ParticleState p = steel(diameter);
    p.velocity_m_s = x;
    dxdt = forces::scaled(1 / mass(diameter), test::total_force_N(settling_terms(p), argon(), p));
  };
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(
      odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_dopri5<State>()), rate, v, 0.0,
      time, 1e-3 * time);
  return v;
}

TEST(SemiImplicitStep, ConvergesToTheTransientWithItsOrder) {
  const double diameter = 105e-6;
  const double time = 0.5 * stokes_time(diameter);
  const Vec3 exact = by_differential_equation(diameter, time);
  struct Scheme {
    const char* name;
    Step step;
    double order;
  };
  for (const Scheme& s :
       {Scheme{"exponential", exponential, 1}, Scheme{"midpoint", exponential_midpoint, 2}}) {
    const auto error = [&](int steps) {
      return forces::norm(forces::difference(run(s.step, kThrow, diameter, time, steps), exact));
    };
    constexpr double next_order = 0.06;  // with 100 steps the next order is a per cent or so
    EXPECT_NEAR(std::log2(error(100) / error(200)), s.order, next_order) << s.name;
    EXPECT_LT(error(200), (s.order > 1 ? 1e-5 : 5e-3) * forces::norm(exact)) << s.name;
  }
}

TEST(SemiImplicitStep, IsStableForAnyStep) {
  constexpr double converged = 1e-9;
  for (const double diameter : {1e-6, 20e-6, 105e-6}) {
    const double speed = terminal_speed(diameter);
    for (const double ratio : {1.0, 10.0, 1e3, 1e9}) {
      const double dt = ratio * stokes_time(diameter);
      Vec3 v = kThrow;
      // With K of the start the step ends between rest and Stokes's terminal velocity.
      const double bound = stokes_time(diameter) * test::kGravity;
      for (int i = 0; i < 200; ++i) {
        v = exponential(v, diameter, dt);
        EXPECT_LE(-v[2], bound * (1 + kRounding));
        EXPECT_GE(-v[2], 0.0);
        EXPECT_LE(std::fabs(v[0]), kThrow[0]);
      }
      EXPECT_NEAR(-v[2], speed, converged * speed) << diameter << " m, dt/tau " << ratio;
    }
  }
}

TEST(SemiImplicitStep, NeverOvershootsWithTheCoefficientHeld) {
  const Vec3 fluid = {2.0, -1.0, 0.5}, start = {-3.0, 4.0, 0.0};
  const double k = 1e-8, m = 1e-11;
  for (const double x : {1e-12, 1e-3, 1.0, 50.0, 1e12}) {
    const double dt = x * m / k;
    const Vec3 v = relaxed(start, fluid, k, {}, m, dt);
    for (std::size_t i = 0; i < 3; ++i) {
      const double left = (v[i] - fluid[i]) / (start[i] - fluid[i]);
      EXPECT_GE(left, -kRounding);
      EXPECT_LE(left, 1.0 + kRounding);
    }
  }
}

TEST(SemiImplicitStep, WithoutDragIsNewton) {
  const Vec3 v = {1.0, 2.0, 3.0}, force = {-2e-9, 0.0, 5e-9};
  const Vec3 expected = forces::sum(v, forces::scaled(0.01 / 1e-9, force));
  const Vec3 now = relaxed(v, {9, 9, 9}, 0.0, force, 1e-9, 0.01);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(now[i], expected[i], kRounding);
}

TEST(Spinning, RelativeSpinDecaysExponentially) {
  // Stokes: tau_r = I/(pi mu d^3) = rho_p d^2/(60 mu); the exponential step is exact for any dt.
  const auto law = make_force("rotational_drag");
  FluidState f = argon();
  f.velocity_curl_1_s = {40.0, 0.0, -60.0};
  const Vec3 rest = forces::scaled(0.5, f.velocity_curl_1_s);
  ParticleState p = steel();
  p.spin_rad_s = {100.0, 250.0, 0.0};
  const double d = p.diameter_m;
  const double inertia = mass(d) * d * d / 10;
  const double tau = test::kSteelDensity * d * d / (60 * test::kArgonViscosity);
  const Vec3 start = forces::difference(p.spin_rad_s, rest);
  double energy = forces::dot(start, start), time = 0.0;
  for (const double part : {0.01, 0.3, 1.0, 2.0}) {
    const ForceTerms t = law->evaluate(f, p);
    ASSERT_GE(forces::dot(test::total_torque_Nm(t, f, p), forces::slip_spin_rad_s(f, p)), 0.0);
    p.spin_rad_s =
        relaxed(p.spin_rad_s, rest, t.rotational_drag_Nms, t.torque_Nm, inertia, part * tau);
    time += part;
    const Vec3 left = forces::difference(p.spin_rad_s, rest);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(left[i], start[i] * std::exp(-time), kRounding * forces::norm(start));
    }
    EXPECT_LT(forces::dot(left, left), energy) << "the relative spin must lose energy";
    energy = forces::dot(left, left);
  }
}

}  // namespace
}  // namespace powderlink
