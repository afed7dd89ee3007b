// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_figures.h
/// SVG figures from the tables of `powderlink flow`, drawn by gnuplot with scripts/plots/flow_*.gp.
/// Tests: tests/analysis/program/flow_command_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/flow/flow_report.h"

namespace powderlink::analysis {

/// Draws what the tables in `out` allow; returns notes on what could not be drawn (no gnuplot).
/// Throws when gnuplot refuses a figure.
std::vector<std::string> draw_flow_figures(const FlowReport& report,
                                           const std::filesystem::path& out);

}  // namespace powderlink::analysis
