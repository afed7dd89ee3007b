// SPDX-License-Identifier: GPL-3.0-or-later
/// \file elbow.h
/// Where a signal stops to rise: least squares of straight pieces that meet,
///   p(t) = a + b t + sum_i c_i max(0, t - t_i)
/// with one bend, or two: a pipe that fills may first do so slowly. For given bends the rest is
/// linear (Eigen, QR with pivots); the bends are the minimum of what remains, bracketed on a grid
/// and refined one by one by Brent's method (Boost). More bends count when they fit better by an F
/// test at 1 %, two degrees of freedom each. The elbow is the bend at which the slope falls most.
/// Its interval is where the remaining sum of squares, at its least over the other bend, is within
/// S_min (1 + F_{1,m; 0.95}/m) (profile likelihood), m = n - 2 - 2 bends. Residuals of a flow are
/// correlated: n is the number of independent ones, rows/(1 + 2 sum of their autocorrelations up to
/// the first that is not positive).
/// Source: C. J. Geyer, Statist. Sci. 7 (1992) 473 (the sum).
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/flow/run/flow_statistics.h"

namespace powderlink::analysis {

struct Elbow {
  double time = 0.0;
  Interval interval;                             ///< 95 %
  double level = 0.0;                            ///< at the elbow
  double slope_before = 0.0, slope_after = 0.0;  ///< of the pieces that meet there
  double independent_rows = 0.0;
  std::vector<std::pair<double, double>> pieces;  ///< ends of all pieces: time, value

  double at(double t) const;
};

/// Empty with fewer than 8 rows, or where one line does as well. Times increase.
std::optional<Elbow> find_elbow(const std::vector<double>& times,
                                const std::vector<double>& values);

}  // namespace powderlink::analysis
