// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_picture.h
/// The figure of a coupled run: gas speed in the plane through the middle, the particles before it
/// with their true radii coloured by speed, in one or more strips. The channel's axis
/// (analysis/flow/run/flow_channel.h) lies to the right, the axis `up` upwards. No display needed.
/// Tests: tests/analysis/render/flow_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace powderlink::render {

struct FlowPictureOptions {
  int width_px = 2000;
  std::optional<double> time_s;       ///< of the gas: the dump nearest to it; default: the last one
  std::optional<std::string> axis;    ///< x, y or z; default: the channel's
  std::optional<double> time_step_s;  ///< of the DEM
  std::optional<double>
      length_m;  ///< of a strip; default: 8 times the height of the channel, or all of it
  std::optional<double> at_m;  ///< one strip, its middle here; default: begin, middle, end
  std::optional<std::string> title;
};

/// Draws and writes the PNG. Throws when there is neither gas nor a particle to show.
void write_flow_picture(const std::filesystem::path& case_folder, const std::filesystem::path& png,
                        const FlowPictureOptions& options);

}  // namespace powderlink::render
