// SPDX-License-Identifier: GPL-3.0-or-later
/// \file candidate.h
/// One explanation of a study's measurements: its effects and what is added to them, fitted.
///
///   known noise    score = chi^2
///   assumed noise  score = (m + nu) ln(1 + chi^2/nu), nu = 2: the noise itself is uncertain
///   BIC = score + prior + k ln n
///
/// The score is a sum: rows of known noise add their chi^2, and each kind of rows with an assumed noise
/// adds a term with its own m and chi^2.
///
/// prior: a fitted value outside its plausible range costs the square of the decades that it is off, in
/// the fit and in BIC. Of one added effect values outside are taken only if the data insist, that is if
/// the best fit within the plausible ranges has a BIC that is higher by more than kApart.
/// k counts the parameters that the data need: one of an added effect that may as well keep its
/// typical value (BIC is not higher then) is held there and said to be undetermined.
/// Symbols: n rows, m rows of one kind with assumed noise, k fitted parameters, chi^2 sum of the squared
/// residuals in sigmas. Source: G. Schwarz, Ann. Statist. 6 (1978) 461.
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/observation.h"
#include "analysis/evidence/quantity_error.h"
#include "base/statistics/least_squares.h"
#include "base/statistics/trends.h"

namespace powderlink::analysis {

struct ParameterEstimate {
  enum class Role { fitted, held, fixed };
  std::string name;    ///< with its unit, "tau_s"
  std::string effect;  ///< empty for the adhesive energy
  double value = 0.0;
  Role role = Role::fixed;
  double lower = 0.0, upper = 0.0;  ///< bounds of the fit
  bool at_bound = false;
  /// A bound stopped it: one that the study set, or one that chi^2 pushes it against.
  bool held_back = false;
  double plausible_lower = 0.0, plausible_upper = 0.0;
  std::string source;  ///< of the plausible range
  bool plausible() const { return value >= plausible_lower && value <= plausible_upper; }
};

struct Candidate {
  std::string name;  ///< "none", "a" or "a+b"
  std::vector<std::string> added;
  Hypothesis hypothesis;
  std::vector<ParameterEstimate> parameters;
  FitProblem problem;  ///< of the fitted parameters, in their order; refers to the study
  FitSolution solution;
  std::vector<double> predicted;
  double bic = 0.0;
  std::vector<QuantityError> rms, left_out;  ///< errors of the fit, and of rows left out
  std::vector<TrendTest> tests;
  bool plausible = true;
  bool acts = true;  ///< false: these observations cannot show the added effect
  std::string why;   ///< of plausible

  int fitted() const { return static_cast<int>(solution.values.size()); }
  double chi2_per_dof() const;
  const ParameterEstimate* find(const std::string& name) const;
  /// A bound held a fitted parameter back: the candidate may be better than it looks.
  bool held_back() const;
};

/// BIC differences below this do not tell two explanations apart.
inline constexpr double kApart = 2.0;

/// What BIC adds its penalty to. \param residuals  one per row, in sigmas
double score(const Observations& observations, const std::vector<double>& residuals);

/// Two added effects are estimated together (Hypothesis::estimated) and tried from `near` only (without
/// any: InvalidInput); one or none is searched for within the bounds too. See added_effects.h.
/// \param study, observations  must outlive the result
/// \param near  explanations to start from
Candidate fit_candidate(const Study& study, const Observations& observations,
                        const std::vector<std::string>& added,
                        const std::vector<const Candidate*>& near = {});

}  // namespace powderlink::analysis
