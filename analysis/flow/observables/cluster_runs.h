// SPDX-License-Identifier: GPL-3.0-or-later
/// \file cluster_runs.h
/// Clusters along a channel: runs of at least L neighbouring slices that hold more than a threshold.
/// How many of them a stream of independent grains would show by chance is known: with p the
/// probability of a slice above the threshold (Poisson) and n slices,
///   E = p^L (1 + (n - L) (1 - p))
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <cstddef>
#include <vector>

namespace powderlink::analysis {

/// [first, end) of each run in which values > threshold.
struct ClusterRun {
  std::size_t first = 0, end = 0;
};
std::vector<ClusterRun> cluster_runs(const std::vector<double>& values, double threshold,
                                     std::size_t shortest);

/// E for grains of `mean` per slice; 0 where fewer than `shortest` slices are there.
double runs_by_chance(double mean, double threshold, std::size_t shortest, std::size_t slices);

}  // namespace powderlink::analysis
