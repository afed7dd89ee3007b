// SPDX-License-Identifier: GPL-3.0-or-later
// JkrLaw against the closed form of its universal quartic in 50 digits, the fixed points of the
// theory, conservation of energy and the scaling of the law.
#include "physics/contact/jkr_law.h"
#include "physics/contact/jkr_edge.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "physics/kat/kat_theory.h"
#include "tests/physics/jkr_reference.h"

namespace powderlink {
namespace {

using physics::JkrLaw;
using test::JkrReference;
using test::Real;

constexpr double kPi = JkrLaw::kPi;

// The contract of the law: relative error of the force over y = -0.27516 .. 1e4.
constexpr double kForceError = 1e-9;
// Around y = 1/3 the force is the difference of two terms of the size of the pull-off, each with a
// few roundings, so no relative error of the difference can be promised there.
constexpr double kCancellation = 1e-14;
// A handful of roundings of well-conditioned products and roots.
constexpr double kRounding = 1e-12;
// Double-exponential quadrature of a smooth integrand in double precision.
constexpr double kQuadrature = 1e-10;
// Largest relative distance between the constants 11.69, 7.09 and 1.0107 and their exact values:
// half a unit of the last printed digit of 7.09.
constexpr double kPrintedConstant = 0.005 / 7.09;

struct Pair {
  const char* name;
  double modulus_Pa, gamma_J_m2, radius_m;
};
const std::vector<Pair> kPairs = {
    {"316L on UPVC", 3.2476e9, 17.16, 23e-6},
    {"silanised glass", 3.8021e10, 0.09, 37.5e-6},
    {"soft and large", 1e6, 0.05, 1e-2},
    {"hard and small", 2e11, 1e-3, 0.5e-6},
};

JkrLaw law_of(const Pair& p) { return JkrLaw(p.modulus_Pa, p.gamma_J_m2); }
double unit_overlap(const Pair& p) {
  const double a0 = law_of(p).equilibrium_contact_radius_m(p.radius_m);
  return a0 * a0 / p.radius_m;
}

/// y from just above tear-off to 1e4, dense where the law is stiff.
std::vector<double> path_of_y(int n) {
  std::vector<double> y;
  for (int i = 0; i <= n; ++i) y.push_back(-0.27516 + 0.27516 * std::pow(double(i) / n, 2));
  for (int i = 1; i <= n; ++i) y.push_back(std::pow(10.0, -4.0 + 8.0 * i / n));
  return y;
}

::testing::AssertionResult force_matches(const Pair& p, const JkrReference& exact, double overlap,
                                         double root) {
  const Real f = law_of(p).force_N(root, p.radius_m);
  const Real want = exact.force(overlap);
  const auto error = static_cast<double>(abs(f - want));
  const auto allowed =
      static_cast<double>(kForceError * abs(want) + kCancellation * exact.pull_off());
  if (error <= allowed) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << p.name << ": delta R/a0^2 = " << overlap / unit_overlap(p) << ", force " << f
         << " N, exact " << want << " N, error over allowed " << error / allowed;
}

TEST(JkrReference, SolvesTheUniversalForm) {
  const Real allowed("1e-40");  // 50 digits, less the cancellation in the resolvent at y = 1e4
  for (const double y : path_of_y(200)) {
    const Real x = test::universal_radius(y);
    EXPECT_LT(abs(x * x - 2 * sqrt(x) / 3 - y), allowed * (1 + std::fabs(y))) << y;
    EXPECT_GT(x * x * x, Real(1) / 36) << "not the stable branch at y = " << y;
  }
}

TEST(JkrLaw, FixedPointsOfTheCurve) {
  for (const Pair& p : kPairs) {
    SCOPED_TRACE(p.name);
    const JkrLaw law = law_of(p);
    const JkrReference exact(p.modulus_Pa, p.gamma_J_m2, p.radius_m);
    const double a0 =
        std::cbrt(9 * kPi * p.gamma_J_m2 * p.radius_m * p.radius_m / (2 * p.modulus_Pa));
    const double unit = a0 * a0 / p.radius_m;
    const double pull_off = 1.5 * kPi * p.gamma_J_m2 * p.radius_m;
    EXPECT_NEAR(law.equilibrium_contact_radius_m(p.radius_m), a0, kRounding * a0);
    EXPECT_NEAR(law.pull_off_force_N(p.radius_m), pull_off, kRounding * pull_off);

    const double at_touch = law.first_root(0.0, p.radius_m);
    EXPECT_NEAR(at_touch * at_touch, std::cbrt(4.0 / 9.0) * a0, kRounding * a0);
    EXPECT_NEAR(law.force_N(at_touch, p.radius_m), -8.0 / 9.0 * pull_off, kRounding * pull_off);

    const double at_rest = law.first_root(unit / 3.0, p.radius_m);
    EXPECT_NEAR(at_rest * at_rest, a0, kRounding * a0);
    EXPECT_NEAR(law.force_N(at_rest, p.radius_m), 0.0, kRounding * pull_off);

    const double tear_off = law.tear_off_overlap_m(p.radius_m);
    EXPECT_NEAR(tear_off, static_cast<double>(exact.tear_off()), kRounding * unit);
    EXPECT_NEAR(tear_off / unit, -0.2751606, 0.5e-7);  // as printed
    // The root has a vertical tangent there: one rounding of delta moves it by its square root.
    constexpr double at_vertical_tangent = 1e-7;
    const double torn = law.next_root(tear_off, p.radius_m, at_rest);
    EXPECT_NEAR(torn * torn, a0 / std::cbrt(36.0), at_vertical_tangent * a0);
    EXPECT_NEAR(law.force_N(torn, p.radius_m), -5.0 / 9.0 * pull_off,
                at_vertical_tangent * pull_off);
  }
}

TEST(JkrLaw, PullOffIsTheLeastForceAndLiesAtItsContactRadius) {
  for (const Pair& p : kPairs) {
    SCOPED_TRACE(p.name);
    const JkrLaw law = law_of(p);
    const double a0 = law.equilibrium_contact_radius_m(p.radius_m);
    const double pull_off = 1.5 * kPi * p.gamma_J_m2 * p.radius_m;
    const double x = std::cbrt(0.25);
    const double y = x * x - 2.0 / 3.0 * std::sqrt(x);
    const double root = law.first_root(y * a0 * a0 / p.radius_m, p.radius_m);
    EXPECT_NEAR(root * root, x * a0, kRounding * a0);
    EXPECT_NEAR(law.force_N(root, p.radius_m), -pull_off, kRounding * pull_off);
    for (const double factor : {0.98, 0.999, 1.001, 1.02}) {
      EXPECT_GT(law.force_N(factor * root, p.radius_m), -pull_off) << factor;
    }
  }
}

TEST(JkrLaw, ForceFollowsTheClosedFormInSmallSteps) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const JkrReference exact(p.modulus_Pa, p.gamma_J_m2, p.radius_m);
    auto path = path_of_y(400);
    const auto back = path;
    path.insert(path.end(), back.rbegin(), back.rend());  // loading, then unloading
    double root = law.first_root(path.front() * unit_overlap(p), p.radius_m);
    for (const double y : path) {
      const double overlap = y * unit_overlap(p);
      root = law.next_root(overlap, p.radius_m, root);
      ASSERT_TRUE(force_matches(p, exact, overlap, root));
    }
  }
}

