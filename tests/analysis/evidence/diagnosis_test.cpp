// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of evidence on data whose answer is known, and what is told when nothing can be decided.
#include "analysis/evidence/diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/evidence/added_effects.h"
#include "analysis/evidence/comparison.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/study/material_library.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

Study steel_study(double energy, const std::vector<EffectChoice>& effects, double noise,
                  bool stated = true, std::uint64_t seed = 11) {
  Study s;
  s.file = "study.toml";
  s.particle = find_material("316L");
  s.substrate = find_material("borosilicate_glass");
  s.adhesive_energy = {0.001, 1000.0};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (const double v : {1.0, 1.4, 1.9, 2.5, 3.2, 4.0, 4.9, 5.9}) {
    KatRow row{v};
    const Hypothesis truth{effects, energy};
    row.critical_diameter_um =
        predicted_diameter_um(s, truth, row) * (1.0 + noise * normal(random));
    if (stated) row.critical_diameter_sigma_um = noise * *row.critical_diameter_um;
    s.rows.push_back(row);
  }
  return s;
}

Diagnosis diagnosed(const Study& s) { return diagnose(s, observe(s)); }

TEST(Diagnosis, NothingIsMissing) {
  const Diagnosis d = diagnosed(steel_study(90.0, {}, 0.02));
  EXPECT_EQ(d.verdict, Verdict::no_missing_effect);
  EXPECT_EQ(d.best, "");
  EXPECT_EQ(d.ranking.front().name, "none");
  EXPECT_FALSE(d.words.empty());
}

TEST(Diagnosis, NamesTheEffectThatIsThere) {
  const struct {
    EffectChoice effect;
    double energy;
  } cases[] = {{{"finite_stop_pulse", {8e-5, 0.3}}, 0.2},
               {{"electrostatic_image_force", {1.8e-4}}, 90.0},
               {{"psd_cutoff", {60.0, 100.0}}, 90.0}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.effect.name);
    const Diagnosis d = diagnosed(steel_study(c.energy, {c.effect}, 0.02));
    EXPECT_EQ(d.verdict, Verdict::missing_effect);
    EXPECT_EQ(d.best, c.effect.name);
    EXPECT_EQ(d.ranking.front().name, c.effect.name);
    EXPECT_EQ(d.indistinguishable, std::vector<std::string>{c.effect.name});
    EXPECT_FALSE(d.next.text.empty());
  }
}

TEST(Diagnosis, IsTheSameEveryTime) {
  const Study s = steel_study(30.0, {{"rate_dependent_adhesion", {0.1, 0.7}}}, 0.04);
  const Diagnosis a = diagnosed(s);
  const Diagnosis b = diagnosed(s);
  ASSERT_EQ(a.ranking.size(), b.ranking.size());
  for (std::size_t i = 0; i < a.ranking.size(); ++i) {
    EXPECT_EQ(a.ranking[i].name, b.ranking[i].name);
    EXPECT_EQ(a.ranking[i].bic, b.ranking[i].bic);
  }
}

TEST(Diagnosis, AStepIsNotExplained) {
  Study s = steel_study(90.0, {}, 0.01);
  for (KatRow& row : s.rows) {
    if (row.impact_velocity_m_s > 2.2) {
      *row.critical_diameter_um *= 1.3;
      *row.critical_diameter_sigma_um *= 1.3;
    }
  }
  const Diagnosis d = diagnosed(s);
  EXPECT_TRUE(d.verdict == Verdict::unexplained || d.verdict == Verdict::ambiguous);
  const std::string last = d.words.back();
  EXPECT_NE(last.find("a step of +"), std::string::npos) << last;
  EXPECT_NE(last.find("between 1.9 and 2.5 m/s"), std::string::npos) << last;
}

void expect_same_fit(const Candidate& a, const Candidate& b) {
  SCOPED_TRACE(a.name);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.bic, b.bic);
  EXPECT_EQ(a.solution.values, b.solution.values);
}

