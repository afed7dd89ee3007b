// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/run_directory.h"

#include <algorithm>
#include <regex>
#include <string>

#include "base/invalid_input.h"
#include "liggghts_styles/kat_drop/kat_results.h"

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

}  // namespace

RunResults read_results(const fs::path& run) {
  RunResults results;
  const fs::path file = run / "kat_results.json";
  if (!fs::exists(file)) return results;
  const host::KatResults read = host::read_kat_results(file);
  const auto known = [](double value) { return value > 0.0 ? std::optional(value) : std::nullopt; };
  results.critical_diameter_m = known(read.critical_diameter_m);
  results.impact_velocity_m_s = known(read.impact_velocity_m_s);
  results.time_step_s = known(read.time_step_s);
  for (const host::KatGrainResult& g : read.grains)
    results.particles.push_back({g.diameter_m, g.attached > 0.0, g.speed_m_s});
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
