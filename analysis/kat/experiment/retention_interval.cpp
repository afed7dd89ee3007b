// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/retention_interval.h"

#include <algorithm>
#include <boost/random/binomial_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <vector>

namespace powderlink::analysis {

namespace {

// Classes of the joined sample: a fortieth of the width, and coarser away from d_c.
constexpr double kResolution = 1.0 / 40.0;
constexpr double kGrowth = 0.03;
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * (static_cast<double>(values.size()) - 1.0);
  const auto i = static_cast<std::size_t>(at);
  const double rest = at - static_cast<double>(i);
  return i + 1 < values.size() ? (1.0 - rest) * values[i] + rest * values[i + 1] : values[i];
}

/// A new draw of which grains were seen after; every diameter anywhere on its half of the way to its
/// neighbours, since d_c may lie anywhere between two grains.
template <class Random>
GrainSample drawn(const RetentionLikelihood& likelihood, const RetentionFit& fit, double ratio,
                  Random& random) {
  const std::vector<GrainClass>& old = likelihood.sample().classes();
  const double strays = likelihood.strays();
  const double width = likelihood.seen_width(fit.log_critical, fit.width);
  std::vector<GrainClass> classes = old;
  boost::random::uniform_01<double> part;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    GrainClass& c = classes[i];
    const double at = part(random) - 0.5;
    const std::size_t neighbour = at < 0.0 ? i - (i > 0 ? 1 : 0) : std::min(i + 1, old.size() - 1);
    c.log_diameter += std::fabs(at) * (old[neighbour].log_diameter - old[i].log_diameter);
    const double share =
        strays + (1.0 - strays) * retained_fraction(c.log_diameter, fit.log_critical, width);
    const double p = ratio * share / (1.0 + ratio * share);
    const double n = c.count();
    boost::random::binomial_distribution<int, double> draw(static_cast<int>(n), p);
    c.after = draw(random);
    c.before = n - c.after;
  }
  return GrainSample(std::move(classes));
}

/// One end of {c : fall(c) <= threshold} (sign -1 or 1): outwards in growing strides as far as it may
/// come back, then bisected.
template <class Fall>
double interval_end(const Fall& fall, double centre, double limit, double threshold) {
  constexpr double first_stride = 2e-4;
  constexpr double growth = 1.15;
  constexpr double far = 4.0;  // times the threshold: it does not come back from there
  constexpr int bisections = 20;
  const double sign = limit < centre ? -1.0 : 1.0;
  double inside = centre;
  double outside = limit;
  double stride = first_stride;
  for (double c = centre; sign * (limit - c) > 0.0; stride *= growth) {
    c += sign * std::min(stride, sign * (limit - c));
    const double fallen = fall(c);
    if (fallen <= threshold) {
      inside = c;
      outside = limit;
    } else if (sign * (outside - c) > 0.0) {
      outside = c;
    }
    if (fallen > far * threshold) break;
  }
  if (inside == limit) return limit;
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (inside + outside);
    (fall(middle) <= threshold ? inside : outside) = middle;
  }
  return inside;
}

template <class Fall>
LogInterval interval(const Fall& fall, double centre, const RetentionSearch& s, double threshold) {
  return {interval_end(fall, centre, s.log_low, threshold),
          interval_end(fall, centre, s.log_high, threshold)};
}

}  // namespace

RetentionIntervals retention_intervals(const RetentionLikelihood& likelihood,
                                       const RetentionFit& fit, int turns, std::uint32_t seed) {
  const double centre = fit.log_critical;
  const double ratio = likelihood.area_ratio(centre, fit.width);
  const double seen = likelihood.seen_width(centre, fit.width);
  const GrainSample sample = likelihood.sample().joined(centre, kResolution * seen, kGrowth);
  const RetentionLikelihood joined(sample, likelihood.fixed_ratio(), likelihood.strays(),
                                   likelihood.pixel_um());
  const RetentionSearch near = search_around(fit, sample);

  boost::random::mt19937 random(seed);
  std::vector<double> fallen, largest;
  for (int turn = 0; turn < turns; ++turn) {
    const GrainSample repeated = drawn(joined, fit, ratio, random);
    if (repeated.after() == 0.0 || repeated.before() == 0.0) continue;
    const RetentionLikelihood l(repeated, joined.fixed_ratio(), joined.strays(), joined.pixel_um());
    fallen.push_back(2.0 *
                     (fit_width(l, near).log_likelihood - fit_at(l, near, centre).log_likelihood));
    largest.push_back(repeated.largest_after());
  }

  RetentionIntervals i;
  const RetentionFit truncation = fit_truncation(joined);
  const RetentionFit best = fit_width(joined, near);
  const bool smeared = ideal_excluded(width_evidence(truncation, best));
  i.threshold =
      std::max(quantile(fallen, kConfidence), smeared ? kSmoothThreshold : kStepThreshold);
  const RetentionSearch whole = whole_search(sample);
  const auto fall = [&](double c) {
    return 2.0 * (best.log_likelihood - fit_at(joined, whole, c).log_likelihood);
  };
  i.critical = interval(fall, best.log_critical, whole, i.threshold);
  // Not joined: its steps are at single grains, and its ln L costs next to nothing.
  const RetentionFit ideal = fit_truncation(likelihood);
  const auto fall_of_truncation = [&](double c) {
    return 2.0 * (ideal.log_likelihood - likelihood(c, 0.0));
  };
  i.truncation = interval(fall_of_truncation, ideal.log_critical, whole, kStepThreshold);
  constexpr double tail = 0.5 * (1.0 - kConfidence);
  const double last = sample.largest_after();
  i.largest_remaining = {last + centre - quantile(largest, 1.0 - tail),
                         last + centre - quantile(largest, tail)};
  return i;
}

}  // namespace powderlink::analysis
