// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/drop_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "base/files/file_text.h"
#include "base/files/sha1.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"
#include "base/process/child_process.h"
#include "liggghts_styles/kat_drop/kat_results.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFinished = "finished";
constexpr const char* kScreen = "screen.txt";

/// Size and time of the program and of the styles that it loads: a new build runs again.
std::string program_state(const fs::path& program) {
  std::string state;
  for (const fs::path& file : {program, program.parent_path() / "../lib/libpowderlink_styles.so"}) {
    std::error_code absent;
    const auto size = fs::file_size(file, absent);
    if (absent) continue;
    state += fmt::format("{} {}\n", size, fs::last_write_time(file).time_since_epoch().count());
  }
  return state;
}

DropResult parse_results(const fs::path& file) {
  const host::KatResults results = host::read_kat_results(file);
  DropResult r;
  r.largest_attached_m = results.largest_attached_m;
  r.smallest_detached_m = results.smallest_detached_m;
  for (const host::KatGrainResult& g : results.grains)
    r.particles.push_back({g.diameter_m, g.attached > 0.0, g.speed_m_s, g.energy_residual});
  return r;
}

/// The line that LIGGGHTS ended with, for the message.
std::string last_error(const fs::path& screen) {
  std::istringstream text(file_text_or_empty(screen));
  std::string last, error;
  for (std::string line; std::getline(text, line);) {
    if (line.find("ERROR") != std::string::npos && error.empty()) error = line;
    if (!line.empty()) last = line;
  }
  return error.empty() ? last : error;
}

}  // namespace

fs::path find_liggghts() {
  const char* given = std::getenv("POWDERLINK_LIGGGHTS");
  const fs::path program =
      given != nullptr && *given != '\0'
          ? fs::path(given)
          : fs::canonical("/proc/self/exe").parent_path() / "liggghts-powderlink";
  if (!fs::is_regular_file(program) || ::access(program.c_str(), X_OK) != 0) {
    throw InvalidInput("liggghts-powderlink", program.string(), "a program that can be run",
                       "build it (cmake --build), or name it in the variable POWDERLINK_LIGGGHTS");
  }
  return fs::absolute(program);
}

DropResult run_drop(const DropRunner& runner, const DropScript& drop, const fs::path& folder) {
  const std::string script = drop_script(drop);
  const std::string hash = sha1(script + program_state(runner.program));
  const fs::path results = folder / kResultsFile;
  if (fs::is_regular_file(results) && file_text_or_empty(folder / kFinished) == hash) {
    DropResult r = parse_results(results);
    r.reused = true;
    return r;
  }
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) {
    throw InvalidInput("folder of a run", folder.string(), "a folder that may be made",
                       problem.message() + "; name another one with --out");
  }
  for (const char* stale : {kFinished, kResultsFile, "post"}) fs::remove_all(folder / stale);
  write_file(folder / kScriptFile, script);
  if (drop.options.mesh_wall) write_file(folder / kPlateFile, plate_stl(drop));

  const fs::path screen = fs::absolute(folder / kScreen);
  const ChildOutcome outcome =
      run_child({runner.program.string(), "-in", kScriptFile}, folder, screen, runner.wall_limit_s);
  if (outcome.over_time) {
    throw InvalidInput("LIGGGHTS in " + folder.string(),
                       fmt::format("{:.0f} s without an end", outcome.wall_s),
                       fmt::format("{:.0f} s", runner.wall_limit_s),
                       "raise --wall-limit, or use fewer particles; see " + screen.string());
  }
  if (outcome.exit_status != 0 || !fs::is_regular_file(results)) {
    throw InvalidInput("LIGGGHTS in " + folder.string(),
                       fmt::format("exit status {}: {}", outcome.exit_status, last_error(screen)),
                       "exit status 0 and a file " + std::string(kResultsFile),
                       "read " + screen.string());
  }
  DropResult r = parse_results(results);
  r.wall_s = outcome.wall_s;
  write_file(folder / kFinished, hash);
  return r;
}

}  // namespace powderlink::analysis
