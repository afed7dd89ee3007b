// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/cluster_runs.h"

#include <boost/math/distributions/poisson.hpp>
#include <cmath>

namespace powderlink::analysis {

std::vector<ClusterRun> cluster_runs(const std::vector<double>& values, double threshold,
                                     std::size_t shortest) {
  std::vector<ClusterRun> runs;
  for (std::size_t first = 0; first < values.size(); ++first) {
    std::size_t end = first;
    while (end < values.size() && values[end] > threshold) ++end;
    if (end > first && end - first >= shortest) runs.push_back({first, end});
    first = end;
  }
  return runs;
}

double runs_by_chance(double mean, double threshold, std::size_t shortest, std::size_t slices) {
  if (slices < shortest || !(mean > 0.0)) return 0.0;
  const boost::math::poisson grains(mean);
  const double p = cdf(complement(grains, std::floor(threshold)));
  return std::pow(p, static_cast<double>(shortest)) *
         (1.0 + static_cast<double>(slices - shortest) * (1.0 - p));
}

}  // namespace powderlink::analysis
