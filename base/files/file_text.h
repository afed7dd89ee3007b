// SPDX-License-Identifier: GPL-3.0-or-later
/// \file file_text.h
/// The whole content of a file.
/// Tests: tests/base/gnuplot_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink {

/// Throws InvalidInput for a file that is absent or cannot be read.
std::string file_text(const std::filesystem::path& file);

/// For files that may be absent: empty then, and when they cannot be read.
std::string file_text_or_empty(const std::filesystem::path& file);

}  // namespace powderlink
