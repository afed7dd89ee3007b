// SPDX-License-Identifier: GPL-3.0-or-later
/// \file grain_source.h
/// Grains from tables and micrographs alike: the one place where a file becomes a ParticleSet.
/// Tables come first in the result, then pictures, each in the order given.
/// Tests: tests/analysis/sizes/psd_command_test.cpp, tests/analysis/sizes/kat_pictures_test.cpp
#pragma once

#include <functional>

#include "analysis/sizes/particle_table.h"
#include "analysis/sizes/pictures/segmentation.h"

namespace powderlink::analysis {

struct GrainSource {
  ParticleSet set;
  std::vector<std::pair<std::string, std::string>> overlays;  ///< name of the file, PNG
};

using PictureProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Pictures have the scale that is given, else that of their TIFF (tiff_facts.h).
/// Throws for the first file that cannot be used, for stacks, scales that differ, and without a scale.
GrainSource read_grain_source(const std::vector<std::filesystem::path>& files,
                              std::optional<double> pixel_size_um,
                              const SegmentationOptions& segmentation,
                              const PictureProgress& progress = {});

}  // namespace powderlink::analysis
