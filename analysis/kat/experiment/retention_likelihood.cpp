// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/retention_likelihood.h"

#include <algorithm>
#include <cmath>

#include "analysis/kat/experiment/pixel_scatter.h"

namespace powderlink::analysis {

namespace {

constexpr double kTail = 5.0;  // widths: Phi differs from 0 or 1 by 3e-7 there, less than any stray
constexpr int kMostTurns = 30;
constexpr double kEnough = 1e-9;  // of ln r
constexpr double kHalf = 0.5;     // grains: keeps the start finite where a sample has none

}  // namespace

double retained_fraction(double log_diameter, double log_critical, double width) {
  if (width <= 0.0) return log_diameter < log_critical ? 1.0 : 0.0;
  return 0.5 * std::erfc((log_diameter - log_critical) / (std::sqrt(2.0) * width));
}

struct RetentionLikelihood::Split {
  std::size_t first = 0, end = 0;              // classes in between
  double before_low = 0.0, after_low = 0.0;    // of those that all stay
  double before_high = 0.0, after_high = 0.0;  // of those that all leave
};

RetentionLikelihood::RetentionLikelihood(const GrainSample& sample,
                                         std::optional<double> area_ratio, double strays,
                                         double pixel_um)
    : sample_(sample), fixed_ratio_(area_ratio), strays_(strays), pixel_um_(pixel_um) {}

double RetentionLikelihood::seen_width(double critical, double width) const {
  return std::hypot(width, pixel_scatter(critical, pixel_um_));
}

RetentionLikelihood::Split RetentionLikelihood::split(double critical, double own_width) const {
  const double width = seen_width(critical, own_width);
  Split s;
  s.first = sample_.below(critical - kTail * width);
  s.end = std::max(s.first, width > 0.0 ? sample_.below(critical + kTail * width) : s.first);
  s.before_low = sample_.before_of(s.first);
  s.after_low = sample_.after_of(s.first);
  s.before_high = sample_.before() - sample_.before_of(s.end);
  s.after_high = sample_.after() - sample_.after_of(s.end);
  share_.resize(s.end - s.first);
  for (std::size_t i = s.first; i < s.end; ++i) {
    share_[i - s.first] =
        strays_ +
        (1.0 - strays_) * retained_fraction(sample_.classes()[i].log_diameter, critical, width);
  }
  return s;
}

double RetentionLikelihood::log_ratio(const Split& s) const {
  if (fixed_ratio_) return std::log(*fixed_ratio_);
  // ln L is concave in ln r: Newton's method, its step bounded.
  double u = std::log((s.after_low + kHalf) / (s.before_low + kHalf));
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double r = std::exp(u);
    double excess = -sample_.after();
    double slope = 0.0;
    const auto add = [&](double count, double share) {
      const double p = r * share / (1.0 + r * share);
      excess += count * p;
      slope += count * p * (1.0 - p);
    };
    add(s.before_low + s.after_low, 1.0);
    add(s.before_high + s.after_high, strays_);
    for (std::size_t i = s.first; i < s.end; ++i)
      add(sample_.classes()[i].count(), share_[i - s.first]);
    if (!(slope > 0.0)) break;
    const double step = std::clamp(-excess / slope, -2.0, 2.0);
    u += step;
    if (std::fabs(step) < kEnough) break;
  }
  return u;
}

double RetentionLikelihood::area_ratio(double critical, double width) const {
  return std::exp(log_ratio(split(critical, width)));
}

double RetentionLikelihood::operator()(double critical, double width) const {
  const Split s = split(critical, width);
  const double u = log_ratio(s);
  const double r = std::exp(u);
  double sum = sample_.after() * u;
  const auto add = [&](double after, double count, double share) {
    if (after > 0.0) sum += after * std::log(share);
    sum -= count * std::log1p(r * share);
  };
  add(s.after_low, s.before_low + s.after_low, 1.0);
  add(s.after_high, s.before_high + s.after_high, strays_);
  for (std::size_t i = s.first; i < s.end; ++i) {
    const GrainClass& c = sample_.classes()[i];
    add(c.after, c.count(), share_[i - s.first]);
  }
  return sum;
}

}  // namespace powderlink::analysis
