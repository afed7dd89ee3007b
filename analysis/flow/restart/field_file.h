// SPDX-License-Identifier: GPL-3.0-or-later
/// \file field_file.h
/// Whether a file that OpenFOAM wrote is whole: its last line `// *** //` closes it, in a compressed
/// file (NAME.gz) after all of it could be inflated and gzip's own checksum agrees.
/// Tests: tests/analysis/flow/restart_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink::analysis {

/// The file, or NAME.gz when only that is there.
std::filesystem::path plain_or_compressed(const std::filesystem::path& file);

/// Nothing for a whole file, else what is wrong: "is empty", "breaks off: ...".
std::string why_not_whole(const std::filesystem::path& file);

}  // namespace powderlink::analysis
