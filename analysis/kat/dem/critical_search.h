// SPDX-License-Identifier: GPL-3.0-or-later
/// \file critical_search.h
/// d_c of one row with LIGGGHTS: a size-graded population per run, then again inside the bracket,
/// until the bracket is narrower than the study's resolution.
/// Tests: tests/analysis/kat/critical_search_test.cpp
#pragma once

#include <functional>
#include <vector>

#include "analysis/kat/dem/drop_run.h"

namespace powderlink::analysis {

struct SearchRange {
  double smallest_m = 0.0;
  double largest_m = 0.0;
  bool given = false;  ///< by the user: not left on our own account
};

struct SearchResult {
  double critical_diameter_m = 0.0;  ///< geometric middle of the last bracket
  double largest_attached_m = 0.0;
  double smallest_detached_m = 0.0;
  int attached = 0;  ///< particles of the first run that brackets
  int detached = 0;
  int rounds = 0;
  double wall_s = 0.0;
  double largest_balance = 0.0;  ///< energy residual of the worst particle over its impact energy
  std::vector<DropParticle> particles;  ///< of all runs, by size
};

/// Runs the population [smallest, largest]; `round` counts from 1.
using RunPopulation = std::function<DropResult(double smallest_m, double largest_m, int round)>;

/// Throws InvalidInput when a given range does not bracket d_c (says which way to widen), or when
/// none is found after widening.
SearchResult search_critical_diameter(const RunPopulation& run, SearchRange range,
                                      double resolution);

}  // namespace powderlink::analysis
