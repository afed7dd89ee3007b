// SPDX-License-Identifier: GPL-3.0-or-later
/// \file picture.h
/// The figure: states of a drop test side by side, colour key, scale bar, title. No display needed.
/// Tests: tests/analysis/render/picture_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/render/run_directory.h"

namespace powderlink::render {

struct PictureOptions {
  int width_px = 2000;
  int frames = 3;                   ///< states from before the impact until the grains are away
  bool last = false;                ///< only the run's last state
  std::optional<double> time_s;     ///< only the state nearest to this time
  std::optional<double> window_um;  ///< width of the part of the plate that is shown
  /// Free flight shown after the last dumped state; not given: as long as the picture needs, 0:
  /// none.
  std::optional<double> flight_s;
  std::string fix = "kat";           ///< id of the fix kat/drop
  std::optional<std::string> title;  ///< instead of impact velocity and critical diameter
};

/// Draws a run and writes the PNG.
void write_picture(const RunDirectory& run, const std::filesystem::path& png,
                   const PictureOptions& options);

}  // namespace powderlink::render
