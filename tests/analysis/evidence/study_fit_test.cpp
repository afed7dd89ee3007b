// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of what a study leaves free: values come back, weights count, bounds are told.
#include "analysis/evidence/study_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/evidence/candidate.h"
#include "analysis/evidence/comparison.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/study/material_library.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

Study glass_study(double energy, const std::vector<EffectChoice>& effects) {
  Study s;
  s.file = "study.toml";
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.effects = effects;
  s.adhesive_energy = {0.001, 1000.0};
  for (const double v : {1.5, 2.1, 3.0, 4.2, 6.0}) {
    KatRow row{v};
    row.critical_diameter_um =
        critical_diameter(ReducedModel(row_setup(s, row, energy)), v).diameter_m * 1e6;
    s.rows.push_back(row);
  }
  return s;
}

TEST(StudyFit, FindsTheEnergyThatMadeTheData) {
  const struct {
    double energy;
    std::vector<EffectChoice> effects;
    double tolerance;
  } cases[] = {
      // d_c is known to 1e-4 by bisection and to 1e-3 from the tables; Gamma goes with up to its
      // square
      {50.0, {}, 1e-3},
      {0.09, {{"finite_stop_pulse", {1e-4, 0.0}}}, 3e-3},
      {5.0, {{"rate_dependent_adhesion", {0.5, 0.8}}}, 5e-3},
      {20.0, {{"electrostatic_image_force", {1e-4}}}, 2e-3},
      {5.0, {{"capillary_bridge", {5.0, 0.05}}}, 2e-3},
      {80.0, {{"surface_roughness", {2e-5}}}, 2e-3},
      {9.0, {{"plastic_contact", {1e9}}}, 2e-3}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.effects.empty() ? "none" : c.effects[0].name);
    const StudyFit fit = fit_study(glass_study(c.energy, c.effects));
    ASSERT_EQ(fit.adhesive_energy_J_m2.size(), 5U);
    EXPECT_TRUE(fit.fitted);
    EXPECT_NEAR(fit.adhesive_energy_J_m2[0] / c.energy, 1.0, c.tolerance);
    EXPECT_FALSE(fit.at_bound);
  }
}

TEST(StudyFit, FindsAParameterThatIsLeftFree) {
  Study s = glass_study(20.0, {{"electrostatic_image_force", {1e-4}}});
  s.effects[0].parameters[0] = 1e-6;
  s.effects[0].free = {{0, 1e-9, 1e-2}};
  const StudyFit fit = fit_study(s);
  EXPECT_NEAR(fit.study.effects[0].parameters[0] / 1e-4, 1.0, 5e-3);
  EXPECT_NEAR(fit.adhesive_energy_J_m2[0] / 20.0, 1.0, 1e-2);
}

TEST(StudyFit, CertainRowsWeighMore) {
  Study s = glass_study(50.0, {});
  s.rows.resize(2);
  s.model_discrepancy = 0.0;
  s.rows[0].critical_diameter_sigma_um = 1e-3 * *s.rows[0].critical_diameter_um;
  s.rows[1].critical_diameter_sigma_um = 0.1 * *s.rows[1].critical_diameter_um;
  *s.rows[1].critical_diameter_um *= 1.3;
  EXPECT_NEAR(fit_study(s).adhesive_energy_J_m2[0] / 50.0, 1.0, 2e-3);
}

TEST(StudyFit, SaysWhenABoundHolds) {
  Study s = glass_study(50.0, {});
  s.adhesive_energy.upper_J_m2 = 20.0;
  const StudyFit fit = fit_study(s);
  EXPECT_TRUE(fit.at_bound);
  EXPECT_NEAR(fit.adhesive_energy_J_m2[0] / 20.0, 1.0, 1e-3);
  EXPECT_NE(fit.origin.find("bound"), std::string::npos);
}

TEST(StudyFit, RowsMayBringTheirOwn) {
  Study s = glass_study(50.0, {});
  for (std::size_t i = 0; i < s.rows.size(); ++i)
    s.rows[i].adhesive_energy_J_m2 = 1.0 + static_cast<double>(i);
  EXPECT_EQ(fit_study(s).adhesive_energy_J_m2, (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0}));
}

TEST(StudyFit, NeedsMeasurements) {
  Study s = glass_study(50.0, {});
  s.rows[1].critical_diameter_um.reset();
  expect_refusal([&] { fit_study(s); }, {"no measured diameters", "give a number"});
}

TEST(Comparison, IntervalIsThatOfTheLinearModel) {
  // d_c ~ Gamma for an instant stop: the relative sigma of Gamma is sigma/sqrt(n), exactly so for
  // small sigma.
  Study s = glass_study(50.0, {});
  s.model_discrepancy = 0.0;
  constexpr double sigma = 0.01;
  for (KatRow& row : s.rows) row.critical_diameter_sigma_um = sigma * *row.critical_diameter_um;
  const Comparison c = compare(s, observe(s));
  EXPECT_EQ(c.verdict, Comparison::Verdict::agrees);
  ASSERT_EQ(c.intervals.size(), 1U);
  const double half = 0.5 * std::log(c.intervals[0].high / c.intervals[0].low);
  EXPECT_NEAR(half / (sigma / std::sqrt(5.0)), 1.0, 0.02);  // the search's last halving
}

