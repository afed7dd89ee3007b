// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/size_distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/invalid_input.h"

namespace powderlink::analysis {

SizeDistribution::SizeDistribution(std::vector<double> diameters_um, Weighting weighting)
    : diameters_um_(std::move(diameters_um)) {
  const auto wrong = std::find_if(diameters_um_.begin(), diameters_um_.end(),
                                  [](double d) { return !(d > 0.0 && std::isfinite(d)); });
  if (diameters_um_.empty() || wrong != diameters_um_.end()) {
    throw InvalidInput("size distribution",
                       diameters_um_.empty() ? "no grains" : number_text(*wrong) + " um",
                       "one diameter above 0 or more", "look at the tables or pictures");
  }
  std::sort(diameters_um_.begin(), diameters_um_.end());
  weights_.assign(diameters_um_.size(), 1.0);
  if (weighting == Weighting::number) return;
  const double largest = diameters_um_.back();
  std::transform(diameters_um_.begin(), diameters_um_.end(), weights_.begin(),
                 [&](double d) { return std::pow(d / largest, 3); });
  const double mean =
      std::accumulate(weights_.begin(), weights_.end(), 0.0) / static_cast<double>(weights_.size());
  for (double& w : weights_) w /= mean;
}

std::vector<double> SizeDistribution::finer() const {
  std::vector<double> y;
  y.reserve(weights_.size());
  double below = 0.0;
  const double all = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  for (const double w : weights_) {
    y.push_back((below + 0.5 * w) / all);
    below += w;
  }
  return y;
}

double SizeDistribution::finer(double diameter_um) const {
  const auto above = std::upper_bound(diameters_um_.begin(), diameters_um_.end(), diameter_um);
  const std::vector<double> y = finer();
  if (above == diameters_um_.begin()) return 0.0;
  if (above == diameters_um_.end()) return 1.0;
  const auto i = static_cast<std::size_t>(above - diameters_um_.begin());
  const double part =
      (diameter_um - diameters_um_[i - 1]) / (diameters_um_[i] - diameters_um_[i - 1]);
  return y[i - 1] + part * (y[i] - y[i - 1]);
}

std::vector<double> SizeDistribution::quantiles_um(const std::vector<double>& shares) const {
  return quantiles_um(shares, std::vector<unsigned>(weights_.size(), 1U));
}

std::vector<double> SizeDistribution::quantiles_um(const std::vector<double>& shares,
                                                   const std::vector<unsigned>& counts) const {
  double all = 0.0;
  for (std::size_t i = 0; i < weights_.size(); ++i) all += counts[i] * weights_[i];
  std::vector<double> result;
  for (const double share : shares) {
    const double wanted = share * all;
    double below = 0.0, y_before = 0.0, d_before = 0.0, found = 0.0;
    bool first = true;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (counts[i] == 0) continue;
      // Of equal grains the first stands lower and the last higher: steps stay steps.
      const double one = weights_[i];
      const double low = below + 0.5 * one;
      const double high = below + (counts[i] - 0.5) * one;
      found = diameters_um_[i];
      if (wanted <= high) {
        if (wanted < low && !first)
          found = d_before + (wanted - y_before) / (low - y_before) * (found - d_before);
        break;
      }
      below += counts[i] * one;
      y_before = high;
      d_before = found;
      first = false;
    }
    result.push_back(found);
  }
  return result;
}

}  // namespace powderlink::analysis
