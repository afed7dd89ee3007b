// SPDX-License-Identifier: GPL-3.0-or-later
/// \file candidate_starts.h
/// Where the fit of a candidate starts: the best points of a grid over the effects' parameters, each with
/// the adhesive energy that suits it.
///
/// Validity: bounds of decades; between the points of the grid chi^2 has one valley.
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <utility>
#include <vector>

#include "analysis/evidence/candidate.h"
#include "analysis/evidence/candidate_setting.h"

namespace powderlink::analysis {

/// The adhesive energy that suits the other values: d_c grows with nearly its first power.
/// \return values and their chi^2
std::pair<std::vector<double>, double> suit_energy(const Setting& s, const Observations& all,
                                                   std::vector<double> values, int turns);

/// Over the whole bounds.
/// \param fast  critical speeds are tabulated: a finer grid is affordable
std::vector<std::vector<double>> searched_starts(const Study& study, const Setting& s,
                                                 const Observations& observations, bool fast);

/// From explanations that share effects with this one; what they do not know varies over its range.
std::vector<std::vector<double>> near_starts(const Setting& s, const Observations& observations,
                                             const std::vector<const Candidate*>& near);

}  // namespace powderlink::analysis