TEST(JkrLaw, ForceFollowsTheClosedFormInLargeSteps) {
  const auto path = path_of_y(400);
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const JkrReference exact(p.modulus_Pa, p.gamma_J_m2, p.radius_m);
    std::mt19937_64 generator(1);
    std::uniform_int_distribution<std::size_t> any(0, path.size() - 1);
    double root = law.first_root(0.0, p.radius_m);
    for (int i = 0; i < 400; ++i) {
      // Every fourth jump goes to one end of the range.
      const std::size_t k = i % 8 == 0 ? 0 : i % 8 == 4 ? path.size() - 1 : any(generator);
      const double overlap = path[k] * unit_overlap(p);
      root = law.next_root(overlap, p.radius_m, root);
      ASSERT_TRUE(force_matches(p, exact, overlap, root)) << "jump " << i;
    }
  }
}

TEST(JkrLaw, ForceOfAColdStart) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const JkrReference exact(p.modulus_Pa, p.gamma_J_m2, p.radius_m);
    for (const double y : path_of_y(400)) {
      const double overlap = y * unit_overlap(p);
      ASSERT_TRUE(force_matches(p, exact, overlap, law.first_root(overlap, p.radius_m)));
    }
  }
}

TEST(JkrLaw, ContactRadiusOfTheClosedForm) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const JkrReference exact(p.modulus_Pa, p.gamma_J_m2, p.radius_m);
    for (const double y : path_of_y(100)) {
      const double overlap = y * unit_overlap(p);
      const double root = law.first_root(overlap, p.radius_m);
      const auto a = static_cast<double>(exact.contact_radius(overlap));
      ASSERT_NEAR(root * root, a, kForceError * a) << p.name << " " << y;
      ASSERT_NEAR(law.overlap_m(root, p.radius_m), overlap,
                  kRounding * (std::fabs(overlap) + unit_overlap(p)));
    }
  }
}

