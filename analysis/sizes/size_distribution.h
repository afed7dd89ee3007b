// SPDX-License-Identifier: GPL-3.0-or-later
/// \file size_distribution.h
/// Cumulative distribution of diameters, by number or by mass, and its quantiles.
///   Y(d_i) = (w_1 + ... + w_{i-1} + w_i/2)/(w_1 + ... + w_N),  d_1 <= d_2 <= ...
///   w = 1 by number, d^3 by mass (spheres of one density)
/// straight between the grains. A grain stands in the middle of its own weight (Hazen's plotting
/// position): no share of a symmetric sample is favoured. Beyond the first and last grain Y keeps
/// their values, as nothing is known there.
/// Symbols: d diameter [um], Y share finer than d [-]. Valid for any N >= 1.
/// Source: A. Hazen, Trans. ASCE 77 (1914) 1539 (positions).
/// Tests: tests/analysis/sizes/size_distribution_test.cpp
#pragma once

#include <vector>

namespace powderlink::analysis {

enum class Weighting { number, mass };

class SizeDistribution {
 public:
  /// Throws InvalidInput without diameters, or with one that is not a number above 0.
  SizeDistribution(std::vector<double> diameters_um, Weighting weighting);

  const std::vector<double>& diameters_um() const { return diameters_um_; }  ///< increasing
  const std::vector<double>& weights() const { return weights_; }            ///< of mean 1
  std::vector<double> finer() const;  ///< Y at each of diameters_um()
  double finer(double diameter_um) const;
  /// \param shares  0 to 1
  std::vector<double> quantiles_um(const std::vector<double>& shares) const;
  double quantile_um(double share) const { return quantiles_um({share})[0]; }
  /// As if grain i of diameters_um() had been found counts[i] times: for bootstrap().
  std::vector<double> quantiles_um(const std::vector<double>& shares,
                                   const std::vector<unsigned>& counts) const;

 private:
  std::vector<double> diameters_um_, weights_;
};

}  // namespace powderlink::analysis
