// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/run_directory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "analysis/render/files.h"
#include "base/invalid_input.h"

namespace powderlink::render {
namespace fs = std::filesystem;
namespace {

std::vector<DumpFile> list_dumps(const fs::path& folder, const std::regex& name) {
  std::vector<DumpFile> found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    std::smatch match;
    if (std::regex_match(file, match, name)) found.push_back({std::stol(match[1]), entry.path()});
  }
  std::sort(found.begin(), found.end(), [](const DumpFile& a, const DumpFile& b) {
    return a.step != b.step ? a.step < b.step : a.path < b.path;
  });
  return found;
}

/// A positive number, or nothing when the key is absent or null.
std::optional<double> positive(const nlohmann::json& object, const char* key,
                               const fs::path& file) {
  if (!object.contains(key) || object[key].is_null()) return {};
  const bool is_number = object[key].is_number();
  const double value = is_number ? object[key].get<double>() : 0.0;
  if (!is_number || !(value > 0.0) || !std::isfinite(value)) {
    throw InvalidInput("reading " + file.string() + ": " + key, object[key].dump(),
                       "a number above 0", "run the drop test again or correct the value");
  }
  return value;
}

}  // namespace

RunResults read_results(const fs::path& run) {
  RunResults results;
  const fs::path file = run / "kat_results.json";
  if (!fs::exists(file)) return results;
  try {
    const auto json = nlohmann::json::parse(file_text(file));
    results.critical_diameter_m = positive(json, "critical_diameter_m", file);
    results.impact_velocity_m_s = positive(json, "impact_velocity_m_s", file);
    results.time_step_s = positive(json, "time_step_s", file);
    for (const auto& item : json.value("particles", nlohmann::json::array())) {
      const auto& flag = item.at("attached");
      const bool attached = flag.is_boolean() ? flag.get<bool>() : flag.get<double>() != 0.0;
      const auto& speed = item.at("speed_m_s");
      results.particles.push_back({item.at("diameter_m").get<double>(), attached,
                                   speed.is_null() ? 0.0 : speed.get<double>()});
    }
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput("reading " + file.string(), error.what(),
                       "JSON with critical_diameter_m, impact_velocity_m_s, time_step_s "
                       "and particles (each with diameter_m, attached, speed_m_s)",
                       "run the drop test again");
  }
  return results;
}

RunDirectory open_run(const fs::path& run, std::optional<double> time_step_s) {
  if (!fs::is_directory(run)) {
    throw InvalidInput("opening the run", run.string(), "a folder that exists",
                       "give the folder that holds post/ of a drop test");
  }
  if (time_step_s && !(*time_step_s > 0.0 && std::isfinite(*time_step_s))) {
    throw InvalidInput("option --time-step", std::to_string(*time_step_s), "seconds above 0",
                       "give the value of the `timestep` command of the input script");
  }
  RunDirectory found;
  found.path = run;
  found.particles = list_dumps(run / "post", std::regex("particles_([0-9]{1,18})\\.vtp"));
  found.plate = list_dumps(run / "post", std::regex("plate_([0-9]{1,18})\\.(vtp|vtk|stl)"));
  if (found.particles.empty()) {
    throw InvalidInput("opening the run", run.string() + " without post/particles_<step>.vtp",
                       "at least one file of `dump custom/vtk`",
                       "add to the input script: dump vtk all custom/vtk 1000 post/particles_*.vtp "
                       "id type radius x y z vx vy vz fx fy fz f_kat[1] f_kat[2] f_kat[3]");
  }
  found.results = read_results(run);
  found.time_step_s = time_step_s ? time_step_s : found.results.time_step_s;
  return found;
}

double RunDirectory::time_s(long step) const {
  if (!time_step_s) {
    throw InvalidInput("physical times of the series", path.string() + " without a time step",
                       "kat_results.json with time_step_s, or the option --time-step",
                       "add --time-step and the value of the `timestep` command [s]");
  }
  return static_cast<double>(step) * *time_step_s;
}

}  // namespace powderlink::render