TEST(JkrLaw, StateDependsOnTheOverlapAlone) {
  const Pair& p = kPairs[0];
  const JkrLaw law = law_of(p);
  for (const double y : path_of_y(20)) {
    const double overlap = y * unit_overlap(p);
    const double cold = law.first_root(overlap, p.radius_m);
    for (const double from : {-0.27516, -0.1, 0.0, 1.0 / 3.0, 10.0, 1e4}) {
      const double start = law.first_root(from * unit_overlap(p), p.radius_m);
      EXPECT_NEAR(law.next_root(overlap, p.radius_m, start), cold, kRounding * cold)
          << "from " << from << " to " << y;
    }
  }
}

TEST(JkrLaw, NeckThatReachedTheTearOffPointComesBack) {
  // At the tear-off point Newton's slope vanishes: the next step starts from there all the same.
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const double edge = law.tear_off_overlap_m(p.radius_m);
    const double tangent =
        std::cbrt(std::sqrt(2 * kPi * p.gamma_J_m2 / p.modulus_Pa) * p.radius_m / 4);
    for (const double closeness : {-1e-9, 0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
      for (const double y : {-0.2, 0.0, 1.0, 1e4}) {
        const double overlap = y * unit_overlap(p);
        const double cold = law.first_root(overlap, p.radius_m);
        EXPECT_NEAR(law.next_root(overlap, p.radius_m, tangent * (1 + closeness)), cold,
                    kRounding * cold)
            << p.name << " from " << edge << " (1 + " << closeness << ") to y = " << y;
      }
    }
  }
}

TEST(JkrLaw, TearsExactlyAtTheTearOffOverlap) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const auto edge =
        static_cast<double>(JkrReference(p.modulus_Pa, p.gamma_J_m2, p.radius_m).tear_off());
    constexpr double last_digits = 1e-14;  // some roundings of the coefficient of the cube
    EXPECT_FALSE(law.torn(edge * (1 - last_digits), p.radius_m)) << p.name;
    EXPECT_TRUE(law.torn(edge * (1 + last_digits), p.radius_m)) << p.name;
    EXPECT_FALSE(law.torn(0.0, p.radius_m)) << p.name;
    EXPECT_FALSE(law.torn(unit_overlap(p), p.radius_m)) << p.name;
    EXPECT_TRUE(law.torn(-1.0, p.radius_m)) << p.name;
  }
}

/// Work done on the contact from one overlap to another.
double work_by_quadrature(const JkrLaw& law, double radius, double from, double to) {
  boost::math::quadrature::tanh_sinh<double> integrator;
  const auto force = [&](double overlap) {
    return law.force_N(law.first_root(overlap, radius), radius);
  };
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  // Distances from the nearer end: delta near tear-off keeps its digits.
  const auto integrand = [&](double x, double complement) {
    return force(complement < 0 ? low - complement : complement > 0 ? high - complement : x);
  };
  return integrator.integrate(integrand, low, high) * (to > from ? 1 : -1);
}

