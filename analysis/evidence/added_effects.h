// SPDX-License-Identifier: GPL-3.0-or-later
/// \file added_effects.h
/// Fits of one effect or two on top of a study's own model, for `diagnose` and `add` alike: each fit
/// starts from simpler ones, so that an effect that hardly acts does not end in another valley than none.
///
///   none -> one -> two
///
/// Source: rules of evidence, diagnosis.h. Tests: tests/analysis/evidence/diagnosis_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/candidate.h"

namespace powderlink::analysis {

/// From the bounds of the effect and from the baseline.
Candidate fit_single(const Study& study, const Observations& observations,
                     const std::string& effect, const Candidate& baseline);

/// From the fits of the two alone; the better one gives the first name.
Candidate fit_pair(const Study& study, const Observations& observations, const Candidate& one,
                   const Candidate& other);

/// The same from nothing. Throws InvalidInput for more than two effects.
Candidate fit_added(const Study& study, const Observations& observations,
                    const std::vector<std::string>& effects);

}  // namespace powderlink::analysis
