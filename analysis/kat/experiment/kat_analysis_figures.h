// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_analysis_figures.h
/// SVG figures from the tables of kat_analysis_output.h, drawn by gnuplot:
///   sizes.svg      grains before and after over diameter, per area
///   retained.svg   retained fraction over diameter, its fit, d_c with its interval
/// Tests: tests/analysis/program/kat_analyse_command_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/kat/experiment/kat_analysis.h"

namespace powderlink::analysis {

/// Draws what the tables in `out` hold; returns notes on what could not be drawn (no gnuplot).
std::vector<std::string> draw_kat_analysis(const KatAnalysis& analysis,
                                           const std::filesystem::path& out);

}  // namespace powderlink::analysis
