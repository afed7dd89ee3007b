// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace powderlink {

std::string short_time(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {
  show("");
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::step_done(const std::string& detail, bool free_of_cost) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  if (!free_of_cost) ++costly_;
  total_ = std::max(total_, done_);
  show(detail);
}

void Progress::expect_more(int steps) {
  const std::lock_guard<std::mutex> lock(mutex_);
  total_ += steps;
}

void Progress::show(const std::string& detail) {
  std::string line = fmt::format("{}: {} of {} runs", what_, done_, total_);
  if (costly_ > 0 && done_ < total_) {
    const double used =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    line += ", about " + short_time(used / costly_ * (total_ - done_)) + " left";
  }
  if (!detail.empty()) line += "; " + detail;
  fmt::print(stderr, terminal_ ? "\r\033[K{}" : "{}\n", line);
  std::fflush(stderr);
}

}  // namespace powderlink
