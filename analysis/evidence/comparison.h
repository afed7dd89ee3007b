// SPDX-License-Identifier: GPL-3.0-or-later
/// \file comparison.h
/// A study's own model against its measurements: fitted values with their uncertainty, residuals,
/// tests of the residuals, and whether the model agrees.
///
/// Intervals are of profile likelihood, 68 %: chi^2 rises by 1, or by the mean square of the residuals
/// where the noise is not known. Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/candidate.h"
#include "base/statistics/fit_uncertainty.h"

namespace powderlink::analysis {

struct Comparison {
  enum class Verdict { agrees, fails, undecided };
  Candidate fit;
  std::vector<ProfileInterval> intervals;  ///< of the fitted parameters, in their order
  Uncertainty uncertainty;
  std::vector<double> model;      ///< one per row [um], share or [m/s]
  std::vector<double> residuals;  ///< in sigmas
  std::vector<QuantityError> rms;
  double chi2_per_dof = 0.0;  ///< NaN without a degree of freedom
  std::vector<TrendTest> tests;
  Verdict verdict = Verdict::undecided;
  std::vector<std::string> words;  ///< where it fits and fails, and what is doubtful
};
std::string to_string(Comparison::Verdict verdict);

Comparison compare(const Study& study, const Observations& observations);

/// Profile intervals of a candidate's fitted parameters, in their order.
std::vector<ProfileInterval> intervals_of(const Candidate& candidate,
                                          const Observations& observations);

/// Judges other predictions for the same rows, of LIGGGHTS, with the fit as it is.
void judge(Comparison& comparison, const Study& study, const Observations& observations,
           const std::vector<double>& model);

}  // namespace powderlink::analysis
