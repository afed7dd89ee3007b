// SPDX-License-Identifier: GPL-3.0-or-later
/// \file candidate_solve.h
/// The fit of a candidate whose critical diameters are integrated, estimated (fast, models with a table of
/// universal critical speeds), or estimated and corrected by the integration where the fit is.
///
///   ln d_c(Gamma) = ln d_estimate(Gamma) + [ln d_integrated - ln d_estimate](Gamma of the fit)
///
/// Validity: the correction changes by less than 0.12 per factor e of Gamma, of which d_c makes 0.5 to 1;
/// else the integration takes over from there. Errors: none.
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <vector>

#include "analysis/evidence/candidate_setting.h"

namespace powderlink::analysis {

/// Every row has a critical speed without an integration, under this hypothesis.
bool cheap(const Study& study, const Hypothesis& h);

/// Least squares; with a calibrated setting until the estimates are those of the integration there, and
/// by integration from there on when estimates do not follow it.
FitSolution solve(Setting& s, const std::vector<std::vector<double>>& starts, const Study& study,
                  const Observations& observations);

}  // namespace powderlink::analysis
