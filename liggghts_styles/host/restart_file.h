// SPDX-License-Identifier: GPL-3.0-or-later
/// \file restart_file.h
/// Whether a restart file of LIGGGHTS 3.8 is whole, without LIGGGHTS: its own reader does not look, and
/// goes on with whatever is in its buffers where a file breaks off, or waits for ever.
///
/// A file is
///   head    items of a number (int) and a value: 0 version, 4 units, 22 atom style (text: length as int,
///           then so many bytes), 1 to 3 sizes of integers, 6 and following (int), 5 step, 23 atoms (64 bits)
///   middle  groups, types, pair styles and fixes, whose lengths only their classes know
///   blocks  one per rank: how many doubles (int), then the atoms of that rank, each of which begins with
///           its own number of doubles
/// Of a single file the blocks are the end: as many as the head says, with as many atoms, and nothing
/// after them. A name with % stands for a head file (`base` in its place) and a file per rank with its
/// block.
/// Tests: tests/liggghts_styles/restart_file_test.cpp, on files of LIGGGHTS
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace powderlink {

struct RestartHead {
  std::optional<std::int64_t> step;
  std::optional<int> ranks;
  std::optional<std::int64_t> atoms;
};

/// As far as the head goes. Reads no more of the file than its head.
RestartHead read_restart_head(const std::filesystem::path& file);

/// Nothing for a whole file, else the file and what is wrong with it: "post/restart.100 is empty".
/// \param file  as given to read_restart, without `*`. O(bytes of the file).
std::string why_not_whole_restart(const std::filesystem::path& file);

}  // namespace powderlink