TEST(Diagnosis, AddingFitsAsTheRankingDid) {
  const Study s = steel_study(90.0, {{"electrostatic_image_force", {1.8e-4}}}, 0.02);
  const Observations o = observe(s);
  for (const Candidate& c : diagnose(s, o).ranking) {
    if (!c.added.empty()) expect_same_fit(fit_added(s, o, c.added), c);
  }
}

TEST(Diagnosis, TwoEffectsAreAddedAsTheyWereFound) {
  // Flat at low v, as a cut-off makes it, and up by a quarter of its slope from -1.2 at high v.
  Study s = steel_study(40.0, {}, 0.01);
  for (KatRow& row : s.rows) {
    const double v = row.impact_velocity_m_s;
    row.critical_diameter_um = 60.0 / std::pow(1.0 + std::pow(v / 2.0, 8.0 * 0.8), 1.0 / 8.0);
    row.critical_diameter_sigma_um = 0.01 * *row.critical_diameter_um;
  }
  s.adhesive_energy = {0.001, 1000.0};
  const Observations o = observe(s);
  const Diagnosis d = diagnose(s, o);
  ASSERT_FALSE(d.pairs.empty());
  const Candidate& pair = d.pairs.front();
  ASSERT_EQ(pair.added.size(), 2U);
  expect_same_fit(fit_added(s, o, {pair.added[1], pair.added[0]}), pair);  // in either order
  expect_refusal([&] { fit_candidate(s, o, pair.added); }, {"no point to start from"});
  expect_refusal([&] { fit_added(s, o, {"a", "b", "c"}); }, {"'a+b+c'", "two as a+b"});
}

TEST(Diagnosis, AnImplausibleLeaderDoesNotHideThePlausibleOne) {
  // The seven drops of Zafar et al. 2014, without sigma.
  Study s;
  s.file = "study.toml";
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.adhesive_energy = {0.001, 1000.0};
  const double v[] = {1.8, 2.3, 3.0, 4.1, 4.8, 5.4, 6.0};
  const double d_um[] = {66.4, 63.8, 59.8, 53.0, 47.5, 42.3, 37.3};
  for (std::size_t i = 0; i < 7; ++i) {
    KatRow row{v[i]};
    row.critical_diameter_um = d_um[i];
    s.rows.push_back(row);
  }
  const Diagnosis d = diagnosed(s);
  EXPECT_EQ(d.verdict, Verdict::ambiguous);
  EXPECT_EQ(d.best, "finite_stop_pulse");
  EXPECT_NEAR(rms_relative_error(d.baseline().rms), 0.333, 0.002);
  const Candidate& stop = d.get("finite_stop_pulse");
  EXPECT_TRUE(stop.plausible);
  EXPECT_NEAR(rms_relative_error(stop.rms), 0.065, 0.002);
  EXPECT_GE(stop.find("adhesive_energy_J_m2")->value, 0.05);
  EXPECT_LE(stop.find("adhesive_energy_J_m2")->value, 0.2);
  const Candidate& cutoff = d.get("psd_cutoff");
  EXPECT_FALSE(cutoff.plausible);
  EXPECT_LT(rms_relative_error(cutoff.rms), 0.03);
  EXPECT_GT(cutoff.find("adhesive_energy_J_m2")->value, 80.0);
  EXPECT_GT(d.next.separation_sigma, 3.0);
}

TEST(Diagnosis, MeasuredContactTimesAreTaken) {
  Study s = steel_study(0.2, {{"finite_stop_pulse", {8e-5, 0.0}}}, 0.02);
  for (KatRow& row : s.rows) row.contact_time_us = 80.0;
  const Diagnosis d = diagnosed(s);
  EXPECT_EQ(d.best, "finite_stop_pulse");
  EXPECT_EQ(d.get("finite_stop_pulse").find("tau_s"), nullptr) << "not free, not held: measured";
  EXPECT_NEAR(d.get("finite_stop_pulse").find("adhesive_energy_J_m2")->value, 0.2, 0.02);
}

