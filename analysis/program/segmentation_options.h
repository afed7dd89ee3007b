// SPDX-License-Identifier: GPL-3.0-or-later
/// \file segmentation_options.h
/// The options of all commands that find grains in pictures.
/// Tests: tests/analysis/sizes/psd_command_test.cpp
#pragma once

#include <CLI/CLI.hpp>

#include "analysis/sizes/pictures/segmentation.h"

namespace powderlink::analysis {

/// \param options  must outlive the parsing
void add_segmentation_options(CLI::App& command, SegmentationOptions& options);

/// Throws InvalidInput for values out of their range.
void check_segmentation_options(const SegmentationOptions& options);

/// Progress over pictures on a terminal.
void show_pictures(std::size_t done, std::size_t all);

}  // namespace powderlink::analysis
