// SPDX-License-Identifier: GPL-3.0-or-later
// Whole collisions: restitution, depth and duration of the damped Hertz contact and of that of
// OpenFOAM's clouds, integrated beside their closed forms; adhesion that goes with a lowered modulus.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "physics/contact/hertz_collision.h"
#include "physics/contact/jkr_law.h"
#include "physics/contact/material.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/contact/softened_adhesion.h"
#include "physics/contact/spring_slider_dashpot.h"
#include "physics/kat/kat_theory.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using physics::HertzCollision;
using physics::JkrLaw;
using test::refuses;

constexpr double kRounding = 1e-13;    // of a few products and roots
constexpr double kQuadrature = 1e-12;  // of Boost's tanh-sinh rule at the end x^(-1/5)

struct Outcome {
  double restitution, greatest_overlap_m, duration_s;
};

/// The equation of motion with OpenFOAM's force, from first touch until the overlap is 0 again.
Outcome integrate(const HertzCollision& c, double alpha) {
  using State = std::array<double, 2>;  // overlap, its rate
  const auto rhs = [&](const State& s, State& rate, double) {
    rate = {s[1], -physics::spring_slider_dashpot_force_N(s[0], s[1], c.modulus_Pa, c.radius_m,
                                                          c.mass_kg, alpha) /
                      c.mass_kg};
  };
  constexpr int steps = 40000;
  const double dt =
      HertzCollision{c.modulus_Pa, c.radius_m, c.mass_kg, c.speed_m_s}.duration_s() / steps;
  boost::numeric::odeint::runge_kutta4<State> stepper;
  State s = {0.0, c.speed_m_s}, before = s;
  Outcome out{0.0, 0.0, 0.0};
  int n = 0;
  for (; s[0] > 0.0 || n == 0; ++n) {
    before = s;
    stepper.do_step(rhs, s, n * dt, dt);
    out.greatest_overlap_m = std::fmax(out.greatest_overlap_m, s[0]);
  }
  const double part = before[0] / (before[0] - s[0]);  // of the last step, to zero overlap
  out.restitution = -(before[1] + part * (s[1] - before[1])) / c.speed_m_s;
  out.duration_s = (n - 1 + part) * dt;
  return out;
}

constexpr double kIntegrator = 2e-5;  // fixed steps over the kinks in delta^(1/4) at both ends

TEST(SpringSliderDashpot, RestitutionDepthAndDurationOfACollision) {
  for (const double alpha : {0.0, 0.07495, 0.12, 0.5, 1.5}) {
    for (const double speed : {0.01, 3.0}) {
      const HertzCollision c{1.16e7, 33e-6, 1.2e-9, speed, physics::damping_ratio_of_alpha(alpha)};
      const Outcome o = integrate(c, alpha);
      EXPECT_NEAR(o.restitution, physics::restitution_of_alpha(alpha), kIntegrator) << alpha;
      EXPECT_NEAR(o.greatest_overlap_m / c.greatest_overlap_m(), 1.0, kIntegrator) << alpha;
      EXPECT_NEAR(o.duration_s / c.duration_s(), 1.0, kIntegrator) << alpha;
    }
  }
}

TEST(SpringSliderDashpot, AlphaAndRestitutionAreInverse) {
  for (const double e : {0.05, 0.3, 0.845, 0.9, 0.999, 1.0}) {
    EXPECT_NEAR(physics::restitution_of_alpha(physics::alpha_of_restitution(e)), e, kRounding);
  }
  // What the thesis prints as one pair, restitution 0.9 and alpha 0.12, are two contacts.
  constexpr double last_digit = 5e-5;
  EXPECT_NEAR(physics::restitution_of_alpha(0.12), 0.8446, last_digit);
  EXPECT_NEAR(physics::alpha_of_restitution(0.9), 0.07495, last_digit);
  EXPECT_EQ(physics::restitution_of_alpha(0.0), 1.0);
}

TEST(SpringSliderDashpot, DampsAsLiggghtsDoes) {
  constexpr double modulus = 1.16e7, radius = 33e-6, mass = 1.2e-9;
  const JkrLaw hertz(modulus, 0.0);
  for (const double e : {0.2, 0.845, 0.99}) {
    const double alpha = physics::alpha_of_restitution(e);
    for (const double overlap : {1e-9, 1e-7, 3e-6}) {
      const double root = hertz.first_root(overlap, radius);
      const double force =
          hertz.force_N(root, radius) +
          0.4 * physics::normal_damping_kg_s(physics::damping_ratio(e), modulus, root * root, mass);
      EXPECT_NEAR(
          physics::spring_slider_dashpot_force_N(overlap, 0.4, modulus, radius, mass, alpha) /
              force,
          1.0, 10 * kRounding);
    }
  }
  EXPECT_EQ(physics::spring_slider_dashpot_force_N(0.0, -1.0, modulus, radius, mass, 0.12), 0.0);
}

