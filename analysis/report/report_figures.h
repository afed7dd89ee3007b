// SPDX-License-Identifier: GPL-3.0-or-later
/// \file report_figures.h
/// The figures of a report: tables (CSV) and drawings (SVG) in one folder, drawn by gnuplot with
/// scripts/plots/report_*.gp. Tests: tests/analysis/report/page_test.cpp
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/study_result.h"

namespace powderlink::analysis {

struct Figure {
  std::string name;     ///< of its files, without suffix
  std::string caption;  ///< also read out where the figure cannot be seen
};

struct StudyFigures {
  std::vector<Figure> fit;  ///< one per kind of measurement
  std::vector<Figure> residuals;
  std::optional<Figure> ranking, next;
};

/// What the ranking shows: all single effects and the best pairs, best first.
std::vector<const Candidate*> ranked(const Diagnosis& diagnosis);

/// \param prefix  of the files' names, safe for a file system
StudyFigures draw_study(const StudyResult& result, const std::filesystem::path& folder,
                        const std::string& prefix);

/// True when the studies are steps of one staircase: models of the same measurements.
bool same_measurements(const std::vector<std::unique_ptr<StudyResult>>& results);

/// Error before and after each added effect, in the order of the studies.
Figure draw_staircase(const std::vector<std::unique_ptr<StudyResult>>& results,
                      const std::filesystem::path& folder);

/// Name that a file system and gnuplot take: letters, digits, '-', '+', '_'.
std::string safe_name(const std::string& name);

}  // namespace powderlink::analysis
