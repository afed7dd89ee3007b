// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/solver_log.h"

#include <fstream>
#include <regex>
#include <string>

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kShort_s = 20.0;  // below, whole seconds are worse than 5 %

std::optional<fs::path> newest_log(const fs::path& case_folder) {
  std::optional<fs::path> newest;
  for (const char* name : {"log.powderFoam", "log.mpirun"}) {
    const fs::path log = case_folder / name;
    std::error_code problem;
    if (!fs::is_regular_file(log, problem)) continue;
    if (!newest || fs::last_write_time(log) > fs::last_write_time(*newest)) newest = log;
  }
  return newest;
}

struct Clock {
  double time_s = 0.0, execution_s = 0.0, wall_s = 0.0;
};

}  // namespace

SolverCost read_solver_cost(const fs::path& case_folder, double from_s) {
  SolverCost cost;
  const auto log = newest_log(case_folder);
  if (!log) return cost;
  static const std::regex time_line(R"(^\s*Time = ([-+0-9.eE]+)\s*s?\s*$)");
  static const std::regex clock_line(
      R"(ExecutionTime = ([0-9.eE+]+) s\s+ClockTime = ([0-9.eE+]+) s)");
  static const std::regex share_line(R"(coupling share\s*[:=]?\s*([0-9.]+)\s*%)",
                                     std::regex::icase);
  std::ifstream in(*log);
  std::string line;
  std::smatch match;
  std::optional<double> time;
  std::optional<Clock> first, last;
  while (std::getline(in, line)) {
    // The plain search is cheap, the expressions are not.
    if (line.find("Time = ") != std::string::npos) {
      if (std::regex_search(line, match, clock_line)) {
        if (!time || *time < from_s) continue;
        last = Clock{*time, std::stod(match[1]), std::stod(match[2])};
        if (!first) first = last;
      } else if (std::regex_search(line, match, time_line)) {
        time = std::stod(match[1]);
      }
    } else if (line.find('%') != std::string::npos && std::regex_search(line, match, share_line)) {
      cost.coupling_share_percent = std::stod(match[1]);
    }
  }
  if (first && last->time_s > first->time_s) {
    double spent_s = last->wall_s - first->wall_s;
    cost.by_processor_time = spent_s < kShort_s;
    if (cost.by_processor_time) spent_s = last->execution_s - first->execution_s;
    cost.wall_s_per_simulated_ms = spent_s / (1e3 * (last->time_s - first->time_s));
  }
  return cost;
}

}  // namespace powderlink::analysis
