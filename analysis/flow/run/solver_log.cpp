// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/solver_log.h"

#include <fstream>
#include <regex>
#include <string>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kShort_s = 20.0;  // below, whole seconds are worse than 5 %

constexpr std::streamsize kHead_bytes = 200'000;  // LIGGGHTS's own beginning may come first

bool is_of_powder_foam(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(static_cast<std::size_t>(kHead_bytes), '\0');
  in.read(head.data(), kHead_bytes);
  head.resize(static_cast<std::size_t>(in.gcount()));
  for (std::size_t at = 0; (at = head.find("Exec ", at)) != std::string::npos; ++at) {
    const std::string line = head.substr(at, head.find('\n', at) - at);
    if (line.find(" : ") != std::string::npos && line.find("powderFoam") != std::string::npos) {
      return true;
    }
  }
  return false;
}

struct Clock {
  double time_s = 0.0, execution_s = 0.0, wall_s = 0.0;
};

}  // namespace

fs::path find_solver_log(const fs::path& case_folder) {
  fs::path newest;
  bool surely = false;
  fs::file_time_type written;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(case_folder, problem)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().filename().string();
    const bool sure = is_of_powder_foam(entry.path());
    if (!sure && name != "log.powderFoam" && name != "log.mpirun") continue;
    if (newest.empty() || sure > surely || (sure == surely && entry.last_write_time() > written)) {
      newest = entry.path();
      surely = sure;
      written = entry.last_write_time();
    }
  }
  return newest;
}

SolverCost read_solver_cost(const fs::path& case_folder, double from_s,
                            const std::optional<fs::path>& given) {
  SolverCost cost;
  if (given && !fs::is_regular_file(*given)) {
    throw InvalidInput("option --log", given->string(), "a file with the output of powderFoam",
                       "correct the path");
  }
  cost.log = given ? *given : find_solver_log(case_folder);
  if (cost.log.empty()) return cost;
  // Before it may stand what mpirun --tag-output writes: [1,0]<stdout>:
  static const std::regex time_line(
      R"(^(?:\[[^\]]*\](?:<\w+>)?:?)?\s*Time = ([-+0-9.eE]+)\s*s?\s*$)");
  static const std::regex clock_line(
      R"(ExecutionTime = ([0-9.eE+]+) s\s+ClockTime = ([0-9.eE+]+) s)");
  static const std::regex share_line(R"(coupling share\s*[:=]?\s*([0-9.]+)\s*%)",
                                     std::regex::icase);
  std::ifstream in(cost.log);
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
