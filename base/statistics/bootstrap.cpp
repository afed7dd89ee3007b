// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/statistics/bootstrap.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <limits>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

ConfidenceInterval central(std::vector<double>& values, double level) {
  if (values.empty()) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  const auto at = [&](double share) {
    const auto last = static_cast<double>(values.size() - 1);
    const auto place = static_cast<long>(std::lround(share * last));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
  };
  return {at(0.5 * (1.0 - level)), at(0.5 * (1.0 + level))};
}

}  // namespace

std::vector<ConfidenceInterval> bootstrap_intervals(
    const std::vector<std::size_t>& sizes, const Bootstrap& options,
    const std::function<std::vector<double>(const std::vector<DrawCounts>&)>& statistic) {
  constexpr int fewest = 20, most = 1000000;
  if (options.replicates < fewest || options.replicates > most) {
    throw InvalidInput("bootstrap: replicates", fmt::format("{}", options.replicates),
                       fmt::format("{} to {}", fewest, most), "1000 is usual");
  }
  boost::random::mt19937_64 generator(options.seed);
  std::vector<std::vector<double>> found;
  std::vector<DrawCounts> counts(sizes.size());
  for (int r = 0; r < options.replicates; ++r) {
    for (std::size_t g = 0; g < sizes.size(); ++g) {
      counts[g].assign(sizes[g], 0U);
      if (sizes[g] == 0) continue;
      boost::random::uniform_int_distribution<std::size_t> any(0, sizes[g] - 1);
      for (std::size_t i = 0; i < sizes[g]; ++i) ++counts[g][any(generator)];
    }
    const std::vector<double> values = statistic(counts);
    found.resize(std::max(found.size(), values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isfinite(values[k])) found[k].push_back(values[k]);
  }
  std::vector<ConfidenceInterval> intervals;
  intervals.reserve(found.size());
  for (std::vector<double>& values : found) intervals.push_back(central(values, options.level));
  return intervals;
}

}  // namespace powderlink