TEST(JkrLaw, LoopEnergies) {
  for (const Pair& p : kPairs) {
    SCOPED_TRACE(p.name);
    const JkrLaw law = law_of(p);
    const double s = std::cbrt(std::pow(p.gamma_J_m2, 5) * std::pow(p.radius_m, 4) /
                               (p.modulus_Pa * p.modulus_Pa));
    const double scale = std::pow(2 * kPi, 5.0 / 3.0);
    const double detach =
        scale * (0.2 * std::pow(0.25, 4.0 / 3.0) + 0.3 * std::pow(1.5, 4.0 / 3.0));
    const double touch_and_go = scale * (0.2 * std::pow(0.25, 4.0 / 3.0) + 0.3);
    EXPECT_NEAR(detach, 11.69, 11.69 * kPrintedConstant);
    EXPECT_NEAR(touch_and_go, 7.09, 7.09 * kPrintedConstant);

    EXPECT_NEAR(physics::detachment_work_J(law, p.radius_m), detach * s, kRounding * detach * s);
    EXPECT_NEAR(physics::touch_and_go_work_J(law, p.radius_m), touch_and_go * s,
                kRounding * detach * s);

    const double tear_off = law.tear_off_overlap_m(p.radius_m);
    EXPECT_NEAR(work_by_quadrature(law, p.radius_m, unit_overlap(p) / 3.0, tear_off), detach * s,
                1e-8 * detach * s);
    EXPECT_NEAR(work_by_quadrature(law, p.radius_m, 0.0, tear_off), touch_and_go * s,
                1e-8 * detach * s);

    const double k = 4.0 / 3.0 * p.modulus_Pa;
    const double printed = 1.0107 * std::cbrt(9 * std::pow(kPi, 5) * std::pow(p.gamma_J_m2, 5) *
                                              std::pow(p.radius_m, 4) / (k * k));
    EXPECT_NEAR(detach * s, printed, 0.5e-4 * printed) << "1.0107 is printed with four decimals";
  }
}

TEST(JkrLaw, EnergyIsTheIntegralOfTheForce) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const double unit = unit_overlap(p);
    for (const auto& [from, to] : std::vector<std::pair<double, double>>{
             {0.0, 0.2}, {1.0 / 3.0, 5.0}, {-0.2, 1.0}, {5.0, 300.0}, {2.0, -0.25}}) {
      const auto energy = [&](double y) {
        return law.energy_J(law.first_root(y * unit, p.radius_m), p.radius_m);
      };
      const double work = work_by_quadrature(law, p.radius_m, from * unit, to * unit);
      const double size = std::fabs(energy(from)) + std::fabs(energy(to));
      EXPECT_NEAR(energy(to) - energy(from), work, kQuadrature * size)
          << p.name << " " << from << " " << to;
    }
  }
}

TEST(JkrLaw, NoAdhesionIsHertz) {
  const Pair& p = kPairs[1];
  const JkrLaw law(p.modulus_Pa, 0.0);
  EXPECT_FALSE(law.adhesive());
  EXPECT_EQ(law.pull_off_force_N(p.radius_m), 0.0);
  EXPECT_EQ(law.tear_off_overlap_m(p.radius_m), 0.0);
  EXPECT_EQ(law.force_N(law.first_root(0.0, p.radius_m), p.radius_m), 0.0);
  EXPECT_TRUE(law.torn(-1e-15, p.radius_m));
  double warm = law.first_root(1e-12, p.radius_m);
  for (const double overlap : {1e-12, 1e-10, 1e-8, 3e-8, 1e-6, 1e-7, 1e-9, 1e-11}) {
    const double hertz = 4.0 / 3.0 * p.modulus_Pa * std::sqrt(p.radius_m) * std::pow(overlap, 1.5);
    const double energy = 0.4 * hertz * overlap;
    warm = law.next_root(overlap, p.radius_m, warm);
    const double cold = law.first_root(overlap, p.radius_m);
    for (const double root : {warm, cold}) {
      EXPECT_NEAR(law.force_N(root, p.radius_m), hertz, kRounding * hertz);
      EXPECT_NEAR(law.energy_J(root, p.radius_m), energy, kRounding * energy);
    }
  }
}

TEST(JkrLaw, VanishingAdhesionTendsToHertz) {
  // Expanded at fixed overlap, the terms in sqrt(Gamma) of contact radius and force cancel:
  // F = F_Hertz - pi Gamma R* (1 + O(sqrt(Gamma))).
  const double modulus = 3.8e10, radius = 25e-6, overlap = 1e-8;
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
  const double contact = std::sqrt(radius * overlap);
  for (const double gamma : {1e-4, 1e-5, 1e-6, 1e-7}) {
    const JkrLaw law(modulus, gamma);
    const double force = law.force_N(law.first_root(overlap, radius), radius);
    const double next_order =
        std::sqrt(2 * kPi * gamma / modulus) * radius / std::pow(contact, 1.5);
    EXPECT_NEAR((hertz - force) / (kPi * gamma * radius), 1.0, next_order) << gamma;
  }
}

