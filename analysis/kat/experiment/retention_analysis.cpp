// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/retention_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "analysis/kat/experiment/pixel_scatter.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kStrayGrains = 0.25;  // moved, miscounted; keeps ln L finite
constexpr double kMostStrays = 0.5;
constexpr double kStrayThreshold = 6.635;  // chi^2, one degree of freedom, 1 %
constexpr std::size_t kFewestGrains = 20;
constexpr double kTooMany = 4.0;  // standard deviations of two Poisson counts
// 2 ln(L_max/L) of "nothing left". The top k of equal samples are all of one by a chance of 2^-k, that is
// exp(-x/2) for every place of d_c that the data tell apart, a few: below 1 %.
constexpr double kSeen = 12.0;
constexpr double kSeenWithLoss = 6.0;  // where the numbers alone say that grains left
constexpr double kJoin = 1e-3;         // of ln d, for the search of strays

void require_grains(const std::vector<double>& um, const char* when) {
  if (um.empty() && std::string(when) == "after") {
    throw InvalidInput("grains after the drop", "none: nothing remained on the plate",
                       "grains below and above d_c before the drop, and those below it after it",
                       "take a slower drop or finer powder");
  }
  if (um.size() < kFewestGrains) {
    throw InvalidInput(std::string("grains ") + when + " the drop", fmt::format("{}", um.size()),
                       fmt::format("{} or more", kFewestGrains),
                       "take more images, or check scale and threshold of the picture analysis");
  }
}

/// Standard deviations by which more were seen after than before per area.
double excess_sigmas(double before, double after, const RetentionOptions& o) {
  const double r = o.area_ratio.value_or(o.nominal_ratio);
  return (after - r * before) / std::sqrt(after + r * r * before);
}

/// Before any fit: more grains after than before per area.
void require_fewer_after(double before, double after, const RetentionOptions& o) {
  if (excess_sigmas(before, after, o) <= kTooMany) return;
  throw InvalidInput(
      "grains after the drop",
      fmt::format("{:.0f} after and {:.0f} before, for an area after of {:.3g} times that before",
                  after, before, o.area_ratio.value_or(o.nominal_ratio)),
      "no more grains per area after the drop than before",
      "exchange --before and --after, or give the areas seen: "
      "--area-ratio, or --fields-before and --fields-after");
}

/// The best share of strays, and what it gains in 2 ln L.
double fit_strays(const GrainSample& sample, const RetentionOptions& o, double least,
                  const RetentionFit& fit, double& gain) {
  constexpr int bits = 8;
  boost::uintmax_t turns = 20;
  const GrainSample joined = sample.joined(fit.log_critical, kJoin, kJoin);
  const auto loss = [&](double log_share) {
    const RetentionLikelihood l(joined, o.area_ratio, std::exp(log_share), o.pixel_um);
    return -fit_width(l, whole_search(joined)).log_likelihood;
  };
  const auto [at, value] = boost::math::tools::brent_find_minima(
      loss, std::log(least), std::log(kMostStrays), bits, turns);
  gain = 2.0 * (loss(std::log(least)) - value);
  return std::exp(at);
}

void require_seen(const RetentionLikelihood& l, const RetentionFit& fit,
                  const RetentionOptions& o) {
  const double before = l.sample().before();
  const double after = l.sample().after();
  const double needed = excess_sigmas(before, after, o) < -kTooMany ? kSeenWithLoss : kSeen;
  if (2.0 * (fit.log_likelihood - l(INFINITY, 0.0)) > needed) return;
  throw InvalidInput(
      "critical diameter",
      fmt::format("{:.0f} grains before and {:.0f} after, with the same distribution of sizes: "
                  "nothing left the plate, or what left does not depend on size",
                  before, after),
      "a drop after which large grains are missing",
      "take a faster drop, coarser powder or more images; "
      "check that the tables are those of before and after");
}

/// How much further from the value an end is for an error of its own.
double further(double distance, double shift) {
  const double before = std::max(0.0, distance);
  return std::hypot(before, shift) - before;
}

Estimate estimate(double log_value, const LogInterval& i, double pixel_um) {
  const double shift = kNormal95 * pixel_shift(log_value, pixel_um);
  return {std::exp(log_value), std::exp(i.low - further(log_value - i.low, shift)),
          std::exp(i.high + further(i.high - log_value, shift))};
}

/// The ideal truncation's d_c may lie beside a likelihood interval that has a gap.
LogInterval with(LogInterval i, double log_value) {
  return {std::min(i.low, log_value), std::max(i.high, log_value)};
}