TEST(SpringSliderDashpot, RefusesWhatNeverParts) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-0.01, physics::kSqrtFive, 3.0, nan}) {
    EXPECT_TRUE(refuses([bad] { physics::restitution_of_alpha(bad); }, "alpha", number_text(bad)));
  }
  // Just below, a grain keeps next to nothing.
  EXPECT_LT(physics::restitution_of_alpha(2.2), 1e-6);
  for (const double bad : {0.0, 1.1, nan}) {
    EXPECT_TRUE(refuses([bad] { physics::alpha_of_restitution(bad); }, "restitution"));
  }
}

TEST(SpringSliderDashpot, OwnTimeOfACollision) {
  // The clouds' own estimate, beside the duration: it must scale in the same way, and is 7 % long
  // for a sphere on a plate.
  const double density = 7980.0, modulus = 1.16e7;
  for (const double radius : {20e-6, 50e-6}) {
    for (const double speed : {0.1, 10.0}) {
      const HertzCollision c{modulus, radius, physics::sphere_mass_kg(radius, density), speed};
      const double ratio =
          physics::spring_slider_dashpot_time_s(radius, density, modulus, speed) / c.duration_s();
      const double pi = JkrLaw::kPi;
      const double exact = 2.94327518432 * std::pow(1.25 * pi, 0.4);
      EXPECT_NEAR(ratio, 5.429675 / exact, 1e-10);
    }
  }
}

/// Mean force over one cycle of the slider at a steady load, in closed form.
double cycle_force_N(const physics::SliderLoad& load, double speed_m_s, double step_s) {
  const double growth = load.stiffness_N_m * speed_m_s * step_s;
  const double n = std::floor(load.limit_N / growth) + 1.0;
  return (growth * n * (n - 1.0) / 2.0 + (n - 1.0) * load.damping_kg_s * speed_m_s + load.limit_N) /
         n;
}

TEST(Slider, SteadySlipFollowsTheCycle) {
  const physics::SliderLoad load{50.0, 3e-5, 2e-5};
  const double step = 7e-8;
  for (const double speed : {0.02, 0.3, 1.1, 5.9}) {
    const int n =
        static_cast<int>(std::floor(load.limit_N / (load.stiffness_N_m * speed * step)) + 1.0);
    constexpr int cycles = 3;
    double spring[3] = {0, 0, 0}, force[3], sum[3] = {0, 0, 0};
    const double slip[3] = {0.6 * speed, 0.0, -0.8 * speed};
    for (int i = 0; i < cycles * n; ++i) {
      physics::advance_slider(load, slip, step, 1, spring, force);
      for (int k = 0; k < 3; ++k) sum[k] += force[k] / (cycles * n);
    }
    const double mean = cycle_force_N(load, speed, step);
    EXPECT_NEAR(sum[0] / mean, -0.6, n * kRounding) << n;
    EXPECT_EQ(sum[1], 0.0);
    EXPECT_NEAR(sum[2] / mean, 0.8, n * kRounding) << n;
    // All of it at once is the mean of its steps.
    double emptied[3] = {0, 0, 0};
    physics::advance_slider(load, slip, cycles * n * step, cycles * n, emptied, force);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(force[k], sum[k], n * kRounding * mean);
  }
}

TEST(Slider, CoulombsLawWhereEachStepSlidesAndViscousInTheLimit) {
  const physics::SliderLoad load{50.0, 3e-5, 2e-5};
  const double slip[3] = {0.3, 0.0, 0.0};
  double spring[3] = {0, 0, 0}, force[3];
  const double full = load.limit_N / (load.stiffness_N_m * slip[0]);  // time to fill the spring
  for (int i = 0; i < 5; ++i) {
    physics::advance_slider(load, slip, 1.01 * full, 1, spring, force);
    EXPECT_EQ(force[0], -load.limit_N);
    EXPECT_EQ(spring[0], 0.0);
  }
  // mu F_n/2 + eta v, reached with the first order of the step.
  const double limit = load.limit_N / 2 + load.damping_kg_s * slip[0];
  double error[2];
  for (const int fine : {0, 1}) {
    const double parts = fine == 1 ? 2000 : 1000;
    error[fine] = cycle_force_N(load, slip[0], 1.0000001 * full / parts) / limit - 1.0;
  }
  EXPECT_LT(std::fabs(error[1]), 1e-3);
  EXPECT_NEAR(error[0] / error[1], 2.0, 0.01);
}

TEST(Slider, SticksWhileTheSpringHolds) {
  const physics::SliderLoad load{50.0, 3e-5, 2e-5};
  double spring[3] = {3e-7, 0.0, 0.0}, force[3];  // below 2e-5/50
  const double rest[3] = {0, 0, 0};
  physics::advance_slider(load, rest, 1e-7, 5, spring, force);
  EXPECT_NEAR(force[0], -load.stiffness_N_m * 3e-7, kRounding * load.limit_N);
  EXPECT_EQ(spring[0], 3e-7);
  // A contact that loses its load gives way, and without a slip pulls nowhere.
  physics::advance_slider({50.0, 0.0, 1e-6}, rest, 1e-7, 1, spring, force);
  EXPECT_EQ(force[0], 0.0);
  EXPECT_EQ(spring[0], 0.0);
}

