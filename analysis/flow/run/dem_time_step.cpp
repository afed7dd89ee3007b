// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/dem_time_step.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

const char* const kAllowed = "one positive number of seconds after `timestep`";
const char* const kToDo = "give the DEM time step: --dt SECONDS";

/// Numbers after the command `timestep` in a log or script; what is no number is a variable.
void add_time_steps(const fs::path& file, std::set<double>& found) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream text(line);
    std::string command, value;
    if (!(text >> command >> value) || command != "timestep") continue;
    double step = 0.0;
    const char* last = value.data() + value.size();
    const auto [end, error] = std::from_chars(value.data(), last, step);
    if (error == std::errc() && end == last) found.insert(step);
  }
}

double only_one(const fs::path& place, const std::set<double>& found) {
  if (found.size() > 1 || !(*found.begin() > 0.0 && std::isfinite(*found.begin()))) {
    std::string list;
    for (const double step : found) list += (list.empty() ? "" : ", ") + number_text(step) + " s";
    throw InvalidInput("time step of the DEM in " + place.string(), list, kAllowed, kToDo);
  }
  return *found.begin();
}

}  // namespace

double dem_time_step_s(const fs::path& case_folder, std::optional<double> given_s) {
  if (given_s) {
    if (!(*given_s > 0.0 && std::isfinite(*given_s))) {
      throw InvalidInput("option --dt", number_text(*given_s) + " s", "above 0 s", kToDo);
    }
    return *given_s;
  }
  std::set<double> found;
  const fs::path log = case_folder / "log.liggghts";
  add_time_steps(log, found);
  if (!found.empty()) return only_one(log, found);
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(case_folder, problem)) {
    if (entry.path().filename().string().rfind("in.", 0) == 0) add_time_steps(entry, found);
  }
  if (!found.empty()) return only_one(case_folder / "in.*", found);
  throw InvalidInput("time step of the DEM in " + case_folder.string(),
                     "neither log.liggghts nor a script in.* with a number after `timestep`",
                     kAllowed, kToDo);
}

}  // namespace powderlink::analysis
