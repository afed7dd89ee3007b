// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fit_uncertainty.h
/// How well a fit of least_squares.h knows its parameters. Knows nothing of contacts.
///
///   interval     chi^2 minimised over the others rises by less than a given amount (profile likelihood)
///   covariance   (J^T J)^-1 in the parameters' coordinates; directions that the data leave open have the
///                width of the bounds
///   left out     residual of a row from the fit without it, to first order
///
/// Symbols: J jacobian of the residuals, which are in sigmas.
/// Validity: intervals any problem with one valley; covariance and left out where residuals are nearly
/// linear. Errors: none. Source: D. J. Venzon, S. H. Moolgavkar, Appl. Statist. 37 (1988) 87.
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/statistics/least_squares.h"

namespace powderlink {

/// Leave-one-out residuals from one Gauss-Newton step without the row; r_i/(1 - h_ii) with the hat
/// matrix h. A parameter that the row alone determines keeps its value.
std::vector<double> leave_one_out(const FitSolution& solution);

/// Diagonal of J (J^T J)^-1 J^T: how much of a degree of freedom each row gave to the fit.
std::vector<double> hat_diagonal(const FitSolution& solution);

/// Interval of one parameter where chi^2, minimised over the others, rises by less than `rise`.
/// An end that is not reached within the bounds is the bound.
struct ProfileInterval {
  double low = 0.0, high = 0.0;
  bool open_low = false, open_high = false;  ///< the bound came first
};
ProfileInterval profile_interval(const FitProblem& problem, const FitSolution& solution,
                                 std::size_t parameter, double rise);

/// Correlation of the parameters; and directions that the data leave open.
struct Uncertainty {
  Eigen::MatrixXd correlation;
  std::vector<double> sigma;      ///< in the parameters' coordinates
  std::vector<std::string> flat;  ///< "a and b together", one text per open direction
};
Uncertainty uncertainty(const FitProblem& problem, const FitSolution& solution);

}  // namespace powderlink
