// SPDX-License-Identifier: GPL-3.0-or-later
/// \file psd_figures.h
/// SVG figures from the tables of `powderlink psd`, drawn by gnuplot with scripts/plots/psd_*.gp.
/// Tests: tests/analysis/sizes/psd_command_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/sizes/pictures/psd_report.h"

namespace powderlink::analysis {

/// Draws from the tables in `out`; returns notes on what could not be drawn (no gnuplot).
std::vector<std::string> draw_psd_figures(const PsdReport& report,
                                          const std::filesystem::path& out);

}  // namespace powderlink::analysis
