// SPDX-License-Identifier: GPL-3.0-or-later
/// \file residual_checks.h
/// Do the residuals of a model pass for noise? The tests of trends.h against the columns of a study.
///
/// Symbols: residuals in sigmas. Errors: none.
/// Source: trends.h. Tests: tests/analysis/study_fit_test.cpp
#pragma once

#include <vector>

#include "analysis/evidence/observation.h"
#include "analysis/evidence/trends.h"

namespace powderlink::analysis {

/// Chance that the tests of a right model fail by accident, together.
inline constexpr double kAlarm = 0.02;

/// Residuals over an assumed noise that pass for noise: tables like these have 1 to 10 %.
inline constexpr double kRmsOverAssumed = 2.0;

/// Tests of residuals in sigmas against the study's columns, corrected for their number.
std::vector<TrendTest> residual_tests(const Study& study, const Observations& observations,
                                      const std::vector<double>& residuals, int fitted);

/// The rule by which a model fails: a test fails at kAlarm, or, with an assumed noise, the residuals
/// are more than kRmsOverAssumed times that noise.
bool residuals_fail(const std::vector<TrendTest>& tests, const std::vector<double>& residuals,
                    const Noise& noise);

}  // namespace powderlink::analysis
