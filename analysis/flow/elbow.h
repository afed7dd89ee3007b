// SPDX-License-Identifier: GPL-3.0-or-later
/// \file elbow.h
/// Where a signal bends: least squares of two lines that meet,
///   p(t) = a + b t + c max(0, t - t_e)
/// For each t_e the rest is linear (Eigen, QR with pivots); t_e is the minimum of what remains,
/// bracketed on a grid and refined by Brent's method (Boost). Its interval is where the remaining sum
/// of squares is within S_min (1 + F_{1,n - 4; 0.95}/(n - 4)) (profile likelihood). Residuals of a
/// flow are correlated: n is the number of independent ones, rows (1 - q)/(1 + q) with q their
/// correlation from row to row. A bend counts when two lines fit better than one by an F test
/// (2 and n - 4 degrees of freedom) at 1 %.
/// Tests: tests/analysis/flow_observables_test.cpp
#pragma once

#include <optional>
#include <vector>

#include "analysis/flow/flow_statistics.h"

namespace powderlink::analysis {

struct Elbow {
  double time = 0.0;
  Interval interval;   ///< 95 %
  double level = 0.0;  ///< at the elbow
  double slope_before = 0.0, slope_after = 0.0;
  double independent_rows = 0.0;

  double at(double t) const { return level + (t < time ? slope_before : slope_after) * (t - time); }
};

/// Empty with fewer than 8 rows, or where one line does as well. Times increase.
std::optional<Elbow> find_elbow(const std::vector<double>& times,
                                const std::vector<double>& values);

}  // namespace powderlink::analysis
