// SPDX-License-Identifier: GPL-3.0-or-later
/// \file bootstrap.h
/// Intervals of anything that is computed from a sample of independent grains: the sample is drawn
/// again from itself, with replacement, and the statistic taken from each (percentile bootstrap).
/// Boost.Random gives the same draws from a seed on every machine.
/// Valid for statistics that vary smoothly with the sample: quantiles, means, fits; not for the
/// largest or smallest grain. Percentile intervals of few grains (< 30) are somewhat too narrow.
/// Source: B. Efron, R. Tibshirani, An Introduction to the Bootstrap (1993), chapters 6 and 13.
/// Tests: tests/analysis/sizes/size_distribution_test.cpp
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace powderlink {

struct Bootstrap {
  int replicates = 1000;
  std::uint64_t seed = 20140236;
  double level = 0.95;  ///< of the intervals
};

struct ConfidenceInterval {
  double low = 0.0, high = 0.0;
};

/// How often each grain was drawn.
using DrawCounts = std::vector<unsigned>;

/// One interval per number that `statistic` returns; values that are not finite are left out, and an
/// interval without any finite value is NaN. More than one group (such as grains before and after a
/// drop) is drawn each from itself.
/// \param sizes      number of grains in each group
/// \param statistic  called with the counts of each group
std::vector<ConfidenceInterval> bootstrap_intervals(
    const std::vector<std::size_t>& sizes, const Bootstrap& options,
    const std::function<std::vector<double>(const std::vector<DrawCounts>&)>& statistic);

}  // namespace powderlink
