// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/restart/prepare.h"

#include <fmt/format.h>
#include <unistd.h>

#include "analysis/flow/foam/foam_files.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& what, const fs::path& place, const std::string& given) {
  throw InvalidInput(what + " " + place.string(), given, "a case that may be changed",
                     "check the rights of the case and the space left, then try again");
}

/// Where a link leads, with the rights that the file has.
void write_control(const fs::path& control, const std::string& text) {
  const fs::path file = fs::canonical(control);
  const auto rights = fs::status(file).permissions();
  write_file(file, text);
  fs::permissions(file, rights);
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
  const FoamQuestion start{"system/controlDict", "startFrom"};
  std::optional<std::string> text;
  // Without the entry OpenFOAM starts from the latest time.
  if (!fs::is_regular_file(control) || read_foam_entry(case_folder, start)) {
    text = change_foam_entry(case_folder, start, "latestTime");
  }
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

  if (text) write_control(control, *text);
  done.push_back(
      fmt::format("{}: startFrom latestTime; which is {}", control.string(), pair.fields.name));
  return done;
}

}  // namespace powderlink::analysis
