// SPDX-License-Identifier: GPL-3.0-or-later
/// \file report_page.h
/// The page of a report: one HTML file that needs nothing else. Its text is in report.html.in,
/// figure.html.in and parameters.html.in (Mustache, https://mustache.github.io/mustache.5.html);
/// what comes from studies and tables is escaped.
/// Tests: tests/analysis/report/page_test.cpp, tests/analysis/report/browser_test.sh
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/provenance.h"
#include "analysis/report/report_figures.h"
#include "analysis/report/study_result.h"

namespace powderlink::analysis {

extern const char* const kReportTemplate;
extern const char* const kFigureTemplate;
extern const char* const kParametersTemplate;

struct ReportPage {
  std::vector<std::unique_ptr<StudyResult>> results;
  std::vector<StudyFigures> figures;  ///< one per study
  std::optional<Figure> staircase;
  std::filesystem::path folder;  ///< of the figures
  std::string version;
  Facts facts;
};

std::string html(const ReportPage& page);

}  // namespace powderlink::analysis