TEST(JkrLaw, StiffnessAtRest) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const double unit = unit_overlap(p);
    const auto force = [&](double y) {
      return law.force_N(law.first_root(y * unit, p.radius_m), p.radius_m);
    };
    const double h = 1e-4;
    const double slope = (force(1.0 / 3.0 + h) - force(1.0 / 3.0 - h)) / (2 * h * unit);
    constexpr double difference_error =
        1e-7;  // h^2 times the third derivative in units of the slope
    EXPECT_NEAR(law.equilibrium_stiffness_N_m(p.radius_m), slope, difference_error * slope)
        << p.name;
    const double a0 = law.equilibrium_contact_radius_m(p.radius_m);
    EXPECT_NEAR(law.equilibrium_stiffness_N_m(p.radius_m), 1.2 * p.modulus_Pa * a0,
                kRounding * slope);
  }
}

TEST(JkrLaw, EnergyReleaseRateIsGammaInEquilibrium) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    for (const double y : {-0.27, -0.1, 0.0, 1.0 / 3.0, 2.0, 30.0}) {
      const double overlap = y * unit_overlap(p);
      const double root = law.first_root(overlap, p.radius_m);
      const double a = root * root;
      const auto rate = [&](double radius) {
        return energy_release_rate_J_m2(law, radius, overlap, p.radius_m);
      };
      // The misfit a^2/R - delta loses digits where both are large.
      const double allowed = kRounding * p.gamma_J_m2 * (1 + std::fabs(y));
      EXPECT_NEAR(rate(a), p.gamma_J_m2, allowed) << p.name << " " << y;
      EXPECT_NEAR(law.work_of_adhesion_J_m2(), p.gamma_J_m2, kRounding * p.gamma_J_m2);
      EXPECT_GT(rate(1.01 * a), p.gamma_J_m2) << "too wide an edge must want to recede";
      EXPECT_LT(rate(0.99 * a), p.gamma_J_m2) << "too narrow an edge must want to advance";
    }
  }
}

TEST(JkrLaw, ForceOffEquilibrium) {
  for (const Pair& p : kPairs) {
    const JkrLaw law = law_of(p);
    const double pull_off = law.pull_off_force_N(p.radius_m);
    for (const double y : {-0.27, -0.1, 0.0, 1.0 / 3.0, 2.0, 30.0}) {
      const double overlap = y * unit_overlap(p);
      const double root = law.first_root(overlap, p.radius_m);
      const double a = root * root;
      const double force = law.force_N(root, p.radius_m);
      const auto off = [&](double radius, double delta) {
        return force_off_equilibrium_N(law, radius, delta, p.radius_m);
      };
      EXPECT_NEAR(off(a, overlap), force, kRounding * (pull_off + 10 * std::fabs(force)));
      // A held edge is a flat punch: dF/d(delta) = 2 E* a.
      const double step = unit_overlap(p);
      EXPECT_NEAR(off(a, overlap + step) - off(a, overlap), 2 * p.modulus_Pa * a * step,
                  kRounding * (pull_off + 10 * std::fabs(force)));
    }
  }
}

TEST(JkrLaw, OneUniversalCurveForAllMaterials) {
  for (const double y : path_of_y(50)) {
    const auto reduced = [y](const Pair& p) {
      const JkrLaw law = law_of(p);
      return law.force_N(law.first_root(y * unit_overlap(p), p.radius_m), p.radius_m) /
             law.pull_off_force_N(p.radius_m);
    };
    const double first = reduced(kPairs.front());
    // Near tear-off the tangent is vertical and multiplies the rounding of y.
    const double allowed = 1e-11 * (1 + std::fabs(first));
    for (const Pair& p : kPairs) EXPECT_NEAR(reduced(p), first, allowed) << p.name << " " << y;
  }
}

}  // namespace
}  // namespace powderlink
