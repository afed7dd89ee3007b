// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "analysis/kat/device/device_rows.h"
#include "analysis/kat/device/device_session.h"
#include "analysis/kat/device/session_log.h"
#include "analysis/kat/study/study_material.h"
#include "analysis/program/commands.h"
#include "base/files/file_patterns.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> logs, commands, settings;
  std::string port, log, csv, study, particle, substrate;
  unsigned baud = 115200;
  double wait_s = 60.0;
  DeviceSigmas sigmas;
  std::vector<double> diameters_um, diameter_sigmas_um;
  bool force = false, skip_damaged = false;
};

/// Before anything is dropped: what would be lost at the end.
void check_outputs(const Options& o) {
  for (const std::string* file : {&o.log, &o.csv, &o.study}) {
    if (file->empty()) continue;
    require_folder_of(*file);
    if (fs::exists(*file) && !o.force) {
      throw InvalidInput("output file", *file + ", which exists", "a new file",
                         "name another one, or replace it with --force");
    }
  }
  if (o.study.empty()) return;
  if (o.particle.empty() || o.substrate.empty()) {
    throw InvalidInput("--study", "no --particle or no --substrate", "both materials",
                       "such as --particle 316L --substrate borosilicate_glass");
  }
  material_option(o.particle, "particle");
  material_option(o.substrate, "substrate");
  if (!o.diameters_um.empty() && o.csv.empty()) {
    throw InvalidInput("--study", "critical diameters, but no --csv", "a table for the study",
                       "name it with --csv");
  }
}

std::vector<LoggedDrop> from_device(const Options& o) {
  std::optional<SessionLog> log;
  DeviceSession device(o.port, o.baud, o.wait_s, [&](const std::string& line) {
    if (log) log->take(line);
    fmt::print("{}\n", line);
    std::fflush(stdout);
  });
  if (!o.log.empty()) log.emplace(o.log, o.force);
  try {
    if (!o.settings.empty()) device.command("set", o.settings);
    for (const std::string& command : o.commands) device.command(command);
  } catch (const InvalidInput&) {
    if (log) log->finish();  // what was measured so far is not lost
    throw;
  }
  if (log) log->finish();
  device.log().end();
  for (const std::string& note : device.log().notes()) fmt::print(stderr, "powderlink: {}\n", note);
  return device.log().drops();
}

std::vector<LoggedDrop> from_logs(const Options& o) {
  std::vector<LoggedDrop> drops;
  for (const fs::path& file : expand_patterns(o.logs, "logs of the KAT device")) {
    const DropLog log = read_drop_log(file, o.skip_damaged);
    for (const std::string& note : log.notes()) fmt::print(stderr, "powderlink: {}\n", note);
    drops.insert(drops.end(), log.drops().begin(), log.drops().end());
  }
  if (drops.empty()) {
    throw InvalidInput(
        "logs of the KAT device", "no whole drop in them", "at least one",
        "log a drop: powderlink kat device --port PORT --do arm --do drop --log FILE");
  }
  return drops;
}

void run(const Options& o) {
  if (o.port.empty() == o.logs.empty()) {
    throw InvalidInput("kat device",
                       o.port.empty() ? "neither a port nor a log" : "a port and logs",
                       "one of them", "give --port PORT with --do, or log files");
  }
  check_outputs(o);
  const auto drops = o.port.empty() ? from_logs(o) : from_device(o);
  const DeviceRows found = device_rows(drops, o.sigmas, o.diameters_um, o.diameter_sigmas_um);
  for (const std::string& note : found.notes) fmt::print(stderr, "powderlink: {}\n", note);
  if (found.rows.empty()) {
    if (drops.empty() && o.csv.empty() && o.study.empty()) return;  // only asked for the status
    throw InvalidInput("drops of the KAT device",
                       fmt::format("{} drops, none without fault", drops.size()),
                       "at least one that was measured", "see the faults above and drop again");
  }
  fmt::print("{}", device_table(found.rows));
  if (!o.csv.empty()) write_file(o.csv, device_csv(found.rows));
  if (!o.study.empty()) {
    const fs::path folder = fs::absolute(o.study).parent_path();
    const std::string csv =
        o.csv.empty() ? "" : fs::absolute(o.csv).lexically_relative(folder).string();
    write_file(o.study, device_study(found.rows, fs::path(o.study).stem().string(), csv,
                                     material_option(o.particle, "particle"),
                                     material_option(o.substrate, "substrate")));
  }
}

}  // namespace

void add_kat_device_command(CLI::App& kat) {
  CLI::App* c = kat.add_subcommand(
      "device", "drops of the KAT device, from its serial port or saved logs, as rows of a study");
  auto o = std::make_shared<Options>();
  c->add_option("log", o->logs, "logs of the device (patterns may be quoted)");
  c->add_option("--port", o->port, "serial port, such as /dev/ttyACM0");
  c->add_option("--baud", o->baud, "its speed")->capture_default_str();
  c->add_option("--set", o->settings, "KEY=VALUE of the device, before the commands");
  c->add_option("--do", o->commands, "commands, in turn; drop waits for its report")
      ->check(CLI::IsMember(
          {"version", "status", "config", "selftest", "arm", "drop", "abort", "clear", "report"}));
  c->add_option("--wait", o->wait_s, "longest wait for a command [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  c->add_option("--log", o->log, "write all lines of the device to this file as they come");
  c->add_option("--csv", o->csv, "write the rows of a study to this file");
  c->add_option("--study", o->study, "write a study of these rows (TOML)");
  c->add_option("--particle", o->particle, material_option_help() + "; of the powder, for --study");
  c->add_option("--substrate", o->substrate, "the same of the plate");
  c->add_option("--critical-diameter", o->diameters_um,
                "critical diameters [um] from the microscope, one per drop");
  c->add_option("--critical-diameter-sigma", o->diameter_sigmas_um,
                "their standard deviations [um], one for all or one per drop")
      ->check(CLI::PositiveNumber);
  c->add_option("--carrier-sigma", o->sigmas.carrier_um, "uncertainty of carrier_um [um]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--beam-sigma", o->sigmas.beam_um, "uncertainty of beam_um [um]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--edge-sigma", o->sigmas.edge_us, "uncertainty of an edge [us]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--latency-sigma", o->sigmas.latency_us, "uncertainty of latency_us [us]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_flag("--skip-damaged", o->skip_damaged, "leave damaged drops of logs out, with a note");
  c->add_flag("--force", o->force, "replace output files that exist");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
