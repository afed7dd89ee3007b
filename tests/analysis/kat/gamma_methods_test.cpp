// SPDX-License-Identifier: GPL-3.0-or-later
// Every method for Gamma against a closed form or a limit; the thesis's cases with its errata.
#include "analysis/kat/experiment/gamma_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "analysis/kat/experiment/contact_radii.h"
#include "analysis/kat/experiment/kat_analysis.h"
#include "analysis/kat/experiment/methods/contact_radius.h"
#include "analysis/kat/experiment/methods/deceleration.h"
#include "analysis/kat/experiment/methods/energy.h"
#include "analysis/kat/experiment/methods/finite_stop.h"
#include "analysis/kat/experiment/methods/rebound_time.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/study/material_library.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr double kClosedForm = 1e-12;  // of a value that is inverted in closed form
constexpr double kTable = 3e-3;    // tables of critical_speed.h to 1e-3 of d_c, twice that of Gamma
constexpr double kPrinted = 2e-3;  // printed inputs recomputed, three digits

KatDrop drop_of(const std::string& substrate, double velocity, double um) {
  KatDrop d;
  d.particle = find_material("316L");
  d.substrate = find_material(substrate);
  d.impact_velocity_m_s = velocity;
  d.critical_diameter_m = 1e-6 * um;
  return d;
}

void check_energy() {
  // The energy method inverts the critical diameter.
  for (const double gamma : {0.05, 17.0}) {
    KatDrop d = drop_of("UPVC", 1.4, 1.0);
    d.critical_diameter_m = physics::critical_diameter_instant_m(
        physics::JkrLaw(d.modulus_Pa(), gamma), d.particle.density_kg_m3, 1.4);
    EXPECT_NEAR(Energy::gamma_J_m2(d) / gamma, 1.0, 1e3 * kClosedForm);
  }
  // Thesis, Section 4.4, recomputed (errata).
  EXPECT_NEAR(Energy::gamma_J_m2(drop_of("UPVC", 1.40, 46.0)) / 17.18, 1.0, kPrinted);
  EXPECT_NEAR(Energy::gamma_J_m2(drop_of("borosilicate_glass", 2.21, 52.9)) / 107.6, 1.0, kPrinted);
  EXPECT_NEAR(Energy::gamma_J_m2(drop_of("borosilicate_glass", 2.96, 35.6)) / 102.8, 1.0, kPrinted);
}

void check_rebound_time() {
  // Gamma = 8/9 rho R^2 v/t_d; beads of Zafar et al. at 3.0 m/s: rebound of 163.7 ns, 73.1 J/m^2.
  KatDrop d = drop_of("borosilicate_glass", 3.0, 59.8);
  d.particle = find_material("borosilicate_glass");
  EXPECT_NEAR(ReboundTime::gamma_J_m2(d) / 73.1, 1.0, kPrinted);
  EXPECT_NEAR(8.0 / 9.0 * 2510.0 * std::pow(29.9e-6, 2) * 3.0 / (0.5 * 163.7e-9) / 73.1, 1.0,
              kPrinted);
}

void check_finite_stop() {
  KatDrop d = drop_of("UPVC", 1.4, 46.0);
  // Slow limit: m A = 1.5 pi Gamma R with the peak of a half-sine, less gravity (1e-3 of A).
  d.contact_time_s = 2e-3;
  const double pi = physics::JkrLaw::kPi;
  const double peak = pi * 1.4 / (2.0 * 2e-3) + 9.81;
  const double slow = 8.0 / 9.0 * 7980.0 * std::pow(23e-6, 2) * peak;
  EXPECT_NEAR(FiniteStop::gamma_J_m2(d) / slow, 1.0, kTable);
  // Short limit: the energy method, with the plate's rebound too.
  d.contact_time_s = 1e-9;
  EXPECT_NEAR(FiniteStop::gamma_J_m2(d) / Energy::gamma_J_m2(d), 1.0, kTable);
  d.plate_rebound = 0.5;
  KatDrop faster = d;
  faster.impact_velocity_m_s *= 1.5;
  EXPECT_NEAR(FiniteStop::gamma_J_m2(d) / Energy::gamma_J_m2(faster), 1.0, kTable);
  // In between: the reduced model, integrated, has the same d_c.
  d.contact_time_s = 3e-6;
  KatSetup setup;
  setup.particle = d.particle;
  setup.substrate = d.substrate;
  setup.work_of_adhesion_J_m2 = FiniteStop::gamma_J_m2(d);
  setup.stop = physics::StopPulse::half_sine(3e-6, 0.5);
  EXPECT_NEAR(critical_diameter(ReducedModel(setup), 1.4).diameter_m / 46e-6, 1.0, kTable);
}

void check_deceleration() {
  // Pull-off force of Gamma over the mass of a 46 um sphere.
  KatDrop d = drop_of("UPVC", 1.4, 46.0);
  const physics::JkrLaw law(d.modulus_Pa(), 0.08);
  d.deceleration_m_s2 = law.pull_off_force_N(23e-6) / physics::sphere_mass_kg(23e-6, 7980.0);
  EXPECT_NEAR(Deceleration::gamma_J_m2(d) / 0.08, 1.0, kClosedForm);
}

