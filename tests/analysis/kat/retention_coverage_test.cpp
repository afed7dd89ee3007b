// SPDX-License-Identifier: GPL-3.0-or-later
// How often the 95 % interval of d_c holds it: sizes, numbers, widths and area ratios at random.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/kat/experiment/retention_analysis.h"
#include "tests/analysis/kat/retention_sample.h"

namespace powderlink::analysis {
namespace {

constexpr int kCases = 100;
/// Of 95 expected; 90 or fewer come by chance in 3 % of such tests.
constexpr int kFewestInside = 90;

class Coverage : public testing::TestWithParam<double> {};

TEST_P(Coverage, TheIntervalHoldsTheTruth) {
  int inside = 0;
  int inside_largest = 0;
  for (unsigned k = 0; k < kCases; ++k) {
    std::mt19937_64 random(977 * k + static_cast<unsigned>(1e4 * GetParam()));
    std::uniform_real_distribution<double> part;
    RetentionTruth t;
    t.width = GetParam();
    t.grains = static_cast<int>(200.0 * std::pow(10.0, part(random)));  // 200 to 2000
    t.critical_um = 20.0 * std::pow(4.0, part(random));
    t.median_um = t.critical_um * (0.75 + 0.35 * part(random));
    t.area_ratio = 0.7 + 0.8 * part(random);
    const RetentionSample s = draw_sample(t, k + 1);
    RetentionOptions options;
    options.bootstrap_turns = 100;
    const RetentionAnalysis a = analyse_retention(s.before_um, s.after_um, options);
    inside += a.critical.low <= t.critical_um && t.critical_um <= a.critical.high ? 1 : 0;
    inside_largest +=
        a.largest_remaining.low <= t.critical_um && t.critical_um <= a.largest_remaining.high ? 1
                                                                                              : 0;
    EXPECT_LE(a.critical.low, a.critical.value);
    EXPECT_GE(a.critical.high, a.critical.value);
  }
  RecordProperty("inside", inside);
  RecordProperty("inside_largest", inside_largest);
  EXPECT_GE(inside, kFewestInside);
}

/// Diameter of the pixels whose centres are in a disk at a random place; all lengths in pixels.
double on_pixels(double d, std::mt19937_64& random) {
  std::uniform_real_distribution<double> part;
  const double x = part(random);
  const double y = part(random);
  const double r = 0.5 * d;
  int count = 0;
  for (int i = static_cast<int>(-r - 1); i <= static_cast<int>(r + 2); ++i) {
    const double square = r * r - (i - x) * (i - x);
    if (square <= 0.0) continue;
    const double half = std::sqrt(square);
    count += static_cast<int>(std::floor(y + half) - std::ceil(y - half)) + 1;
  }
  return std::sqrt(std::max(1, count) * 4.0 / M_PI);
}

class PixelCoverage : public testing::TestWithParam<double> {};

/// An ideal truncation on pixels of 1 um. So many grains show where it is better than one grain does;
/// taken as exact, half of the intervals miss it at 10 pixels.
TEST_P(PixelCoverage, TheIntervalKnowsThePixels) {
  constexpr int cases = 20;
  constexpr int fewest_inside = 17;  // of 19 expected; 16 or fewer come by chance in 2 %
  int inside = 0;
  for (unsigned k = 0; k < cases; ++k) {
    std::mt19937_64 random(131 * k + 7);
    std::uniform_real_distribution<double> part;
    RetentionTruth t;
    t.grains = 20000;
    t.critical_um = GetParam() * (0.9 + 0.2 * part(random));
    t.median_um = t.critical_um * (0.85 + 0.2 * part(random));
    t.spread = 0.3;
    RetentionSample s = draw_sample(t, k + 1);
    for (auto* list : {&s.before_um, &s.after_um})
      for (double& d : *list) d = on_pixels(d, random);
    RetentionOptions options;
    options.bootstrap_turns = 50;
    options.pixel_um = 1.0;
    const RetentionAnalysis a = analyse_retention(s.before_um, s.after_um, options);
    inside += a.critical.low <= t.critical_um && t.critical_um <= a.critical.high ? 1 : 0;
  }
  EXPECT_GE(inside, fewest_inside);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PixelCoverage, testing::Values(10.0, 19.0));

INSTANTIATE_TEST_SUITE_P(Widths, Coverage, testing::Values(0.0, 0.01, 0.05, 0.15, 0.3));

}  // namespace
}  // namespace powderlink::analysis