void warn(RetentionAnalysis& a, const GrainSample& sample, const RetentionOptions& o) {
  if (a.strays_fitted) {
    a.warnings.push_back(
        fmt::format("{:.2g} % of the grains stay whatever their size: "
                    "dust, clumps read as one grain, or grains that do not touch the plate",
                    100.0 * a.strays));
  }
  if (!o.area_ratio) {
    const double tolerance = kTooMany * std::sqrt(1.0 / sample.before() + 1.0 / sample.after());
    if (std::fabs(std::log(a.area_ratio / o.nominal_ratio)) > tolerance) {
      a.warnings.push_back(
          fmt::format("small grains are {:.3g} times as many after as before, "
                      "where the numbers of files say {:.3g}: "
                      "other areas were seen, or grains of all sizes left; the first was taken",
                      a.area_ratio, o.nominal_ratio));
    }
    return;
  }
  const RetentionLikelihood free(sample, std::nullopt, a.strays, o.pixel_um);
  const RetentionFit& f = a.width;
  if (2.0 * (free(f.log_critical, f.width) - f.log_likelihood) > kStrayThreshold) {
    a.warnings.push_back(
        fmt::format("small grains are {:.3g} times as many after as before, "
                    "where the areas say {:.3g}: grains of all sizes left, or the areas are others",
                    free.area_ratio(f.log_critical, f.width), *o.area_ratio));
  }
}

}  // namespace

std::string RetentionAnalysis::decision() const {
  if (!smeared) {
    return fmt::format(
        "ideal truncation: "
        "a width gains {:.1f} in 2 ln L, which does not exclude it (up to {:.2f})",
        evidence, kStepThreshold);
  }
  return fmt::format(
      "smeared by {:.2g} % of d_c: the width gains {:.1f} in 2 ln L over an ideal truncation "
      "(more than {:.2f} excludes that at 5 %)",
      100.0 * width.width, evidence, kStepThreshold);
}

namespace {

RetentionAnalysis fitted(const GrainSample& sample, const RetentionOptions& o) {
  RetentionAnalysis a;
  a.before = sample.before();
  a.after = sample.after();
  const double least = kStrayGrains / a.before;
  a.strays = least;
  const RetentionLikelihood plain(sample, o.area_ratio, least, o.pixel_um);
  a.width = fit_width(plain, whole_search(sample));
  require_seen(plain, a.width, o);
  double gain = 0.0;
  const double strays = fit_strays(sample, o, least, a.width, gain);
  a.strays_fitted = gain > kStrayThreshold;
  if (a.strays_fitted) a.strays = strays;
  const RetentionLikelihood likelihood(sample, o.area_ratio, a.strays, o.pixel_um);
  if (a.strays_fitted) a.width = fit_width(likelihood, whole_search(sample));
  a.ideal = fit_truncation(likelihood);
  a.evidence = width_evidence(a.ideal, a.width);
  a.smeared = ideal_excluded(a.evidence);
  a.area_ratio = likelihood.area_ratio(a.fit().log_critical, a.fit().width);
  return a;
}

}  // namespace

RetentionAnalysis fit_retention(const std::vector<double>& before_um,
                                const std::vector<double>& after_um,
                                const RetentionOptions& options) {
  require_grains(before_um, "before");
  require_grains(after_um, "after");
  const GrainSample sample(before_um, after_um);
  require_fewer_after(sample.before(), sample.after(), options);
  RetentionAnalysis a = fitted(sample, options);
  warn(a, sample, options);
  return a;
}

RetentionAnalysis analyse_retention(const std::vector<double>& before_um,
                                    const std::vector<double>& after_um,
                                    const RetentionOptions& options) {
  RetentionAnalysis a = fit_retention(before_um, after_um, options);
  const GrainSample sample(before_um, after_um);
  const RetentionLikelihood likelihood(sample, options.area_ratio, a.strays, options.pixel_um);
  const RetentionIntervals i =
      retention_intervals(likelihood, a.width, options.bootstrap_turns, options.seed);
  a.critical =
      estimate(a.fit().log_critical, with(i.critical, a.fit().log_critical), options.pixel_um);
  a.half_point = estimate(a.width.log_critical, i.critical, options.pixel_um);
  a.truncation = estimate(a.ideal.log_critical, i.truncation, options.pixel_um);
  a.largest_remaining = {std::exp(sample.largest_after()), std::exp(i.largest_remaining.low),
                         std::exp(i.largest_remaining.high)};
  return a;
}

}  // namespace powderlink::analysis
