// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/restart/prepare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "analysis/write_file.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& what, const fs::path& place, const std::string& given) {
  throw InvalidInput(what + " " + place.string(), given, "a case that may be changed",
                     "check the rights of the case and the space left, then try again");
}

/// controlDict with `startFrom latestTime;`, the rest as it is.
std::string new_control(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream all;
  all << in.rdbuf();
  const std::string text = all.str();
  static const std::regex entry("(^|\\n)([ \\t]*startFrom[ \\t]+)[^;\\n]*;");
  if (!std::regex_search(text, entry)) {
    throw InvalidInput("setting the start in " + file.string(), "no entry startFrom",
                       "a line `startFrom latestTime;` in the file itself", "write it there");
  }
  return std::regex_replace(text, entry, "$1$2latestTime;");
}

/// A name in `folder` that is not taken.
fs::path free_name(const fs::path& folder, const std::string& name) {
  fs::path place = folder / name;
  for (int i = 1; fs::exists(place); ++i) place = folder / fmt::format("{}.{}", name, i);
  return place;
}

}  // namespace

std::vector<std::string> prepare_restart(const fs::path& case_folder,
                                         const Checkpoints& checkpoints) {
  const CheckpointPair& pair = *checkpoints.last;
  const fs::path control = case_folder / "system" / "controlDict";
  // Everything that can be refused comes before anything that is changed.
  const std::string text = new_control(control);
  std::vector<std::string> done;

  for (const FieldCheckpoint& fields : checkpoints.fields) {
    if (fields.time_s <= pair.fields.time_s) continue;
    for (const fs::path& folder : fields.folders) {
      if (!fs::exists(folder)) continue;
      const fs::path parent = folder.parent_path();
      const bool decomposed = !fs::equivalent(parent, case_folder);
      const fs::path aside =
          decomposed ? case_folder / "discarded" / parent.filename() : case_folder / "discarded";
      std::error_code problem;
      fs::create_directories(aside, problem);
      const fs::path target = free_name(aside, fields.name);
      if (!problem) fs::rename(folder, target, problem);
      if (problem) refuse("moving", folder, problem.message());
      done.push_back(fmt::format("moved {} to {}", folder.string(), target.string()));
    }
  }

  const fs::path link = case_folder / (checkpoints.dem_prefix + "latest");
  const fs::path beside = link.string() + fmt::format(".part{}", ::getpid());
  std::error_code problem;
  fs::create_symlink(pair.dem.file.filename(), beside, problem);
  if (!problem) fs::rename(beside, link, problem);
  if (problem) refuse("linking", link, problem.message());
  done.push_back(fmt::format("{} -> {}", link.string(), pair.dem.file.filename().string()));

  write_file(control, text);
  done.push_back(
      fmt::format("{}: startFrom latestTime; which is {}", control.string(), pair.fields.name));
  return done;
}

}  // namespace powderlink::analysis
