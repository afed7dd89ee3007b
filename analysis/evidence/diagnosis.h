// SPDX-License-Identifier: GPL-3.0-or-later
/// \file diagnosis.h
/// Which effect is missing, if any: the rules of evidence.
///
/// 1. The study's own model is fitted. Unless its residuals fail (residual_checks.h: a test at kAlarm
///    after Holm, or an rms beyond an assumed noise) nothing is missing: `no_missing_effect`. A fit at
///    a bound is never that sure: then `ambiguous`, and nothing is named.
/// 2. Every effect of the catalogue is added and fitted. A candidate *suffices* when it clears the
///    baseline by kClears of BIC and its own residuals pass: no test below kSuffices (of the scatter
///    alone, if a row has an assumed noise), and rows with an assumed noise within kRmsOverAssumed.
/// 3. The best that suffices is named alone, `missing_effect`, when it leads every other one that
///    suffices, and foreign patterns (patterns.h), by kApart of BIC, when no bound holds it or the
///    baseline back, and when it is plausible or no plausible one that suffices is within 4 of BIC
///    (with an assumed noise: at all). Otherwise `ambiguous`; all that cannot be told apart are named,
///    and with an implausible leader that plausible one, which then is `best`.
/// 4. When none suffices, pairs are tried. A pair that does makes `ambiguous`: so many parameters
///    prove little. Else `unexplained`.
/// Implausible parameters mark a candidate and do not remove it.
/// Tests: tests/analysis/evidence/diagnosis_test.cpp; docs/diagnosis.md has the study of its error rates.
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/candidate.h"
#include "analysis/evidence/next_measurement.h"
#include "analysis/evidence/patterns.h"

namespace powderlink::analysis {

inline constexpr double kSuffices = 0.005;  ///< chance that a right candidate fails its tests
inline constexpr double kClears = 6.0;      ///< of BIC, against the baseline
inline constexpr std::size_t kFewestRows = 4;

/// Critical diameters at velocities that differ by 5 % and more; true where sizes differ instead.
bool velocities_spread(const Study& study);

enum class Verdict { no_missing_effect, missing_effect, ambiguous, unexplained };
std::string to_string(Verdict verdict);

struct Diagnosis {
  Verdict verdict = Verdict::unexplained;
  std::string best;                ///< empty: none
  std::vector<Candidate> ranking;  ///< best first, always with "none"
  std::vector<Candidate> pairs;    ///< best first; only when no single effect suffices
  std::vector<std::string>
      indistinguishable;  ///< those that the data cannot tell apart, best first
  std::vector<Pattern> patterns;
  std::vector<std::string> words;  ///< the verdict in sentences
  NextMeasurement next;

  const Candidate& baseline() const { return get("none"); }
  const Candidate& get(const std::string& name) const;  ///< single or pair
};

/// A foreign pattern on the same scale as the candidates; infinity where none was found.
double pattern_bic(const Pattern& pattern, const Observations& observations);

/// Throws InvalidInput for rows that cannot decide anything: fewer than four, or one velocity only.
Diagnosis diagnose(const Study& study, const Observations& observations);

}  // namespace powderlink::analysis
