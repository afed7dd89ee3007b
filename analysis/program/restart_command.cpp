// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/flow/restart/checkpoints.h"
#include "analysis/flow/restart/prepare.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"

namespace powderlink::analysis {

namespace {

struct Options {
  std::string folder, json, dem_prefix = kUsualDemPrefix;
  std::optional<double> time_step_s;
  bool prepare = false;
};

std::string json_of(const CheckpointPair& pair, bool prepared) {
  nlohmann::ordered_json j;
  j["time_s"] = pair.fields.time_s;
  j["time_name"] = pair.fields.name;
  j["step"] = pair.dem.step;
  j["fields"] = nlohmann::ordered_json::array();
  for (const auto& folder : pair.fields.folders) j["fields"].push_back(folder.string());
  j["restart_file"] = pair.dem.file.string();
  j["prepared"] = prepared;
  return j.dump(1) + "\n";
}

void run(const Options& o) {
  const Checkpoints found = require_checkpoints(o.folder, o.time_step_s, o.dem_prefix);
  for (const std::string& line : found.refused()) {
    fmt::print(stderr, "powderlink: later, but of no use: {}\n", line);
  }
  const CheckpointPair& pair = *found.last;
  if (!o.json.empty()) require_folder_of(o.json);
  const auto& folders = pair.fields.folders;
  fmt::print("last complete pair: time {:.9g} s, DEM step {}\n  fields   {}{}\n  restart  {}\n",
             pair.fields.time_s, pair.dem.step, folders.front().string(),
             folders.size() > 1 ? fmt::format(" and {} more processors", folders.size() - 1) : "",
             pair.dem.file.string());
  const std::string stale = found.stale_processors();
  if (!stale.empty()) fmt::print("note: {}\n", stale);
  if (o.prepare) {
    for (const std::string& line : prepare_restart(o.folder, found)) fmt::print("{}\n", line);
    fmt::print(
        "to continue: a LIGGGHTS script with `read_restart {}latest` in place of create_box and\n"
        "what fills the box; then the same mpirun line. endTime must be after {:g} s.\n",
        o.dem_prefix, pair.fields.time_s);
  } else {
    fmt::print(
        "to continue: --prepare moves later time folders to discarded/, "
        "sets startFrom latestTime and links\n"
        "{0}latest; or do so by hand: startFrom startTime; startTime {1}; "
        "and a LIGGGHTS script with\n"
        "`read_restart {0}{2}` in place of create_box and what fills the box.\n",
        o.dem_prefix, pair.fields.name, pair.dem.step);
  }
  if (!o.json.empty()) write_file(o.json, json_of(pair, o.prepare));
}

}  // namespace

void add_restart_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "restart",
      "the last complete pair of checkpoints of a coupled run, and how to go on from it");
  auto o = std::make_shared<Options>();
  c->add_option("case", o->folder, "folder of the coupled run")->required();
  c->add_option("--json", o->json, "write the pair to this file too");
  c->add_option("--dt", o->time_step_s, "DEM time step [s] (default: from log.liggghts or in.*)");
  c->add_option("--checkpoint", o->dem_prefix,
                "beginning of LIGGGHTS's restart files within the case: "
                "the word after `checkpoint` of fix couple/bridge")
      ->capture_default_str();
  c->add_flag("--prepare", o->prepare,
              "make the case start from it; later time folders are moved to discarded/");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
