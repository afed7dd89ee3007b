// SPDX-License-Identifier: GPL-3.0-or-later
/// \file verdict_words.h
/// A diagnosis in sentences, for the terminal, the JSON and the report.
/// Tests: tests/analysis/evidence/diagnosis_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/diagnosis.h"

namespace powderlink::analysis {

/// \param pattern  the foreign pattern that fits best, or nullptr
std::vector<std::string> verdict_words(const Study& study, const Observations& observations,
                                       const Diagnosis& diagnosis, const Pattern* pattern);

/// "tau_s = 0.0001 s, plate_restitution = 0.3"
std::string parameter_text(const Candidate& candidate);

}  // namespace powderlink::analysis
