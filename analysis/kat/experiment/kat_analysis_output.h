// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_analysis_output.h
/// A KatAnalysis as JSON, as text for the terminal and as tables (for figures too).
/// Tests: tests/analysis/program/kat_analyse_command_test.cpp
#pragma once

#include <map>
#include <string>

#include "analysis/kat/experiment/kat_analysis.h"
#include "analysis/kat/experiment/retention_classes.h"

namespace powderlink::analysis {

std::string kat_analysis_json(const KatAnalysis& analysis, const KatAnalysisInput& input);

std::string kat_analysis_text(const KatAnalysis& analysis, const KatAnalysisInput& input);

/// File name -> CSV: retained.csv (classes), retained_curve.csv (fit), gamma.csv, contact_radii.csv.
std::map<std::string, std::string> kat_analysis_tables(const KatAnalysis& analysis,
                                                       const KatAnalysisInput& input);

}  // namespace powderlink::analysis
