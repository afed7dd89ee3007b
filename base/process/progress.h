// SPDX-License-Identifier: GPL-3.0-or-later
/// \file progress.h
/// One line on stderr that says how far a long job is and how long it will still take. On a
/// terminal the line is rewritten; in a log every step gets a line. Safe for several threads.
/// Tests: tests/analysis/kat/kat_run_test.cpp
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace powderlink {

class Progress {
 public:
  /// \param what   of the job, such as "kat run"
  /// \param total  number of steps expected; may grow
  Progress(std::string what, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// \param free_of_cost  a step that was there already and says nothing of the time left
  void step_done(const std::string& detail, bool free_of_cost = false);
  void expect_more(int steps);

 private:
  void show(const std::string& detail);

  std::mutex mutex_;
  std::string what_;
  int total_;
  int done_ = 0;
  int costly_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
};

/// "42 s", "3 min", "1.5 h"
std::string short_time(double seconds);

}  // namespace powderlink
