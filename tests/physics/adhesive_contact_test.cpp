// SPDX-License-Identifier: GPL-3.0-or-later
// A contact with memory: hysteresis of JKR, roughness, and the moving edge of a rate-dependent
// interface against an integration of its differential equation.
#include "physics/effects/adhesive_contact.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <boost/numeric/odeint.hpp>

#include "physics/effects/effect_registry.h"

namespace powderlink {
namespace {

using physics::AdhesiveContact;
using physics::Effect;
using physics::JkrLaw;
using physics::make_effect;

constexpr double kRounding = 1e-12;
constexpr double kRadius = 23e-6;
constexpr double kModulus = 3.25e9;
constexpr double kGamma = 0.1;

const JkrLaw kSmooth(kModulus, kGamma);

double rest_radius() { return kSmooth.equilibrium_contact_radius_m(kRadius); }
double unit_overlap() { return rest_radius() * rest_radius() / kRadius; }

/// A contact with the effects that it needs alive beside it.
struct Contact {
  std::vector<std::unique_ptr<Effect>> owned;
  AdhesiveContact contact;
  JkrLaw law;

  explicit Contact(const std::vector<std::pair<std::string, std::vector<double>>>& effects = {},
                   const JkrLaw& smooth = kSmooth) {
    std::vector<const Effect*> used;
    for (const auto& [name, parameters] : effects) {
      owned.push_back(make_effect(name, parameters));
      used.push_back(owned.back().get());
    }
    contact = AdhesiveContact(smooth, used);
    law = contact.law(kRadius);
  }
  double advance(double overlap, double root, double dt) const {
    return contact.advance(law, overlap, kRadius, root, dt);
  }
  double force(double overlap, double root) const {
    return contact.force_N(law, overlap, kRadius, root);
  }
};

Contact rate(double v_star, double exponent, const JkrLaw& smooth = kSmooth) {
  return Contact({{"rate_dependent_adhesion", {v_star, exponent}}}, smooth);
}

TEST(AdhesiveContact, WithoutEffectsIsTheJkrPath) {
  const Contact c;
  EXPECT_FALSE(c.contact.rate_dependent());
  const double pull_off = kSmooth.pull_off_force_N(kRadius);
  double root = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double y = i <= 200 ? 0.01 * i : 2.0 - 0.0113 * (i - 200);  // in, then out to -0.26
    const double overlap = y * unit_overlap();
    root = c.advance(overlap, root, 1e-9);
    const double cold = kSmooth.first_root(overlap, kRadius);
    ASSERT_NEAR(root, cold, kRounding * cold) << y;
    ASSERT_NEAR(c.force(overlap, root), kSmooth.force_N(cold, kRadius), kRounding * 10 * pull_off)
        << y;
  }
}

TEST(AdhesiveContact, StartsAtTouchAndEndsAtTearOff) {
  const double tear_off = kSmooth.tear_off_overlap_m(kRadius);
  for (const Contact& c : {Contact(), rate(1.0, 0.6), Contact({{"surface_roughness", {1e-5}}})}) {
    double root = 0.0;
    for (const double gap : {10.0, 0.27, 0.1, 1e-3, 1e-12}) {  // approaching: the gap stays empty
      root = c.advance(-gap * unit_overlap(), root, 1e-9);
      EXPECT_EQ(root, 0.0) << gap;
    }
    root = c.advance(0.0, root, 1e-9);
    const double a_touch = std::cbrt(4.0 / 9.0) * c.law.equilibrium_contact_radius_m(kRadius);
    EXPECT_NEAR(root * root, a_touch, kRounding * a_touch);
    EXPECT_NEAR(c.force(0.0, root), -8.0 / 9.0 * c.law.pull_off_force_N(kRadius),
                kRounding * kSmooth.pull_off_force_N(kRadius));
  }
  const Contact c;
  constexpr double margin = 1e-9;
  double root = c.advance(0.0, 0.0, 1e-9);
  root = c.advance(tear_off * (1 - margin), root, 1e-9);
  EXPECT_GT(root, 0.0) << "the neck must hold until tear-off";
  EXPECT_EQ(c.advance(tear_off * (1 + margin), root, 1e-9), 0.0);
  EXPECT_EQ(c.advance(-0.1 * unit_overlap(), 0.0, 1e-9), 0.0) << "a broken neck does not come back";
  EXPECT_GT(c.advance(0.0, 0.0, 1e-9), 0.0) << "a second touch does";
}

TEST(AdhesiveContact, RoughnessIsJkrWithLessAdhesion) {
  const double asperity = 3e-6;
  const Contact c({{"surface_roughness", {asperity}}});
  const JkrLaw weaker(kModulus, kGamma / (1 + kRadius / asperity));
  const double a0 = weaker.equilibrium_contact_radius_m(kRadius);
  double root = 0.0;
  for (double y = 0.0; y > -0.27; y -= 0.01) {
    const double overlap = y * a0 * a0 / kRadius;
    root = c.advance(overlap, root, 1e-9);
    const double expected = weaker.force_N(weaker.first_root(overlap, kRadius), kRadius);
    EXPECT_NEAR(c.force(overlap, root), expected, kRounding * 10 * weaker.pull_off_force_N(kRadius))
        << y;
  }
  EXPECT_EQ(c.advance(1.0001 * weaker.tear_off_overlap_m(kRadius), root, 1e-9), 0.0);
}

/// A pull at constant speed from rest.
struct Pull {
  double speed_m_s = 0.05;
  double duration_s;
  explicit Pull(double last_y = -0.2)
      : duration_s((1.0 / 3.0 - last_y) * unit_overlap() / speed_m_s) {}
  double overlap(double t) const { return unit_overlap() / 3.0 - speed_m_s * t; }
};

/// Contact radius at the end of the pull, by backward Euler in n steps.
double pulled_radius(const Contact& c, const Pull& pull, int n) {
  double root = std::sqrt(rest_radius());
  for (int i = 1; i <= n; ++i) {
    root = c.advance(pull.overlap(pull.duration_s * i / n), root, pull.duration_s / n);
  }
  return root * root;
}

/// The same from da/dt = -v* (G/Gamma - 1)^(1/n), by an explicit method of high order. Lengths in
/// a0 and times in the duration of the pull.
double integrated_radius(const Pull& pull, double v_star, double exponent) {
  namespace ode = boost::numeric::odeint;
  const double a0 = rest_radius();
  const auto rhs = [&](const double& x, double& slope, double t) {
    const double a = x * a0;
    const double misfit = a * a / kRadius - pull.overlap(t * pull.duration_s);
    const double release = kModulus * misfit * misfit / (2 * JkrLaw::kPi * a);
    const double excess = std::fmax(release / kGamma - 1, 0.0);
    slope = -v_star * std::pow(excess, 1 / exponent) * pull.duration_s / a0;
  };
  double x = 1.0;
  constexpr double integrator = 1e-12;
  ode::integrate_adaptive(
      ode::make_controlled(integrator, integrator, ode::runge_kutta_dopri5<double>()), rhs, x, 0.0,
      1.0, 1e-3);
  return x * a0;
}

TEST(RateDependentContact, EdgeConvergesToItsDifferentialEquation) {
  constexpr double order_error = 0.1;    // of the slope between 400 and 1600 steps
  constexpr double extrapolated = 2e-5;  // what Richardson's rule leaves of a first-order error
  for (const auto& [v_star, exponent] :
       std::vector<std::pair<double, double>>{{1.0, 0.6}, {0.2, 1.0}, {3.0, 0.3}}) {
    SCOPED_TRACE("v* = " + std::to_string(v_star));
    const Contact c = rate(v_star, exponent);
    const Pull pull;
    const double exact = integrated_radius(pull, v_star, exponent);
    EXPECT_LT(exact, 0.99 * rest_radius()) << "the pull must move the edge";
    EXPECT_GT(exact, std::pow(kSmooth.first_root(pull.overlap(pull.duration_s), kRadius), 2))
        << "a dissipating edge lags behind";
    const double coarse = pulled_radius(c, pull, 400) - exact;
    const double fine = pulled_radius(c, pull, 1600) - exact;
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 1.0, order_error);
    EXPECT_NEAR((4 * fine - coarse) / 3, 0.0, extrapolated * rest_radius());
  }
}

