// SPDX-License-Identifier: GPL-3.0-or-later
/// \file report_words.h
/// A study's result in plain sentences: verdict, where the model fits and fails, what stays open.
/// Tests: tests/analysis/report/study_result_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/report/study_result.h"

namespace powderlink::analysis {

/// Beyond this many sigmas a row counts as not described.
inline constexpr double kOutside_sigma = 2.0;

/// One or two sentences.
std::string headline(const StudyResult& result);

/// One sentence per group of neighbouring velocities: "At 1.8 to 2.3 m/s (63.8 to 66.4 um) ...".
std::vector<std::string> fit_words(const StudyResult& result);

/// What residuals that fit one by one may still show together: one sentence per failing test.
std::vector<std::string> trend_words(const StudyResult& result);

/// What these measurements do not decide.
std::vector<std::string> open_questions(const StudyResult& result);

/// "3" rounded to a few digits, with its unit.
std::string value_text(double value, const std::string& unit);

}  // namespace powderlink::analysis
