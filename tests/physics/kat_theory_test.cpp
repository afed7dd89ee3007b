// SPDX-License-Identifier: GPL-3.0-or-later
// The closed forms of the Kinetic Adhesion Test against each other, against Hertz's collision and
// against the numbers in print.
#include "physics/kat/kat_theory.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "physics/contact/material.h"

namespace powderlink {
namespace {

using physics::JkrLaw;
using physics::Material;

constexpr double kPi = JkrLaw::kPi;
constexpr double kRounding = 1e-12;  // of closed forms with powers of 1/5
/// Half a unit of the last digit that the source prints.
constexpr double kTwoDecimals = 0.005;
constexpr double kOneDecimal = 0.05;

const Material kSteel{"316L", 7980.0, 2.11e11, 0.3};
const Material kGlass{"borosilicate_glass", 2510.0, 7.3e10, 0.2};
const Material kUpvc{"UPVC", 1440.0, 3.0e9, 0.3};

double modulus(const Material& particle, const Material& plate) {
  return physics::effective_youngs_modulus_Pa(particle, plate);
}

struct DropTest {  // silanised glass beads on silanised glass, Zafar et al. 2014
  double speed_m_s, diameter_um, gamma_J_m2, gamma_rebound_J_m2, rebound_ns;
};
const std::vector<DropTest> kDropTests = {
    {1.8, 66.4, 44.78, 44.0, 201.3},   {2.3, 63.8, 57.75, 56.7, 184.2},
    {3.0, 59.8, 74.45, 73.1, 163.7},   {4.1, 53.0, 95.99, 94.3, 136.3},
    {4.8, 47.5, 103.95, 102.1, 118.4}, {5.4, 42.3, 106.62, 104.7, 103.0},
    {6.0, 37.3, 106.69, 104.8, 88.9}};

TEST(KatTheory, DropTestByTheEnergyBalance) {
  const double e = modulus(kGlass, kGlass);
  for (const DropTest& row : kDropTests) {
    EXPECT_NEAR(physics::adhesive_energy_instant_J_m2(e, kGlass.density_kg_m3, row.speed_m_s,
                                                      row.diameter_um * 1e-6),
                row.gamma_J_m2, kTwoDecimals)
        << row.speed_m_s << " m/s";
  }
}

TEST(KatTheory, DropTestByTheReboundTime) {
  const double e = modulus(kGlass, kGlass);
  for (const DropTest& row : kDropTests) {
    EXPECT_NEAR(physics::adhesive_energy_rebound_J_m2(e, kGlass.density_kg_m3, row.speed_m_s,
                                                      row.diameter_um * 1e-6),
                row.gamma_rebound_J_m2, kOneDecimal)
        << row.speed_m_s << " m/s";
    EXPECT_NEAR(1e9 * physics::rebound_time_s(e, kGlass.density_kg_m3, 0.5e-6 * row.diameter_um,
                                              row.speed_m_s),
                row.rebound_ns, kOneDecimal)
        << row.speed_m_s << " m/s";
  }
}

TEST(KatTheory, PrintedFormOfTheEnergyBalance) {
  // Eq. 4.5 as printed, with the constant 1.0107 that the law does not round.
  constexpr double rounded_constant = 0.5e-4 * 3.0 / 5.0;  // 1.0107 enters with the power -3/5
  const double e = modulus(kGlass, kGlass);
  const double k = 4.0 / 3.0 * e;
  for (const DropTest& row : kDropTests) {
    const double printed = std::pow(row.speed_m_s, 1.2) * 0.5e-6 * row.diameter_um *
                           std::pow(8 * k * k * std::pow(kGlass.density_kg_m3, 3) /
                                        (243 * kPi * kPi * std::pow(1.0107, 3)),
                                    0.2);
    EXPECT_NEAR(physics::adhesive_energy_instant_J_m2(e, kGlass.density_kg_m3, row.speed_m_s,
                                                      row.diameter_um * 1e-6),
                printed, rounded_constant * printed);
  }
}

struct SteelTest {
  const Material* plate;
  double speed_m_s, diameter_um, printed_J_m2, recomputed_J_m2, last_digit;
};
const std::vector<SteelTest> kSteelTests = {{&kUpvc, 1.40, 46.0, 17.53, 17.175, 0.0005},
                                            {&kGlass, 2.21, 52.9, 103.34, 107.6, 0.05},
                                            {&kGlass, 2.96, 35.6, 98.78, 102.84, 0.005}};

TEST(KatTheory, SteelPowder) {
  for (const SteelTest& t : kSteelTests) {
    const double e = modulus(kSteel, *t.plate);
    const double gamma = physics::adhesive_energy_instant_J_m2(e, kSteel.density_kg_m3, t.speed_m_s,
                                                               t.diameter_um * 1e-6);
    EXPECT_NEAR(gamma, t.recomputed_J_m2, t.last_digit) << t.plate->name;
    // The source prints values that its own inputs miss by 2-4 %.
    const double off = std::fabs(t.printed_J_m2 / gamma - 1);
    EXPECT_GT(off, 0.02) << t.plate->name;
    EXPECT_LT(off, 0.04) << t.plate->name;
  }
}

TEST(KatTheory, CriticalDiametersOfTheInstantStop) {
  // Targets that runs are held to, within 0.2 %; the closed form itself is 0.07 % below them.
  constexpr double target_um_relative = 2e-3;
  struct Row {
    double gamma, speed;
    const Material* plate;
    double target_um;
  };
  for (const Row& r : std::vector<Row>{{17.175, 1.40, &kUpvc, 46.03},
                                       {107.6, 2.21, &kGlass, 52.93},
                                       {102.84, 2.96, &kGlass, 35.63}}) {
    const JkrLaw law(modulus(kSteel, *r.plate), r.gamma);
    const double d = 1e6 * physics::critical_diameter_instant_m(law, kSteel.density_kg_m3, r.speed);
    EXPECT_NEAR(d, r.target_um, target_um_relative * r.target_um);
  }
  const JkrLaw law(modulus(kSteel, kUpvc), 17.175);
  constexpr double last_digit_um = 0.0005;
  EXPECT_NEAR(1e6 * physics::critical_diameter_instant_m(law, kSteel.density_kg_m3, 1.40), 45.999,
              last_digit_um);
}

TEST(KatTheory, CriticalSpeedOfOneSphere) {
  const JkrLaw law(modulus(kSteel, kUpvc), 17.16);
  constexpr double last_digit_m_s = 5e-6;
  const double v = physics::critical_speed_instant_m_s(law, 23e-6, kSteel.density_kg_m3);
  EXPECT_NEAR(v, 1.39895, last_digit_m_s);
  const double kinetic = 0.5 * physics::sphere_mass_kg(23e-6, kSteel.density_kg_m3) * v * v;
  EXPECT_NEAR(kinetic, physics::detachment_work_J(law, 23e-6), kRounding * kinetic);
}

TEST(KatTheory, ExponentsOfTheInstantStop) {
  const JkrLaw law(modulus(kGlass, kGlass), 0.4);
  const auto d = [&](double v) {
    return physics::critical_diameter_instant_m(law, kGlass.density_kg_m3, v);
  };
  EXPECT_NEAR(std::log(d(6.0) / d(1.5)) / std::log(4.0), -6.0 / 5.0, kRounding);
  const auto v = [&](double r) {
    return physics::critical_speed_instant_m_s(law, r, kGlass.density_kg_m3);
  };
  EXPECT_NEAR(std::log(v(8e-5) / v(1e-5)) / std::log(8.0), -5.0 / 6.0, kRounding);
  const JkrLaw sticky(modulus(kGlass, kGlass), 4.0);
  EXPECT_NEAR(
      std::log10(physics::critical_speed_instant_m_s(sticky, 2e-5, kGlass.density_kg_m3) / v(2e-5)),
      5.0 / 6.0, kRounding);
}

TEST(KatTheory, InversePairs) {
  const double rho = kSteel.density_kg_m3;
  const double e = modulus(kSteel, kGlass);
  for (const double gamma : {0.01, 1.0, 100.0}) {
    const JkrLaw law(e, gamma);
    for (const double v : {0.3, 3.0}) {
      const double d = physics::critical_diameter_instant_m(law, rho, v);
      EXPECT_NEAR(physics::adhesive_energy_instant_J_m2(e, rho, v, d), gamma, kRounding * gamma);
      EXPECT_NEAR(physics::critical_speed_instant_m_s(law, d / 2, rho), v, kRounding * v);
    }
    for (const double a : {1e3, 1e5}) {
      const double d = physics::critical_diameter_slow_m(gamma, rho, a);
      EXPECT_NEAR(physics::adhesive_energy_slow_J_m2(rho, a, d), gamma, kRounding * gamma);
    }
    const double a0 = law.equilibrium_contact_radius_m(23e-6);
    EXPECT_NEAR(physics::adhesive_energy_contact_radius_J_m2(e, 23e-6, a0), gamma,
                kRounding * gamma);
  }
}

TEST(KatTheory, SlowStopBalancesWeightAndPullOff) {
  const double gamma = 0.09, a = 5e4;
  const double radius = physics::critical_diameter_slow_m(gamma, kGlass.density_kg_m3, a) / 2;
  const double inertia = physics::sphere_mass_kg(radius, kGlass.density_kg_m3) * a;
  const double pull_off = JkrLaw(modulus(kGlass, kGlass), gamma).pull_off_force_N(radius);
  EXPECT_NEAR(inertia, pull_off, kRounding * pull_off);
}

TEST(KatTheory, ReboundTimeIsHertz) {
  // Twice the time from first touch to rest, m v^2/2 = (8/15) E* sqrt(R) delta^(5/2) at rest.
  boost::math::quadrature::tanh_sinh<double> integrator;
  const double shape = integrator.integrate(
      [](double x, double complement) {
        const double from_one = x > 0.5 ? complement : 1 - x;  // 1 - x^(5/2) without cancellation
        return 1 / std::sqrt(-std::expm1(2.5 * std::log1p(-from_one)));
      },
      0.0, 1.0);
  const double e = modulus(kGlass, kGlass), radius = 30e-6, v = 3.0;
  const double m = physics::sphere_mass_kg(radius, kGlass.density_kg_m3);
  const double deepest = std::pow(15 * m * v * v / (16 * e * std::sqrt(radius)), 0.4);
  const double exact = 2 * deepest / v * shape;
  constexpr double printed_factor = 1.5e-3;  // 2.865 for 2.8683
  EXPECT_NEAR(physics::rebound_time_s(e, kGlass.density_kg_m3, radius, v), exact,
              printed_factor * exact);
}

TEST(KatTheory, TouchAndGoCostsLessThanDetachmentFromRest) {
  const JkrLaw law(modulus(kSteel, kGlass), 2.0);
  const double radius = 20e-6;
  const double at_rest = std::sqrt(law.equilibrium_contact_radius_m(radius));
  const double gain =
      law.energy_J(law.first_root(0.0, radius), radius) - law.energy_J(at_rest, radius);
  const double detach = physics::detachment_work_J(law, radius);
  EXPECT_GT(gain, 0.0);
  EXPECT_NEAR(physics::touch_and_go_work_J(law, radius), detach - gain, kRounding * detach);
}

}  // namespace
}  // namespace powderlink
