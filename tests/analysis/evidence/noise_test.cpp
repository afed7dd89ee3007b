// SPDX-License-Identifier: GPL-3.0-or-later
// How well each row was measured: told row by row, never for a whole study.
#include "analysis/evidence/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/evidence/candidate.h"
#include "analysis/evidence/comparison.h"
#include "analysis/kat/study/material_library.h"

namespace powderlink::analysis {
namespace {

constexpr double kEnergy = 90.0;
constexpr double kRounding = 1e-12;

Study steel() {
  Study s;
  s.file = "study.toml";
  s.particle = find_material("316L");
  s.substrate = find_material("borosilicate_glass");
  s.adhesive_energy = {0.001, 1000.0};
  return s;
}

double critical_um(const Study& s, double velocity) {
  return predicted_diameter_um(s, {{}, kEnergy}, KatRow{velocity});
}

KatRow drop(double velocity, double diameter_um) {
  KatRow row{velocity};
  row.critical_diameter_um = diameter_um;
  return row;
}

KatRow speed(double velocity, double diameter_um, double residual_m_s) {
  KatRow row{velocity};
  row.diameter_um = diameter_um;
  row.residual_velocity_m_s = residual_m_s;
  return row;
}

/// Classes of 200 grains around d_c at 2 m/s; share of those that stayed with ln Gamma scattered.
void add_counts(Study& s, double scatter) {
  const double critical = critical_um(s, 2.0);
  for (double ratio = 0.3; ratio < 3.4; ratio *= 1.2) {
    KatRow row{2.0};
    row.diameter_um = ratio * critical;
    row.count_before = 200.0;
    const double share = 0.5 * std::erfc(std::log(ratio) / scatter / std::sqrt(2.0));
    row.count_after = std::round(200.0 * share);
    s.rows.push_back(row);
  }
}

bool has_scatter(const std::vector<TrendTest>& tests) {
  return std::any_of(tests.begin(), tests.end(),
                     [](const TrendTest& t) { return t.test == "scatter"; });
}

TEST(Noise, IsToldRowByRow) {
  Study s = steel();
  s.rows = {drop(1.0, 100.0), drop(2.0, 50.0), speed(2.0, 80.0, 1.5), speed(4.0, 80.0, 3.0)};
  s.rows[0].critical_diameter_sigma_um = 2.0;
  s.rows[3].residual_velocity_sigma_m_s = 0.03;
  add_counts(s, 0.3);
  const Observations o = observe(s);
  EXPECT_EQ(o.list[0].origin, NoiseOrigin::stated);
  EXPECT_NEAR(o.list[0].noise, 0.02, kRounding);
  EXPECT_NEAR(o.list[0].sigma, std::hypot(0.02, s.model_discrepancy), kRounding);
  EXPECT_EQ(o.list[1].origin, NoiseOrigin::assumed);
  EXPECT_NEAR(o.list[1].sigma, kAssumedRelativeNoise, kRounding);
  EXPECT_EQ(o.list[2].origin, NoiseOrigin::assumed);
  EXPECT_NEAR(o.list[2].sigma, 0.05 * 2.0, kRounding);
  EXPECT_EQ(o.list[3].origin, NoiseOrigin::stated);
  EXPECT_EQ(o.list[4].origin, NoiseOrigin::counted);
  EXPECT_FALSE(o.known());
  for (const char* words : {"critical diameters: noise of the table (2 % on average)",
                            "critical diameters: no sigma in the table and no repeated drops: 5 %",
                            "residual speeds: no sigma in the table: 5 % of the impact velocity",
                            "residual speeds: noise of the table (0.03 m/s on average)",
                            "retained shares: counts of grains", "chi^2 is no test of rows"}) {
    EXPECT_NE(o.noise_text.find(words), std::string::npos) << words << " / " << o.noise_text;
  }
}

TEST(Noise, AnAssumptionTakesNothingFromOtherRows) {
  // Two unstated diameters on the model, and counts whose scatter it does not have.
  Study s = steel();
  for (const double v : {1.5, 3.0}) s.rows.push_back(drop(v, critical_um(s, v)));
  add_counts(s, 0.5);
  const Comparison c = compare(s, observe(s));
  EXPECT_TRUE(has_scatter(c.tests));
  EXPECT_EQ(c.verdict, Comparison::Verdict::fails) << "chi^2/dof " << c.chi2_per_dof;
}

TEST(Noise, AssumedSpeedsAreNoTest) {
  // v_res^2 = v^2 (1 - (d_c/d)^(5/3)) after an instant stop; up and down by two assumed sigmas.
  for (const bool stated : {false, true}) {
    Study s = steel();
    double off = 1.0;
    for (const double v : {1.5, 2.0, 3.0, 4.0}) {
      for (const double ratio : {1.3, 1.8}) {
        const double exact = v * std::sqrt(1.0 - std::pow(ratio, -5.0 / 3.0));
        s.rows.push_back(speed(v, ratio * critical_um(s, v), exact + 0.09 * v * off));
        if (stated) s.rows.back().residual_velocity_sigma_m_s = 0.05 * v;
        off = -off;
      }
      off = -off;
    }
    const Observations o = observe(s);
    EXPECT_EQ(o.known(), stated);
    const Comparison c = compare(s, o);
    EXPECT_GT(c.chi2_per_dof, 3.0);
    EXPECT_EQ(has_scatter(c.tests), stated);
    EXPECT_EQ(c.verdict == Comparison::Verdict::fails, stated);
  }
}

TEST(Noise, ScoreOfEachKindOnItsOwn) {
  Study s = steel();
  s.rows = {drop(1.0, 100.0), drop(2.0, 50.0), drop(3.0, 30.0), speed(2.0, 80.0, 1.5)};
  s.rows[0].critical_diameter_sigma_um = 2.0;
  const Observations o = observe(s);
  const double of_diameters = 4.0 * std::log(1.0 + (4.0 + 9.0) / 2.0);  // two rows and nu = 2
  const double of_speeds = 3.0 * std::log(1.0 + 16.0 / 2.0);
  EXPECT_NEAR(score(o, {1.0, 2.0, 3.0, 4.0}), 1.0 + of_diameters + of_speeds, kRounding);
}

TEST(Replicates, AreDropsThatDifferLessThanTheDeviceCanTell) {
  // As the device writes them. Two pairs and a triple; ln d = mean +- 0.01, and -0.02, 0, 0.02.
  const auto at = [](double v, double log_off) { return drop(v, 50.0 * std::exp(log_off)); };
  std::vector<KatRow> rows = {at(1.00001, 0.01), at(1.00004, -0.01), at(2.003, 0.01),
                              at(1.9987, -0.01), at(4.0001, -0.02),  at(4.0, 0.0),
                              at(4.0002, 0.02),  at(4.1, 0.3)};
  const TableNoise n = noise_of_unstated(rows);
  EXPECT_EQ(n.origin, NoiseOrigin::replicates);
  EXPECT_EQ(n.degrees_of_freedom, 4.0);
  // The assumption weighs two degrees of freedom.
  const double squares = 2.0 * 2e-4 + 8e-4;
  EXPECT_NEAR(n.mean, std::sqrt((squares + 2.0 * 0.05 * 0.05) / 6.0), kRounding);
}

TEST(Replicates, AreNotDropsUnderOtherConditions) {
  const auto with = [](auto change) {
    std::vector<KatRow> rows;
    for (int i = 0; i < 8; ++i) {
      rows.push_back(drop(2.0, 50.0 + i));
      change(rows.back(), i);
    }
    return noise_of_unstated(rows).degrees_of_freedom;
  };
  EXPECT_EQ(with([](KatRow&, int) {}), 7.0);
  EXPECT_EQ(with([](KatRow& r, int i) { r.contact_time_us = 50.0 * (1 + i % 2); }), 6.0);
  EXPECT_EQ(with([](KatRow& r, int i) { r.adhesive_energy_J_m2 = 0.1 + 0.01 * (i % 4); }), 4.0);
  EXPECT_EQ(with([](KatRow& r, int i) { r.contact_time_us = 100.0 + 0.2 * i; }), 7.0);
  EXPECT_EQ(with([](KatRow& r, int i) { r.impact_velocity_m_s += 0.02 * i; }), 0.0);
  EXPECT_EQ(with([](KatRow& r, int i) {
              r.impact_velocity_m_s += 0.02 * i;
              r.other["impact_velocity_sigma_m_s"] = 0.2;
            }),
            7.0);
}

}  // namespace
}  // namespace powderlink::analysis
