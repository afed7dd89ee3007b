// SPDX-License-Identifier: GPL-3.0-or-later
/// \file residual_checks.h
/// Do the residuals of a model pass for noise? The tests of trends.h against every column of a study.
///
///   scatter   rows of known noise, degrees of freedom n - sum h_ii over them
///   curve     over velocity and the grains' diameter
///   rank, runs  over every column: velocity, diameter, contact time, Gamma, and those that powderlink does not
///             know, which are told and do not count: they may have been computed from d_c itself
///
/// A column is tested on the rows that have it, where it has at least two values. Rows of counts of which
/// nearly all grains must go one way under the model have a known sign: they are left out of all but
/// scatter. Corrected for the number of tests, those that count and those that are told each by themselves.
/// Symbols: residuals in sigmas; h diagonal of the hat matrix. Errors: none.
/// Source: trends.h. Tests: tests/analysis/residual_checks_test.cpp
#pragma once

#include <vector>

#include "base/statistics/least_squares.h"
#include "analysis/evidence/observation.h"
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
