// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of residuals against exact values and against their own false-alarm rates.
#include "base/statistics/trends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/evidence/patterns.h"

namespace powderlink::analysis {
namespace {

const std::vector<double> kX = {1, 2, 3, 4, 5, 6, 7, 8};
constexpr double kRounding = 1e-12;

TEST(Trends, ExactValuesOfSmallSamples) {
  // A monotone order of n ranks: two of n! permutations are as extreme.
  EXPECT_NEAR(rank_p_value({1, 2, 3, 4, 5}, {-2, -1, 0, 1, 2}), 2.0 / 120.0, kRounding);
  // Two runs of 4 + 4: 2 of C(8, 4) = 70 arrangements.
  EXPECT_NEAR(runs_p_value(kX, {-1, -1, -1, -1, 1, 1, 1, 1}), 2.0 / 70.0, kRounding);
  EXPECT_NEAR(runs_p_value(kX, {-1, 1, -1, 1, -1, 1, -1, 1}), 1.0, kRounding);
  // chi^2 with 2 degrees of freedom: p = exp(-x/2).
  EXPECT_NEAR(scatter_p_value({1, 1, 2}, 1), std::exp(-3.0), kRounding);
  EXPECT_EQ(scatter_p_value({1, 1}, 2), 1.0) << "no degree of freedom, no test";
}

/// Normal limit of the number of runs among a positive and b negative signs, with continuity.
double runs_p_of_large_samples(double a, double b, double runs) {
  const double n = a + b;
  const double mean = 1.0 + 2.0 * a * b / n;
  const double variance = (mean - 1.0) * (mean - 2.0) / (n - 1.0);
  return 0.5 * std::erfc(-(runs + 0.5 - mean) / std::sqrt(2.0 * variance));
}

TEST(Trends, ManyRowsFollowTheNormalLimit) {
  constexpr int n = 2000;
  std::vector<double> x, r;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  double before = 0.0;
  for (int i = 0; i < n; ++i) {
    x.push_back(1.0 + i);
    before = 0.03 * before + normal(random);  // neighbours agree a little
    r.push_back(before);
  }
  int plus = 0, runs = 1;
  for (std::size_t i = 0; i < r.size(); ++i) {
    plus += r[i] > 0.0;
    runs += i > 0 && (r[i] > 0.0) != (r[i - 1] > 0.0);
  }
  constexpr double limit = 2e-3;  // what is left of 1/n behind the continuity correction
  EXPECT_NEAR(runs_p_value(x, r), runs_p_of_large_samples(plus, n - plus, runs), limit);
  std::vector<double> halves(n, -1.0);
  std::fill(halves.begin() + n / 2, halves.end(), 1.0);
  EXPECT_LT(runs_p_value(x, halves), 1e-300) << "2 of C(2000, 1000) arrangements";
  EXPECT_GT(runs_p_value(x, r), 0.0);
}

TEST(Trends, CurveTakesOffAParabolaInTheLogarithm) {
  std::vector<double> r;
  for (const double x : kX) r.push_back(2.0 * std::log(x) - std::pow(std::log(x), 2));
  double sum = 0.0;
  double mean = 0.0;
  for (const double v : r) mean += v / 8.0;
  for (const double v : r) sum += (v - mean) * (v - mean);
  EXPECT_NEAR(curve_p_value(kX, r, true), std::exp(-0.5 * sum), 1e-9);
  EXPECT_LT(curve_p_value(kX, r, false), 1e-6) << "no scatter is left";
}

TEST(Trends, AlarmsAreAsFrequentAsTheySay) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int sets = 4000;
  constexpr double level = 0.05;
  int curve_known = 0, curve_unknown = 0, rank = 0, runs = 0, any = 0;
  for (int i = 0; i < sets; ++i) {
    std::vector<double> r;
    for (std::size_t j = 0; j < kX.size(); ++j) r.push_back(normal(random));
    curve_known += curve_p_value(kX, r, true) < level;
    curve_unknown += curve_p_value(kX, r, false) < level;
    if (i < 400) rank += rank_p_value(kX, r) < level;  // 40 320 permutations each
    runs += runs_p_value(kX, r) < level;
    std::vector<TrendTest> tests = {{"x", "scatter", scatter_p_value(r, 0)},
                                    {"x", "curve", curve_p_value(kX, r, true)},
                                    {"x", "runs", runs_p_value(kX, r)}};
    correct_for_number(tests);
    any += least_p_value(tests) < level;
  }
  // Four standard deviations of a binomial count.
  const auto bound = [&](int n) { return 4.0 * std::sqrt(n * level * (1 - level)); };
  EXPECT_NEAR(curve_known, level * sets, bound(sets));
  EXPECT_NEAR(curve_unknown, level * sets, bound(sets));
  EXPECT_LT(rank, level * 400 + bound(400)) << "discrete: at most the level";
  EXPECT_LT(runs, level * sets + bound(sets));
  EXPECT_LT(any, level * sets + bound(sets)) << "Holm keeps the level of the family";
  EXPECT_GT(any, 0.3 * level * sets) << "and does not sleep";
}

TEST(Trends, HolmByHand) {
  std::vector<TrendTest> tests = {
      {"x", "a", 0.04}, {"x", "b", 0.01}, {"x", "c", 0.03}, {"y", "told", 1e-9, 1.0, false}};
  correct_for_number(tests);
  EXPECT_NEAR(tests[1].p_corrected, 0.03, kRounding);
  EXPECT_NEAR(tests[2].p_corrected, 0.06, kRounding);
  EXPECT_NEAR(tests[0].p_corrected, 0.06, kRounding) << "never below a smaller p-value's";
  EXPECT_NEAR(least_p_value(tests), 0.03, kRounding) << "what does not count is left out";
}

TEST(Patterns, FindsTheStepAndTheWaveThatAreThere) {
  std::vector<double> v, step, wave, sigma;
  for (int i = 0; i < 12; ++i) {
    v.push_back(1.0 + 0.5 * i);
    sigma.push_back(0.03);
    // residual: (model/measured - 1)/sigma
    step.push_back((1.0 / (v.back() > 3.2 ? 1.2 : 1.0) - 1.0) / 0.03);
    wave.push_back((1.0 / (1.0 + 0.2 * std::sin(2 * M_PI * v.back() / 2.75)) - 1.0) / 0.03);
  }
  const auto of_step = foreign_patterns(v, step, sigma);
  ASSERT_EQ(of_step.size(), 2U);
  EXPECT_LT(of_step[0].chi2, 1e-12);
  EXPECT_EQ(of_step[0].text, "a step of +20 % between 3 and 3.5 m/s");
  const auto of_wave = foreign_patterns(v, wave, sigma);
  // The logarithm of 1 + 0.2 sin is not quite a sine: 0.02 at most, 0.7 sigma.
  EXPECT_LT(of_wave[1].chi2, 12 * 0.7 * 0.7);
  EXPECT_GT(of_wave[0].chi2, 10 * of_wave[1].chi2);
}

}  // namespace
}  // namespace powderlink::analysis
