// SPDX-License-Identifier: GPL-3.0-or-later
/// \file least_squares.h
/// Weighted least squares within bounds by Ceres Solver, in the logarithm of parameters that have a
/// scale; from several starts when asked. Knows nothing of contacts.
///
///   chi^2(x) = sum r_i(x)^2, r in sigmas
///
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>
#include <functional>
#include <string>
#include <vector>

namespace powderlink {

struct FitParameter {
  std::string name;
  double lower = 0.0, upper = 0.0;
  double start = 0.0;
  bool logarithmic = true;

  /// ln of a parameter with a scale, else parts of the width: the same in any unit.
  double to_coordinate(double value) const;
  double to_value(double coordinate) const;
  double width() const { return to_coordinate(upper) - to_coordinate(lower); }
  /// For a derivative there: 1 % of what cannot be 0, else of the width; signed, away from the nearer
  /// bound.
  double step(double coordinate) const;
};

struct FitProblem {
  std::vector<FitParameter> parameters;
  /// One per row; values in the order of the parameters.
  std::function<std::vector<double>(const std::vector<double>& values)> residuals;
  /// Optional: what is known beforehand, as residuals of its own; minimised along, not in chi2.
  std::function<std::vector<double>(const std::vector<double>& values)> prior{};
};

struct FitSolution {
  std::vector<double> values;
  std::vector<double> residuals;
  double chi2 = 0.0;
  double prior = 0.0;          ///< sum of its squares
  Eigen::MatrixXd jacobian;    ///< of the residuals, in the parameters' coordinates
  std::vector<bool> at_bound;  ///< per parameter: it lies on one
  bool pushed = false;         ///< without bounds chi^2 would fall by more than chance
};

/// From `start`; with no parameters the residuals alone.
FitSolution least_squares(const FitProblem& problem, const std::vector<double>& start);

/// Best of the starts; ties keep the earlier one. Throws InvalidInput without any.
FitSolution least_squares(const FitProblem& problem,
                          const std::vector<std::vector<double>>& starts);

double sum_of_squares(const std::vector<double>& r);

/// Thin; of a jacobian.
Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(const Eigen::MatrixXd& jacobian);

}  // namespace powderlink