TEST(RateDependentContact, AnEdgeWithoutDissipationIsJkr) {
  // (v/v*)^2 with v* = 1e6 m/s leaves 1e-10 of Gamma.
  constexpr double residual_dissipation = 1e-8;
  const Contact c = rate(1e6, 2.0);
  const double dt = 1e-9;
  double root = std::sqrt(rest_radius());
  for (double y = 0.33; y > -0.27; y -= 0.01) {
    const double overlap = y * unit_overlap();
    root = c.advance(overlap, root, dt);
    const double jkr = kSmooth.first_root(overlap, kRadius);
    ASSERT_NEAR(root, jkr, residual_dissipation * jkr) << y;
    ASSERT_NEAR(c.force(overlap, root), kSmooth.force_N(jkr, kRadius),
                residual_dissipation * kSmooth.pull_off_force_N(kRadius))
        << y;
  }
  // The last state before and the first after tear-off, a thousandth apart.
  const double tear_off = kSmooth.tear_off_overlap_m(kRadius);
  root = c.advance(0.999 * tear_off, root, dt);
  EXPECT_GT(root, 0.0);
  EXPECT_EQ(c.advance(1.001 * tear_off, root, dt), 0.0);
}

TEST(RateDependentContact, AVerySlowEdgeHolds) {
  // v* = 1e-6 m/s, n = 1: the edge runs at most v* (G/Gamma - 1) for the whole pull.
  const double v_star = 1e-6;
  const Contact c = rate(v_star, 1.0);
  const Pull pull(-3.0);  // far beyond JKR's tear-off
  const double a = pulled_radius(c, pull, 300);
  const double overlap = pull.overlap(pull.duration_s);
  const double most = energy_release_rate_J_m2(kSmooth, rest_radius(), overlap, kRadius) / kGamma;
  EXPECT_LE(a, rest_radius());
  EXPECT_GE(a, rest_radius() - v_star * most * pull.duration_s);
  // Held edge: a flat punch on top of the rest state, whose force is zero.
  const double punch = 2 * kModulus * rest_radius() * (overlap - unit_overlap() / 3);
  constexpr double edge_moved = 1e-4;
  EXPECT_NEAR(c.force(overlap, std::sqrt(a)), punch, edge_moved * std::fabs(punch));
}

