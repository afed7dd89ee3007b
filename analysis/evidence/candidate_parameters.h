// SPDX-License-Identifier: GPL-3.0-or-later
/// \file candidate_parameters.h
/// The parameters of a fitted candidate as a reader wants them: fitted, held or fixed, and whether their
/// values are plausible.
///
/// Source: plausible ranges of physics/effects/effects.def. Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <string>

#include "analysis/evidence/candidate.h"
#include "analysis/evidence/candidate_setting.h"

namespace powderlink::analysis {

/// \param c  its hypothesis and solution are known
void list_parameters(Candidate& c, const Setting& s, const Study& study);

/// "x = 3.6 stopped at a bound of the fit, 0.001 to 3.6".
std::string bound_text(const ParameterEstimate& p);

/// plausible and why, from the listed parameters.
void judge_plausibility(Candidate& c, const Study& study);

}  // namespace powderlink::analysis
