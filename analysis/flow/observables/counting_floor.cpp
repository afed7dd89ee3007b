// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/counting_floor.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace powderlink::analysis {

namespace {

constexpr double kTail = 0.025;
constexpr double kFewest = 3.0;          // windows
constexpr double kCountRounding = 1e-6;  // of a window: 20 times 1e-4 is not quite 2e-3

}  // namespace

double counting_floor(double rate_1_s, double window_s, double mass_variation, double transit_s) {
  const double longer_s = std::max(window_s, transit_s);
  const double shorter_s = std::min(window_s, transit_s);
  return std::sqrt((1.0 + mass_variation * mass_variation) / (rate_1_s * longer_s) *
                   (1.0 - shorter_s / (3.0 * longer_s)));
}

std::optional<Interval> rms_interval(double rms, double record_s, double window_s) {
  const double windows = std::floor(record_s / window_s + kCountRounding);
  if (!(windows >= kFewest)) return {};
  const boost::math::chi_squared squares(windows - 1.0);
  return Interval{rms * std::sqrt((windows - 1.0) / quantile(complement(squares, kTail))),
                  rms * std::sqrt((windows - 1.0) / quantile(squares, kTail))};
}

}  // namespace powderlink::analysis
