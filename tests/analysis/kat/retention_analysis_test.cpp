// SPDX-License-Identifier: GPL-3.0-or-later
// Which shape is decided for, strays, counts per area, what is refused, classes of size.
#include "analysis/kat/experiment/retention_analysis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/kat/experiment/retention_classes.h"
#include "tests/analysis/kat/retention_sample.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

RetentionAnalysis analyse(const RetentionSample& s, const RetentionOptions& o = {}) {
  return analyse_retention(s.before_um, s.after_um, o);
}

TEST(RetentionAnalysis, DecidesByLikelihoodAndSaysWhy) {
  const RetentionAnalysis sharp = analyse(draw_sample({46.0, 0.0, 1500}, 11));
  EXPECT_FALSE(sharp.smeared);
  EXPECT_NE(sharp.decision().find("ideal truncation"), std::string::npos);
  EXPECT_EQ(sharp.critical.value, sharp.truncation.value);
  const RetentionAnalysis wide = analyse(draw_sample({46.0, 0.2, 1500}, 11));
  EXPECT_TRUE(wide.smeared);
  EXPECT_NE(wide.decision().find("smeared"), std::string::npos);
  EXPECT_EQ(wide.critical.value, wide.half_point.value);
  EXPECT_GT(wide.largest_remaining.value, wide.half_point.high);
}

TEST(RetentionAnalysis, IsDeterministic) {
  const RetentionSample s = draw_sample({46.0, 0.1, 500}, 12);
  EXPECT_EQ(analyse(s).critical.low, analyse(s).critical.low);
}

TEST(RetentionAnalysis, StraysAreNamedAndDoNotMoveTheCriticalDiameter) {
  RetentionSample s = draw_sample({46.0, 0.02, 1500}, 13);
  for (int i = 0; i < 12; ++i) s.after_um.push_back(60.0 + 5.0 * i);  // dust
  const RetentionAnalysis a = analyse(s);
  EXPECT_TRUE(a.strays_fitted);
  EXPECT_LE(a.critical.low, 46.0);
  EXPECT_GE(a.critical.high, 46.0);
  EXPECT_LT(a.width.width, 0.1);
  ASSERT_FALSE(a.warnings.empty());
  EXPECT_NE(a.warnings[0].find("whatever their size"), std::string::npos);
}

TEST(RetentionAnalysis, AGivenAreaRatioThatSmallGrainsContradictIsTold) {
  const RetentionSample s = draw_sample({46.0, 0.1, 1500}, 14);
  RetentionOptions o;
  o.area_ratio = 1.6;
  const RetentionAnalysis a = analyse(s, o);
  ASSERT_FALSE(a.warnings.empty());
  EXPECT_NE(a.warnings.back().find("where the areas say 1.6"), std::string::npos);
}

TEST(RetentionAnalysis, RefusesWhatShowsNoCriticalDiameter) {
  const RetentionSample s = draw_sample({46.0, 0.0, 500}, 15);
  expect_refusal([&] { analyse_retention(s.before_um, {}, {}); }, {"nothing remained"});
  const RetentionSample all = draw_sample({1000.0, 0.0, 500}, 16);
  expect_refusal([&] { analyse(all); }, {"nothing left the plate"});
  expect_refusal([&] { analyse_retention(s.after_um, s.before_um, {}); }, {"exchange --before"});
  RetentionOptions o;
  o.area_ratio = 0.2;
  expect_refusal([&] { analyse(s, o); }, {"no more grains per area"});
  expect_refusal([&] { analyse_retention({40.0, 50.0}, s.after_um, {}); }, {"20 or more"});
}

TEST(RetentionClasses, HoldEveryGrainOnceAndEnoughBefore) {
  const RetentionSample s = draw_sample({46.0, 0.1, 700}, 17);
  double before = 0.0, after = 0.0, last = 0.0;
  for (const RetentionClass& c : retention_classes(s.before_um, s.after_um)) {
    EXPECT_GE(c.before, kFewestBefore);
    if (last > 0.0) {
      EXPECT_NEAR(c.low_um / last, 1.0, 1e-12);
    }
    last = c.high_um;
    before += c.before;
    after += c.after;
    EXPECT_LE(c.fraction_low(1.0), c.fraction(1.0));
    EXPECT_GE(c.fraction_high(1.0), c.fraction(1.0));
  }
  EXPECT_EQ(before, 700.0);
  EXPECT_EQ(after, static_cast<double>(s.after_um.size()));
}

}  // namespace
}  // namespace powderlink::analysis
