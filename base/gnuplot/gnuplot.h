// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gnuplot.h
/// One figure as SVG, drawn by gnuplot with a script of scripts/plots and the look of style.gp.
/// POWDERLINK_PLOTS names another folder of these scripts.
///
/// What gnuplot leaves undone is mended: blanks at a change of font and the family of italics are
/// kept in every viewer; labels `with labels hypertext` become <title> elements, which browsers show
/// on hover without a script.
/// Tests: tests/base/gnuplot_test.cpp, tests/analysis/program/flow_command_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink {

bool have_gnuplot();

/// 'text' as gnuplot reads it, whatever is in it; control characters become blanks.
std::string gnuplot_string(const std::string& text);

/// Draws `svg` with scripts/plots/SCRIPT; complete or not at all.
/// \param definitions  "a=1; b=2", known to the script beside `output` and `scripts`
/// Throws InvalidInput when gnuplot refuses; `instead` says what the user may do then.
void draw_figure(const std::filesystem::path& svg, const std::string& script,
                 const std::string& definitions, const std::string& instead);

/// The SVG of gnuplot with the above mended.
std::string mended_svg(std::string svg);

}  // namespace powderlink
