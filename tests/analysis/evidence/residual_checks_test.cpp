// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals over every column: alarms where there is something, and hardly ever where there is not.
#include "analysis/evidence/residual_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/evidence/comparison.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// Twelve drops of known noise; contact times and Gamma of their own, in other orders than v.
Observations twelve_drops() {
  Observations o;
  for (int i = 0; i < 12; ++i) {
    KatRow row{1.0 + 0.4 * i};
    row.critical_diameter_um = 50.0;
    row.contact_time_us = 60.0 + (5 * i) % 12;
    row.adhesive_energy_J_m2 = 0.1 + 0.01 * ((7 * i) % 12);
    row.other["humidity"] = 20.0 + (11 * i + 3) % 12;
    o.list.push_back({row, 50.0, 0.02, 0.02, NoiseOrigin::stated});
  }
  return o;
}

FitSolution nothing_fitted(const std::vector<double>& residuals) {
  FitSolution s;
  s.residuals = residuals;
  s.jacobian.resize(static_cast<long>(residuals.size()), 0);
  return s;
}

std::vector<TrendTest> tests_of(const Observations& o, const std::vector<double>& residuals) {
  return residual_tests(o, std::vector<double>(residuals.size(), 50.0), nothing_fitted(residuals));
}

const TrendTest* find(const std::vector<TrendTest>& tests, const std::string& variable,
                      const std::string& test) {
  for (const TrendTest& t : tests) {
    if (t.variable == variable && t.test == test) return &t;
  }
  return nullptr;
}

TEST(ResidualTests, AlarmsOverAllColumnsAreNoMoreThanTheySay) {
  const Observations o = twelve_drops();
  std::mt19937_64 random(23);
  std::normal_distribution<double> normal;
  constexpr int sets = 4000;
  int counted = 0, told = 0;
  for (int i = 0; i < sets; ++i) {
    std::vector<double> r;
    for (int j = 0; j < 12; ++j) r.push_back(normal(random));
    const std::vector<TrendTest> tests = tests_of(o, r);
    counted += residuals_fail(tests, r, o) ? 1 : 0;
    told += std::any_of(tests.begin(), tests.end(),
                        [](const TrendTest& t) { return !t.counts && t.p_corrected < kAlarm; });
  }
  const double four_deviations = 4.0 * std::sqrt(sets * kAlarm * (1.0 - kAlarm));
  EXPECT_LT(counted, sets * kAlarm + four_deviations);
  EXPECT_GT(counted, 0.3 * sets * kAlarm) << "and they do not sleep";
  EXPECT_LT(told, sets * kAlarm + four_deviations);
}

TEST(ResidualTests, EveryColumnHasRankAndRuns) {
  const Observations o = twelve_drops();
  for (const char* column : {"contact_time_us", "adhesive_energy_J_m2", "humidity"}) {
    SCOPED_TRACE(column);
    // Residuals that follow this column alone; small, so that scatter says nothing.
    std::vector<double> r;
    for (const Observation& each : o.list) {
      const KatRow& row = each.row;
      const std::string name = column;
      const double x = name == "contact_time_us" ? *row.contact_time_us - 65.5
                       : name == "adhesive_energy_J_m2"
                           ? 100.0 * (*row.adhesive_energy_J_m2 - 0.155)
                           : row.other.at("humidity") - 25.5;
      r.push_back(0.1 * x);
    }
    const std::vector<TrendTest> tests = tests_of(o, r);
    ASSERT_NE(find(tests, column, "rank"), nullptr);
    ASSERT_NE(find(tests, column, "runs"), nullptr);
    EXPECT_LT(find(tests, column, "rank")->p_value, 1e-6);
    EXPECT_NEAR(find(tests, column, "runs")->p_value, 2.0 / 924.0, 1e-12);  // of C(12, 6)
    const bool known = std::string(column) != "humidity";
    EXPECT_EQ(residuals_fail(tests, r, o), known) << "unknown columns are told, no more";
    EXPECT_LT(find(tests, column, "rank")->p_corrected, kAlarm);
  }
}

TEST(ResidualTests, ColumnsOfSomeTablesAreTestedOnTheirRows) {
  const TestFolder folder;
  folder.write("a.csv",
               "impact_velocity_m_s,critical_diameter_um,humidity\n1,90,20\n2,39,40\n3,24,30\n"
               "4,17,50\n5,13,25\n");
  folder.write("b.csv",
               "impact_velocity_m_s,diameter_um,residual_velocity_m_s\n2,80,1.5\n2,90,1.6\n"
               "3,80,2.6\n3,90,2.7\n");
  const Study s = read_study(folder.write(
      "s.toml",
      "[study]\nexperiment = \"kat_critical_diameter\"\nmeasurements = [\"a.csv\", \"b.csv\"]\n"
      "[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n"
      "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n"));
  const Comparison c = compare(s, observe(s));
  EXPECT_NE(find(c.tests, "humidity", "rank"), nullptr);
  EXPECT_NE(find(c.tests, "diameter_um", "rank"), nullptr) << "although drops have none";
  EXPECT_NE(observe(s).noise_text.find("of b.csv: no sigma"), std::string::npos);
}

TEST(ResidualTests, AKnownSignIsNoTrend) {
  // Ten classes far from d_c, as a right model has them: small grains all stay, large ones all leave.
  Observations o;
  std::vector<double> model, r;
  for (int i = 0; i < 10; ++i) {
    KatRow row{2.0};
    row.diameter_um = 10.0 * (i + 1);
    row.count_before = 100.0;
    row.count_after = i < 5 ? 100.0 : 0.0;
    o.list.push_back({row, i < 5 ? 1.0 : 0.0, 0.01, 0.01, NoiseOrigin::counted});
    model.push_back(i < 5 ? 0.9975 : 0.0025);
    r.push_back(residual(o.list.back(), model.back()));
  }
  const std::vector<TrendTest> tests = residual_tests(o, model, nothing_fitted(r));
  EXPECT_LT(rank_p_value({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, r), 0.01) << "it would alarm";
  EXPECT_FALSE(residuals_fail(tests, r, o));
}

TEST(ResidualTests, DegreesOfFreedomAreThoseOfTheRowsWithKnownNoise) {
  // One common value fitted to six rows of equal weight takes 1/6 from each.
  FitSolution s = nothing_fitted({1, -1, 1, -1, 1, -1});
  s.jacobian = Eigen::MatrixXd::Ones(6, 1);
  s.values = {0.0};
  Observations o = twelve_drops();
  o.list.resize(6);
  for (std::size_t i = 0; i < 3; ++i) o.list[i].origin = NoiseOrigin::assumed;
  const std::vector<TrendTest> tests = residual_tests(o, std::vector<double>(6, 50.0), s);
  EXPECT_NEAR(find(tests, "impact_velocity_m_s", "scatter")->p_value,
              scatter_p_value({1, -1, 1}, 0.5), 1e-12);
}

}  // namespace
}  // namespace powderlink::analysis
