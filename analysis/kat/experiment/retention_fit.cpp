// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/retention_fit.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <utility>

namespace powderlink::analysis {

namespace {

constexpr double kLeastWidth = 0.003;  // 0.3 % of d_c: below it no microscope tells
constexpr double kLadder = 2.0;        // from rung to rung
constexpr int kBits = 12;              // of a refined width or diameter
constexpr boost::uintmax_t kMostTurns = 25;
constexpr double kGrid = 0.7;        // of the width: distance of the diameters tried
constexpr double kFewestSteps = 12;  // over the range, for wide widths

/// Largest value of f between low and high, and where.
template <class F>
std::pair<double, double> largest(const F& f, double low, double high) {
  boost::uintmax_t turns = kMostTurns;
  const auto [x, least] = boost::math::tools::brent_find_minima([&](double t) { return -f(t); },
                                                                low, high, kBits, turns);
  return {x, -least};
}

void keep_better(RetentionFit& best, const RetentionFit& other) {
  if (other.log_likelihood > best.log_likelihood) best = other;
}

/// The best diameter for one width within [low, high].
RetentionFit with_width(const RetentionLikelihood& l, double width, double low, double high) {
  const double steps = std::max(kFewestSteps, std::ceil((high - low) / (kGrid * width)));
  const double step = (high - low) / steps;
  RetentionFit best{low, width, l(low, width)};
  for (double i = 1.0; i <= steps; ++i)
    keep_better(best, {low + i * step, width, l(low + i * step, width)});
  const auto [at, value] = largest([&](double c) { return l(c, width); }, best.log_critical - step,
                                   best.log_critical + step);
  keep_better(best, {at, width, value});
  return best;
}

}  // namespace

RetentionSearch whole_search(const GrainSample& sample) {
  RetentionSearch s;
  s.log_low = sample.classes().front().log_diameter;
  s.log_high = sample.classes().back().log_diameter;
  const double widest = std::max(2.0 * kLeastWidth, s.log_high - s.log_low);
  for (double w = kLeastWidth; w < widest; w *= kLadder) s.widths.push_back(w);
  return s;
}

RetentionSearch search_around(const RetentionFit& fit, const GrainSample& sample) {
  constexpr double rungs = 4.0;  // factor of the width on either side
  constexpr double least = 0.1;  // of ln d_c on either side
  constexpr double reach = 2.0;  // widths
  const RetentionSearch whole = whole_search(sample);
  RetentionSearch s;
  const double half = std::max(least, reach * fit.width);
  s.log_low = std::max(whole.log_low, fit.log_critical - half);
  s.log_high = std::min(whole.log_high, fit.log_critical + half);
  const double centre = std::max(fit.width, kLeastWidth);
  for (const double w : whole.widths)
    if (w >= centre / rungs && w <= centre * rungs) s.widths.push_back(w);
  return s;
}

RetentionFit fit_truncation(const RetentionLikelihood& l) {
  const auto& classes = l.sample().classes();
  RetentionFit best{classes.front().log_diameter, 0.0,
                    l(classes.front().log_diameter, 0.0)};  // everything left
  for (std::size_t i = 0; i + 1 < classes.size(); ++i) {
    const double middle = 0.5 * (classes[i].log_diameter + classes[i + 1].log_diameter);
    keep_better(best, {middle, 0.0, l(middle, 0.0)});
  }
  return best;
}

RetentionFit fit_width(const RetentionLikelihood& l, const RetentionSearch& search) {
  RetentionFit best = fit_truncation(l);
  RetentionFit rung{0.0, 0.0, -INFINITY};
  for (const double w : search.widths)
    keep_better(rung, with_width(l, w, search.log_low, search.log_high));
  if (search.widths.empty()) return best;
  // Width refined, each time with the best diameter nearby.
  const double near = std::max(rung.width, kLeastWidth);
  RetentionFit at = rung;
  largest(
      [&](double log_width) {
        const double w = std::exp(log_width);
        const auto [c, value] = largest([&](double x) { return l(x, w); }, rung.log_critical - near,
                                        rung.log_critical + near);
        keep_better(at, {c, w, value});
        return value;
      },
      std::log(rung.width / kLadder), std::log(rung.width * kLadder));
  keep_better(best, at);
  return best;
}

RetentionFit fit_at(const RetentionLikelihood& l, const RetentionSearch& search, double critical) {
  RetentionFit best{critical, 0.0, l(critical, 0.0)};
  RetentionFit rung{critical, 0.0, -INFINITY};
  for (const double w : search.widths) keep_better(rung, {critical, w, l(critical, w)});
  if (search.widths.empty()) return best;
  const auto [log_width, value] =
      largest([&](double x) { return l(critical, std::exp(x)); }, std::log(rung.width / kLadder),
              std::log(rung.width * kLadder));
  keep_better(rung, {critical, std::exp(log_width), value});
  keep_better(best, rung);
  return best;
}

double width_evidence(const RetentionFit& ideal, const RetentionFit& width) {
  return 2.0 * (width.log_likelihood - ideal.log_likelihood);
}

}  // namespace powderlink::analysis