TEST(HertzCollision, UndampedFactor) {
  const HertzCollision c{3.2e9, 23e-6, 4.07e-10, 0.7};
  const double factor =
      0.8 * boost::math::constants::root_pi<double>() * boost::math::tgamma_delta_ratio(0.4, 0.5);
  EXPECT_NEAR(factor, 2.94327518432, 5e-12);
  EXPECT_NEAR(c.duration_s() * c.speed_m_s / c.greatest_overlap_m(), factor, kQuadrature * factor);
  // All of the energy is in the spring at the greatest overlap.
  const double spring =
      8.0 / 15.0 * c.modulus_Pa * std::sqrt(c.radius_m) * std::pow(c.greatest_overlap_m(), 2.5);
  const double energy = 0.5 * c.mass_kg * c.speed_m_s * c.speed_m_s;
  EXPECT_NEAR(spring, energy, 10 * kRounding * energy);
}

TEST(HertzCollision, Scaling) {
  const HertzCollision c{3.2e9, 23e-6, 4.07e-10, 0.7, 0.05};
  HertzCollision softer = c;
  softer.modulus_Pa /= 1e4;
  const double longer = std::pow(1e4, 0.4);
  EXPECT_NEAR(softer.duration_s() / c.duration_s(), longer, kQuadrature * longer);
  EXPECT_NEAR(softer.greatest_overlap_m() / c.greatest_overlap_m(), longer, kQuadrature * longer);
  HertzCollision faster = c;
  faster.speed_m_s *= 32;
  EXPECT_NEAR(faster.duration_s() / c.duration_s(), 0.5, kQuadrature);
}

TEST(HertzCollision, GrainOfTheSourcesPipe) {
  // Steel grains of 66.9 um at E = 2.11e7 Pa on the same: how deep a grain sinks in. By hand, to
  // the printed digit.
  const physics::Material m{"soft", 7980.0, 2.11e7, 0.3};
  const double modulus = physics::effective_youngs_modulus_Pa(m, m), radius = 33.45e-6;
  const double mass = physics::sphere_mass_kg(radius, m.density_kg_m3);
  const auto depth = [&](double speed) {
    return HertzCollision{modulus, radius, mass, speed}.greatest_overlap_m() / (2 * radius);
  };
  EXPECT_NEAR(depth(1.0), 0.047, 5e-4);
  EXPECT_NEAR(depth(0.2), 0.013, 5e-4);
  EXPECT_NEAR(physics::rayleigh_time_s(20e-6, m), 2.13e-6, 5e-9);
}

TEST(SoftenedAdhesion, KeepsTheWorkAndTheSpeedOfSticking) {
  constexpr double gamma = 0.1, modulus = 1.16e11, softened = 1.16e7, radius = 33e-6;
  const JkrLaw real(modulus, gamma);
  const JkrLaw soft(softened, physics::softened_adhesion_J_m2(gamma, modulus, softened));
  EXPECT_NEAR(
      physics::touch_and_go_work_J(soft, radius) / physics::touch_and_go_work_J(real, radius), 1.0,
      1e-9);  // roots of a quartic at tear-off, where its slope is 0
  EXPECT_EQ(physics::softened_adhesion_J_m2(gamma, modulus, modulus), gamma);
  const double lambda = std::pow(modulus / softened, 0.4);
  EXPECT_NEAR(soft.pull_off_force_N(radius) * lambda / real.pull_off_force_N(radius), 1.0,
              kRounding);
  // Unchanged adhesion would stick up to a higher speed: work ~ E*^(-2/3).
  const JkrLaw unchanged(softened, gamma);
  EXPECT_NEAR(
      physics::touch_and_go_work_J(unchanged, radius) / physics::touch_and_go_work_J(real, radius),
      std::pow(modulus / softened, 2.0 / 3.0), 1e-6);
}

TEST(SoftenedAdhesion, AllLengthsGrowAndAllForcesFallByTheSameFactor) {
  constexpr double gamma = 0.1, modulus = 1.16e11, softened = 1.16e7, radius = 33e-6;
  const JkrLaw real(modulus, gamma);
  const JkrLaw soft(softened, physics::softened_adhesion_J_m2(gamma, modulus, softened));
  const double lambda = std::pow(modulus / softened, 0.4);
  const double tear_off = real.tear_off_overlap_m(radius);
  EXPECT_NEAR(soft.tear_off_overlap_m(radius) / tear_off, lambda, 1e-12 * lambda);
  // In the neck and in overlap; not at tear-off itself, where the root is double.
  for (const double y : {0.95, 0.5, -0.5, -3.0, -30.0}) {
    const double force = real.force_N(real.first_root(y * tear_off, radius), radius);
    const double softened_force =
        soft.force_N(soft.first_root(y * lambda * tear_off, radius), radius);
    EXPECT_NEAR(softened_force * lambda / force, 1.0, 1e-9) << y;
  }
}

}  // namespace
}  // namespace powderlink