TEST(Diagnosis, RefusesWhatCannotDecide) {
  Study s = steel_study(90.0, {}, 0.02);
  Study two = s;
  two.rows.resize(2);
  expect_refusal([&] { diagnosed(two); }, {"2 rows", "at least 4"});
  Study one_speed = s;
  for (KatRow& row : one_speed.rows) row.impact_velocity_m_s = 2.0;
  expect_refusal([&] { diagnosed(one_speed); }, {"2 to 2 m/s", "differ"});
}

TEST(Diagnosis, AFitAtABoundIsNotConfident) {
  Study s = steel_study(0.2, {{"finite_stop_pulse", {8e-5, 0.0}}}, 0.02);
  for (KatRow& row : s.rows) row.contact_time_us = 80.0;
  s.adhesive_energy.upper_J_m2 = 0.05;
  const Diagnosis d = diagnosed(s);
  EXPECT_NE(d.verdict, Verdict::missing_effect);
  EXPECT_NE(d.verdict, Verdict::no_missing_effect);
}

bool told(const std::vector<std::string>& words, const std::string& what) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& w) { return w.find(what) != std::string::npos; });
}

TEST(Diagnosis, ABoundOfGammaIsNeverConfidentAndAlwaysTold) {
  // Instant stop: d_c ~ Gamma. The bound is this part of the Gamma that made the data.
  const std::string sentence = "stopped at a bound of the fit, 0.001 to ";
  for (const double part : {0.9, 0.99}) {
    for (const bool stated : {true, false}) {
      SCOPED_TRACE(testing::Message() << part << (stated ? " stated" : " assumed"));
      Study s = steel_study(4.0, {}, 1e-3, stated);  // so that chance does not move Gamma
      for (KatRow& row : s.rows) {
        if (stated) row.critical_diameter_sigma_um = 0.02 * *row.critical_diameter_um;
      }
      s.adhesive_energy.upper_J_m2 = part * 4.0;
      const Observations o = observe(s);
      const Diagnosis d = diagnose(s, o);
      EXPECT_TRUE(d.verdict == Verdict::ambiguous || d.verdict == Verdict::unexplained)
          << to_string(d.verdict);
      EXPECT_TRUE(told(d.words, sentence));
      const Comparison c = compare(s, o);
      EXPECT_NE(c.verdict, Comparison::Verdict::agrees);
      EXPECT_TRUE(told(c.words, sentence));
    }
  }
  // As well where Gamma is implausible: 16 % short, an effect would be named.
  Study strong = steel_study(95.0, {}, 0.02);
  strong.adhesive_energy.upper_J_m2 = 80.0;
  const Diagnosis short_of = diagnosed(strong);
  EXPECT_EQ(short_of.verdict, Verdict::ambiguous);
  EXPECT_FALSE(short_of.best.empty());
  EXPECT_TRUE(told(short_of.words, "widen the bounds"));
  Study s = steel_study(4.0, {}, 1e-3);
  s.adhesive_energy.upper_J_m2 = 1.01 * 4.0;
  const Observations o = observe(s);
  EXPECT_EQ(diagnose(s, o).verdict, Verdict::no_missing_effect);
  EXPECT_EQ(compare(s, o).verdict, Comparison::Verdict::agrees);
}

TEST(Diagnosis, ABoundThatForcesImplausibleValuesIsNotConfident) {
  // Only Gamma/tau counts: with Gamma held low, tau is fitted far outside of what the device shows.
  Study s = steel_study(0.2, {{"finite_stop_pulse", {8e-5, 0.0}}}, 0.02);
  s.adhesive_energy.upper_J_m2 = 0.01;
  const Diagnosis d = diagnosed(s);
  EXPECT_NE(d.verdict, Verdict::missing_effect);
  EXPECT_FALSE(d.best.empty() || d.get(d.best).plausible);
}

}  // namespace
}  // namespace powderlink::analysis
