// SPDX-License-Identifier: GPL-3.0-or-later
/// \file picture_names.h
/// Files that are pictures by their suffix. Tests: tests/analysis/kat/grain_drops_test.cpp
#pragma once

#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <set>
#include <string>

namespace powderlink::analysis {

inline std::string lower_suffix(const std::filesystem::path& file) {
  return boost::algorithm::to_lower_copy(file.extension().string());
}

inline bool has_picture_suffix(const std::filesystem::path& file) {
  static const std::set<std::string> pictures = {".png", ".tif", ".tiff", ".jpg", ".jpeg",
                                                 ".bmp", ".pgm", ".ppm",  ".jp2", ".webp"};
  return pictures.count(lower_suffix(file)) > 0;
}

}  // namespace powderlink::analysis
