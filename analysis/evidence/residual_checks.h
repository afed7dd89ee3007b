// SPDX-License-Identifier: GPL-3.0-or-later
/// \file residual_checks.h
/// Do the residuals of a model pass for noise? The tests of trends.h against every column of a study.
///
///   scatter      rows of known noise, degrees of freedom n - sum h_ii over them
///   curve        over velocity and the grains' diameter
///   rank, runs   over every column: velocity, diameter, contact time, Gamma, and the table's others
///
/// A column that powderlink does not know is reported and counts for nothing: it may have been computed
/// from d_c itself. A column is tested on the rows that have it, if these are at least four and do not
/// all have the same value. Where the model lets fewer than two grains of a count stay, or leave, the
/// sign of the residual is known beforehand: such a row is left out of all tests but scatter.
/// p-values are corrected for the number of tests, those that count and those that do not separately.
/// Symbols: n rows, residuals in sigmas, h_ii diagonal of the hat matrix. Errors: none.
/// Source: trends.h. Tests: tests/analysis/evidence/residual_checks_test.cpp
#pragma once

#include <vector>

#include "analysis/evidence/observation.h"
#include "base/statistics/least_squares.h"
#include "base/statistics/trends.h"

namespace powderlink::analysis {

/// Chance that the tests of a right model fail by accident, together.
inline constexpr double kAlarm = 0.02;

/// Residuals over an assumed noise that pass for noise: tables like these have 1 to 10 %.
inline constexpr double kRmsOverAssumed = 2.0;

/// \param model     one prediction per row
/// \param solution  residuals of that model in sigmas, and the jacobian of its fit
std::vector<TrendTest> residual_tests(const Observations& observations,
                                      const std::vector<double>& model,
                                      const FitSolution& solution);

/// A kind of rows whose noise was assumed has residuals of more than kRmsOverAssumed of it (rms).
bool beyond_assumed(const std::vector<double>& residuals, const Observations& observations);

/// The rule by which a model fails: a test fails at kAlarm, or residuals are beyond an assumed noise.
bool residuals_fail(const std::vector<TrendTest>& tests, const std::vector<double>& residuals,
                    const Observations& observations);

}  // namespace powderlink::analysis
