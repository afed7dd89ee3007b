// SPDX-License-Identifier: GPL-3.0-or-later
/// \file file_text.h
/// The whole content of a file, and its fingerprint.
/// Tests: tests/report/gnuplot_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink {

/// Empty when the file is absent or cannot be read.
std::string file_text(const std::filesystem::path& file);

/// 40 hexadecimal digits, as `sha1sum` prints them.
std::string sha1(const std::string& text);

}  // namespace powderlink
