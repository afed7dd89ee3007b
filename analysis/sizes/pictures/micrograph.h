// SPDX-License-Identifier: GPL-3.0-or-later
/// \file micrograph.h
/// A picture as one channel of float, 0 to 1 of what its format can hold.
/// Colour becomes luminance, alpha is dropped, 8 and 16 bit and float are read; each of these is noted.
/// Tests: tests/analysis/sizes/segmentation_test.cpp, tests/analysis/sizes/psd_command_test.cpp
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace powderlink::analysis {

struct Micrograph {
  std::string file;
  cv::Mat grey;  ///< CV_32F
  std::vector<std::string> notes;
};

/// By its suffix, or by its first bytes when there is no known one.
bool looks_like_picture(const std::filesystem::path& file);

/// Throws for a file that is no picture, is smaller than 32 x 32, or has one brightness.
Micrograph read_micrograph(const std::filesystem::path& file);

}  // namespace powderlink::analysis
