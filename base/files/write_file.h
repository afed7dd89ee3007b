// SPDX-License-Identifier: GPL-3.0-or-later
/// \file write_file.h
/// Results appear whole or not at all: written beside, then renamed.
/// Tests: tests/analysis/program/commands_test.cpp, tests/liggghts_styles/kat_drop/kat_results_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink {

/// \param what  the file is, for the message
/// Throws InvalidInput when the folder does not exist, cannot be written or is full; an older file stays.
void write_file(const std::filesystem::path& file, const std::string& content,
                const std::string& what = "writing a file");

/// For long jobs: throws now what write_file() would throw at their end for a folder that is
/// absent.
void require_folder_of(const std::filesystem::path& file);

}  // namespace powderlink
