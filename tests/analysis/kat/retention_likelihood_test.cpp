// SPDX-License-Identifier: GPL-3.0-or-later
// Likelihood of a retained fraction against its definition, and its largest value.
#include "analysis/kat/experiment/retention_likelihood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/kat/experiment/retention_fit.h"
#include "tests/analysis/kat/retention_sample.h"

namespace powderlink::analysis {
namespace {

constexpr double kRounding = 1e-9;

double plain_likelihood(const RetentionSample& s, double critical, double w, double r, double e) {
  const auto share = [&](double d) {
    const double x = (std::log(d) - critical) / (std::sqrt(2.0) * w);
    return e + (1.0 - e) * 0.5 * std::erfc(x);
  };
  double sum = 0.0;
  for (const double d : s.after_um) sum += std::log(r * share(d) / (1.0 + r * share(d)));
  for (const double d : s.before_um) sum -= std::log1p(r * share(d));
  return sum;
}

TEST(RetentionLikelihood, IsItsDefinition) {
  const RetentionSample s = draw_sample({46.0, 0.1, 200}, 3);
  const GrainSample sample(s.before_um, s.after_um);
  const double e = 1e-3;
  for (const double critical : {30.0, 46.0, 60.0}) {
    for (const double w : {0.05, 0.3}) {
      const double expected = plain_likelihood(s, std::log(critical), w, 0.8, e);
      const RetentionLikelihood l(sample, 0.8, e);
      // Beyond five widths Phi is taken as 0 or 1: 3e-7 per grain.
      EXPECT_NEAR(l(std::log(critical), w), expected, 3e-7 * sample.count() / e);
    }
  }
}

TEST(RetentionLikelihood, TheFreeAreaRatioIsTheBestOne) {
  const RetentionSample s = draw_sample({46.0, 0.1, 200}, 4);
  const GrainSample sample(s.before_um, s.after_um);
  const RetentionLikelihood free(sample, std::nullopt, 1e-3);
  const double r = free.area_ratio(std::log(46.0), 0.1);
  const double best = free(std::log(46.0), 0.1);
  EXPECT_NEAR(RetentionLikelihood(sample, r, 1e-3)(std::log(46.0), 0.1), best, kRounding);
  for (const double factor : {0.99, 1.01})
    EXPECT_LT(RetentionLikelihood(sample, factor * r, 1e-3)(std::log(46.0), 0.1), best);
}

TEST(RetentionLikelihood, OfATruncationIsThatOfCounts) {
  // 5 before and 3 after below d_c, 4 before above: r = 3/5 and binomial with 3/8 below.
  const GrainSample sample({1, 2, 3, 4, 5, 11, 12, 13, 14}, {1.5, 2.5, 9});
  const double e = 1e-12;
  const double expected = 3 * std::log(3.0 / 8.0) + 5 * std::log(5.0 / 8.0);
  const RetentionLikelihood l(sample, std::nullopt, e);
  EXPECT_NEAR(l(std::log(10.0), 0.0), expected, kRounding);
  EXPECT_NEAR(l.area_ratio(std::log(10.0), 0.0), 0.6, kRounding);
  // The largest likelihood is in the gap above the last grain that stayed.
  const double best = std::exp(fit_truncation(l).log_critical);
  EXPECT_GT(best, 9.0);
  EXPECT_LT(best, 11.0);
}

TEST(RetentionLikelihood, AWidthOfZeroIsTheLimit) {
  const RetentionSample s = draw_sample({46.0, 0.1, 100}, 5);
  const GrainSample sample(s.before_um, s.after_um);
  const RetentionLikelihood l(sample, std::nullopt, 1e-3);
  EXPECT_NEAR(l(std::log(46.01), 1e-9), l(std::log(46.01), 0.0), kRounding);
}

TEST(GrainSample, JoinedClassesKeepGrainsAndSides) {
  const RetentionSample s = draw_sample({46.0, 0.1, 500}, 6);
  const GrainSample sample(s.before_um, s.after_um);
  const GrainSample joined = sample.joined(std::log(46.0), 0.02, 0.05);
  EXPECT_LT(joined.classes().size(), sample.classes().size() / 3);
  EXPECT_EQ(joined.before(), sample.before());
  EXPECT_EQ(joined.after(), sample.after());
  EXPECT_EQ(joined.before_of(joined.below(std::log(46.0))),
            sample.before_of(sample.below(std::log(46.0))));
}

TEST(RetentionFit, ComesBackFromManyGrains) {
  RetentionTruth t{46.0, 0.12, 20000};
  t.area_ratio = 0.5;
  const RetentionSample s = draw_sample(t, 7);
  const GrainSample sample(s.before_um, s.after_um);
  const RetentionLikelihood l(sample, std::nullopt, 1e-5);
  const RetentionFit fit = fit_width(l, whole_search(sample));
  // About 3 000 grains within a width of d_c: 1 % of d_c, 3 % of the width, 2 % of the ratio.
  EXPECT_NEAR(std::exp(fit.log_critical) / 46.0, 1.0, 0.02);
  EXPECT_NEAR(fit.width / 0.12, 1.0, 0.15);
  EXPECT_NEAR(l.area_ratio(fit.log_critical, fit.width), 0.5, 0.03);
  EXPECT_TRUE(ideal_excluded(width_evidence(fit_truncation(l), fit)));
}

}  // namespace
}  // namespace powderlink::analysis
