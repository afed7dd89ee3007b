// SPDX-License-Identifier: GPL-3.0-or-later
/// \file child_process.h
/// Runs a program in its own folder with its output in a file and a limit on its wall time. When
/// this program is interrupted or terminated, its children are ended first.
/// Tests: tests/analysis/kat/kat_run_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink {

struct ChildOutcome {
  int exit_status = 0;  ///< 128 + signal number when a signal ended it
  bool over_time = false;
  double wall_s = 0.0;
};

/// Waits for the end. Throws InvalidInput when the program cannot be started.
ChildOutcome run_child(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       const std::filesystem::path& output_file, double wall_limit_s);

}  // namespace powderlink
