// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/moving_average.h"

#include <algorithm>
#include <boost/accumulators/accumulators.hpp>
#include <boost/accumulators/statistics/mean.hpp>
#include <boost/accumulators/statistics/stats.hpp>
#include <boost/accumulators/statistics/variance.hpp>
#include <cmath>

namespace powderlink::analysis {

namespace {

constexpr double kWindowRounding = 1e-9;  // of the window: times in files are rounded

/// Integral of the samples' polygon up to any time.
class Integral {
 public:
  Integral(const std::vector<double>& times, const std::vector<double>& values)
      : times_(times), values_(values), sums_(times.size(), 0.0) {
    for (std::size_t i = 1; i < times.size(); ++i) {
      sums_[i] = sums_[i - 1] + 0.5 * (values[i] + values[i - 1]) * (times[i] - times[i - 1]);
    }
  }

  double to(double time) const {
    const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto i = static_cast<std::size_t>(above - times_.begin()) - 1;
    const double slope = (values_[i + 1] - values_[i]) / (times_[i + 1] - times_[i]);
    const double dt = time - times_[i];
    return sums_[i] + dt * (values_[i] + 0.5 * slope * dt);
  }

 private:
  const std::vector<double>& times_;
  const std::vector<double>& values_;
  std::vector<double> sums_;
};

}  // namespace

std::vector<std::optional<double>> moving_average(const std::vector<double>& times,
                                                  const std::vector<double>& values,
                                                  double window) {
  std::vector<std::optional<double>> averages(times.size());
  if (times.size() < 2) return averages;
  const Integral integral(times, values);
  const double slack = kWindowRounding * window;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double from = times[i] - 0.5 * window, to = times[i] + 0.5 * window;
    if (from < times.front() - slack || to > times.back() + slack) continue;
    averages[i] = (integral.to(to) - integral.to(from)) / window;
  }
  return averages;
}

std::optional<Irregularity> irregularity(const std::vector<std::optional<double>>& averages) {
  namespace acc = boost::accumulators;
  acc::accumulator_set<double, acc::stats<acc::tag::mean, acc::tag::variance>> sample;
  for (const auto& average : averages) {
    if (average) sample(*average);
  }
  const double mean = acc::mean(sample);
  if (acc::count(sample) < 2 || mean == 0.0) return {};
  return Irregularity{mean,
                      100.0 * std::sqrt(std::max(0.0, acc::variance(sample))) / std::abs(mean)};
}

}  // namespace powderlink::analysis