TEST(Comparison, NamesADirectionThatTheDataLeaveOpen) {
  // In the slow limit only Gamma/tau counts: both free cannot be determined.
  Study s = glass_study(0.09, {{"finite_stop_pulse", {1e-4, 0.0}}});
  for (KatRow& row : s.rows) row.critical_diameter_sigma_um = 0.03 * *row.critical_diameter_um;
  s.effects[0].free = {{0, 2e-5, 1e-3}};
  const Comparison c = compare(s, observe(s));
  ASSERT_EQ(c.uncertainty.flat.size(), 1U);
  EXPECT_NE(c.uncertainty.flat[0].find("tau_s"), std::string::npos);
  EXPECT_NE(c.uncertainty.flat[0].find("adhesive_energy_J_m2"), std::string::npos);
}

TEST(Comparison, TwoRowsDecideNothing) {
  Study s = glass_study(50.0, {});
  s.rows.resize(2);
  EXPECT_EQ(compare(s, observe(s)).verdict, Comparison::Verdict::undecided);
  *s.rows[0].critical_diameter_um *= 2.0;  // however far they are from the model
  for (KatRow& row : s.rows) row.critical_diameter_sigma_um = 0.01 * *row.critical_diameter_um;
  EXPECT_EQ(compare(s, observe(s)).verdict, Comparison::Verdict::undecided);
}

TEST(Comparison, OneVelocityDecidesNothing) {
  Study s = glass_study(50.0, {});
  for (KatRow& row : s.rows) {
    row.impact_velocity_m_s = 3.0 + 0.01 * row.impact_velocity_m_s;
    row.critical_diameter_um = 60.0;
  }
  EXPECT_EQ(compare(s, observe(s)).verdict, Comparison::Verdict::undecided);
}

TEST(Comparison, BoundsThatReachNothingAreTold) {
  Study s = glass_study(50.0, {});
  s.adhesive_energy = {1e-4, 1e-3};
  const Comparison c = compare(s, observe(s));
  EXPECT_EQ(c.verdict, Comparison::Verdict::fails);
  const auto told = [](const std::string& w) {
    return w.find("5 of 5 rows") != std::string::npos && w.find("widen") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(c.words.begin(), c.words.end(), told));
}

TEST(StudyFit, EffectsOnTopOfAnotherAreThoseOfTheIntegration) {
  // No shortcut knows a slow stop with a bridge: estimates are corrected by the integration that made
  // the data. Twice the accuracy at which the correction counts as settled, for Gamma and back.
  constexpr double accuracy = 4e-3;
  Study s = glass_study(
      0.05, {{"finite_stop_pulse", {1e-4, 0.0}}, {"capillary_bridge", {0.0728, 0.005}}});
  const StudyFit fit = fit_study(s);
  EXPECT_NEAR(fit.adhesive_energy_J_m2[0] / 0.05, 1.0, accuracy);
}

TEST(StudyFit, TheSameVelocityWithAnotherContactTimeIsCorrectedOnItsOwn) {
  // Forces added are 34 % off for the short stop and 26 % for the long one, at 1.5 m/s.
  constexpr double accuracy = 4e-3;  // as above
  Study s = glass_study(
      0.05, {{"finite_stop_pulse", {1e-4, 0.0}}, {"electrostatic_image_force", {1e-4}}});
  s.rows.clear();
  for (const double v : {1.5, 3.0, 6.0}) {
    for (const double contact_time_us : {5.0, 60.0}) {
      KatRow row{v};
      row.contact_time_us = contact_time_us;
      row.critical_diameter_um =
          critical_diameter(ReducedModel(row_setup(s, row, 0.05)), v).diameter_m * 1e6;
      s.rows.push_back(row);
    }
  }
  const Observations o = observe(s);
  const Candidate c = fit_candidate(s, o, {});
  EXPECT_EQ(c.hypothesis.correction.size(), 2U) << "contact times";
  EXPECT_NEAR(c.find("adhesive_energy_J_m2")->value / 0.05, 1.0, accuracy);
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    EXPECT_NEAR(c.predicted[i] / *s.rows[i].critical_diameter_um, 1.0, accuracy)
        << s.rows[i].impact_velocity_m_s << " m/s, " << *s.rows[i].contact_time_us << " us";
  }
}

TEST(Comparison, MoreParametersThanRowsAreRefused) {
  Study s = glass_study(0.09, {{"finite_stop_pulse", {1e-4, 0.0}}});
  s.rows.resize(1);
  s.effects[0].free = {{0, 2e-5, 1e-3}};
  expect_refusal([&] { compare(s, observe(s)); }, {"2 free parameters and 1 rows"});
}

}  // namespace
}  // namespace powderlink::analysis
