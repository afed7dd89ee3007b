// SPDX-License-Identifier: GPL-3.0-or-later
/// \file file_patterns.h
/// Names and patterns that users give where several files are read.
/// Tests: tests/analysis/sizes/particle_table_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink {

/// Files of all patterns (*, ?, [..], as in a shell), each once however it is spelled, in the order
/// given. Throws for a pattern or name without a file. \param what  the files are, for the message
std::vector<std::filesystem::path> expand_patterns(const std::vector<std::string>& patterns,
                                                   const std::string& what = "files of grains");

}  // namespace powderlink