TEST(RateDependentContact, DissipationDelaysTheBreak) {
  const auto overlap_at_break = [](const Contact& c) {
    const Pull pull(-20.0);
    const int n = 20000;
    double root = std::sqrt(rest_radius());
    for (int i = 1; i <= n; ++i) {
      const double overlap = pull.overlap(pull.duration_s * i / n);
      root = c.advance(overlap, root, pull.duration_s / n);
      if (root == 0.0) return overlap / unit_overlap();
    }
    return -20.0;
  };
  const double none = overlap_at_break(Contact());
  const double some = overlap_at_break(rate(10.0, 0.6));
  const double more = overlap_at_break(rate(0.3, 0.6));
  EXPECT_NEAR(none, -0.2751606, 20.0 / 20000 * 1.1);  // one step late at most
  EXPECT_LT(some, none);
  EXPECT_LT(more, some);
  EXPECT_GT(more, -20.0) << "the neck must break in the end";
}

TEST(RateDependentContact, LoadingFollowsTheEquilibriumAtAnySpeed) {
  // Also where one step pushes the surfaces further in than the neck reaches (weak adhesion).
  for (const double gamma : {0.1, 1e-3, 1e-6}) {
    const JkrLaw law(kModulus, gamma);
    const Contact c = rate(1.0, 0.6, law);
    for (const double step : {1e-12, 1e-10, 1e-9, 1e-8}) {
      double root = c.advance(0.0, 0.0, 1e-9);
      for (int i = 1; i <= 20; ++i) {
        root = c.advance(i * step, root, 1e-9);
        const double equilibrium = law.first_root(i * step, kRadius);
        ASSERT_NEAR(root, equilibrium, kRounding * equilibrium)
            << "Gamma " << gamma << " step " << step;
      }
    }
  }
}

TEST(RateDependentContact, WithoutAdhesionIsHertz) {
  const JkrLaw hertz(kModulus, 0.0);
  const Contact c = rate(1.0, 0.6, hertz);
  double root = 0.0;
  for (const double overlap : {1e-9, 2e-9, 5e-9, 2e-9, 1e-9, 1e-10}) {
    root = c.advance(overlap, root, 1e-9);
    const double expected = 4.0 / 3.0 * kModulus * std::sqrt(kRadius) * std::pow(overlap, 1.5);
    EXPECT_NEAR(c.force(overlap, root), expected, kRounding * expected) << overlap;
  }
  EXPECT_EQ(c.advance(-1e-12, root, 1e-9), 0.0);
}

TEST(RateDependentContact, NoTimeNoRecession) {
  const Contact c = rate(1.0, 0.6);
  const double root = std::sqrt(rest_radius());
  EXPECT_EQ(c.advance(0.1 * unit_overlap(), root, 0.0), root);
}

}  // namespace
}  // namespace powderlink