void check_contact_radius() {
  // The a0 that goes with 19.8 J/m^2 (thesis, UPVC) gives it back, and is the first dark ring.
  UncertainDrop u{drop_of("UPVC", 1.4, 46.0), {}};
  const double a0 = physics::JkrLaw(u.best.modulus_Pa(), 19.8).equilibrium_contact_radius_m(23e-6);
  u.best.contact_radii = {{a0, 23e-6, 550e-9}, {a0, 23e-6, 550e-9}};
  EXPECT_NEAR(1e6 * a0, 3.57, 0.005);
  EXPECT_NEAR(1e6 * dark_ring_m(u.best.contact_radii[0]), 3.56, 0.005);
  const GammaEstimate dark = *ContactRadiusAtRest::estimate(u);
  EXPECT_NEAR(dark.value / 19.8, 1.0, 1e3 * kClosedForm);
  ASSERT_EQ(dark.warnings.size(), 1U);
  EXPECT_NE(dark.warnings[0].find("dark ring"), std::string::npos);
  // 316L on glass: 95.4 J/m^2, and the first bright ring.
  u.best.substrate = find_material("borosilicate_glass");
  const double glass =
      physics::JkrLaw(u.best.modulus_Pa(), 95.4).equilibrium_contact_radius_m(26.5e-6);
  u.best.contact_radii = {{glass, 26.5e-6, 550e-9}};
  const GammaEstimate bright = *ContactRadiusAtRest::estimate(u);
  EXPECT_NEAR(bright.value / 95.4, 1.0, 1e3 * kClosedForm);
  EXPECT_NEAR(1e6 * bright_ring_m(u.best.contact_radii[0]), 2.70, 0.005);
  EXPECT_EQ(bright.warnings.size(), 2U);  // one grain, and the ring
  // Half-way between rings there is nothing to warn of, and the spread makes the interval.
  u.best.contact_radii = {
      {3.1e-6, 26.5e-6, 550e-9}, {3.3e-6, 26.5e-6, 550e-9}, {3.2e-6, 26.5e-6, 550e-9}};
  const GammaEstimate free = *ContactRadiusAtRest::estimate(u);
  EXPECT_TRUE(free.warnings.empty());
  EXPECT_LT(free.low, free.value);
  EXPECT_GT(free.high, free.value);
}

TEST(GammaMethods, EveryOneOfTheListHasAClosedForm) {
  const std::map<std::string, std::function<void()>> checks = {
      {"energy", check_energy},
      {"rebound_time", check_rebound_time},
      {"finite_stop", check_finite_stop},
      {"deceleration", check_deceleration},
      {"contact_radius", check_contact_radius}};
  EXPECT_EQ(checks.size(), gamma_methods().size());
  for (const GammaMethod& m : gamma_methods()) {
    SCOPED_TRACE(m.info->name);
    ASSERT_TRUE(checks.count(m.info->name) == 1);
    checks.at(m.info->name)();
    for (const char* text : {m.info->law, m.info->assumption, m.info->validity, m.info->source})
      EXPECT_GT(std::string(text).size(), 8U);
  }
}

TEST(GammaMethods, IntervalsAddInQuadrature) {
  KatAnalysisInput in;
  in.drop = drop_of("UPVC", 1.4, 1.0);
  in.velocity_sigma_m_s = 0.05;
  const UncertainDrop u = uncertain_drop(in, {46.0, 44.0, 49.0});
  const GammaEstimate e = propagated(u, Energy::gamma_J_m2);
  // Gamma ~ d v^(6/5): ends of d, and of v at 1.96 sigma.
  const double of_v = 1.2 * std::log(1.0 + 1.96 * 0.05 / 1.4);
  EXPECT_NEAR(std::log(e.high / e.value), std::hypot(std::log(49.0 / 46.0), of_v), 1e-9);
  EXPECT_NEAR(std::log(e.value / e.low),
              std::hypot(std::log(46.0 / 44.0), -1.2 * std::log(1.0 - 1.96 * 0.05 / 1.4)), 1e-9);
}

TEST(GammaMethods, DisagreementIsTold) {
  KatAnalysisInput in;
  in.drop = drop_of("UPVC", 1.4, 1.0);
  in.drop.contact_time_s = 1e-4;
  const auto apart = disagreements(all_methods(uncertain_drop(in, {46.0, 45.0, 47.0})));
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_NE(apart[0].find("finite stop 0.0"), std::string::npos) << apart[0];
  in.drop.contact_time_s.reset();
  EXPECT_TRUE(disagreements(all_methods(uncertain_drop(in, {46.0, 45.0, 47.0}))).empty());
}

TEST(ContactRadii, TablesThatCannotBe) {
  const TestFolder folder;
  const auto read = [&](const std::string& text) {
    return [&folder, text] { read_contact_radii(folder.write("a.csv", text)); };
  };
  expect_refusal(read("contact_radius_um,radius_um\n3,23\n"), {"wavelength_nm"});
  expect_refusal(read("contact_radius_um,radius_um,wavelength_nm\n23,3,550\n"), {"exchange"});
  expect_refusal(read("contact_radius_um,radius_um,wavelength_nm\n3,23,0.55\n"), {"200 to 2000"});
}

}  // namespace
}  // namespace powderlink::analysis
