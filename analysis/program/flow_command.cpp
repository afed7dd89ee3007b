// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "analysis/flow/flow_figures.h"
#include "analysis/flow/flow_report.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kQuiet_s = 2.0;

struct Options {
  std::string folder, json, out;
  FlowOptions flow;
  std::vector<double> slice;
  bool no_figures = false;
};

/// The slice with the smallest 90 % width across: where a jet is focused.
std::string focus(const FlowStatistics& p) {
  const char axis = p.window().axis.letter(), side = "xyz"[p.window().axis.across()];
  constexpr std::uint64_t kEnough = 100;  // particles, for a 90 % interval
  const SliceProfile* best = nullptr;
  long place = 0;
  for (const auto& [k, slice] : p.profile()) {
    if (slice.across.count() < kEnough) continue;
    if (best == nullptr || slice.across.central_width(0.9) < best->across.central_width(0.9)) {
      best = &slice;
      place = k;
    }
  }
  if (best == nullptr) return "";
  return fmt::format("narrowest 90 % interval in {}: {:.4g} mm at {} = {:.4g} mm\n", side,
                     1e3 * best->across.central_width(0.9), axis, 1e3 * p.centre_m(place));
}

std::string table(const FlowReport& report) {
  TextTable t({"established flow", "value", "unit"});
  t.flush_left(2);
  const auto add = [&](const char* name, const std::optional<double>& value, const char* unit) {
    t.add({name, value ? fmt::format("{:.5g}", *value) : "-", unit});
  };
  add("pressure slope", report.slope ? std::optional(report.slope->slope_Pa_m) : std::nullopt,
      "Pa/m");
  add("solids flow", report.mean_flow_kg_s, "kg/s");
  add("its RMS deviation",
      report.irregularity ? std::optional(report.irregularity->rms_percent) : std::nullopt, "%");
  add("  moving average over", report.options.measures.average_s, "s");
  add("particle velocity, mean", report.particles.velocity_mean_m_s(), "m/s");
  add("particle velocity, spread", report.particles.velocity_deviation_m_s(), "m/s");
  add("particles in the case", report.particles.mean_particles(), "");
  add("coupling's share of the time", report.cost.coupling_share_percent, "%");
  add("wall clock per simulated ms", report.cost.wall_s_per_simulated_ms, "s");
  return t.text();
}

FlowProgress meter() {
  const auto start = std::chrono::steady_clock::now();
  return [start](std::size_t done, std::size_t all) {
    const double since =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (::isatty(STDERR_FILENO) == 0 || since < kQuiet_s) return;
    const double left = since * static_cast<double>(all - done) / static_cast<double>(done);
    fmt::print(stderr, "\rpowderlink: {} of {} dumps, {:.0f} s left ", done, all, left);
    if (done == all) fmt::print(stderr, "\n");
  };
}

void run(const Options& o) {
  const fs::path folder = find_coupled_case(o.folder);
  if (folder != fs::path(o.folder)) {
    fmt::print(stderr, "powderlink: the run is in {}\n", folder.string());
  }
  if (!o.json.empty()) require_folder_of(o.json);
  FlowOptions options = o.flow;
  if (!o.slice.empty()) options.flow_slice_m = Interval{o.slice[0], o.slice[1]};
  const FlowReport report = analyse_flow(folder, options, meter());

  const fs::path out = o.out.empty() ? folder / "flow" : fs::path(o.out);
  std::error_code problem;
  fs::create_directories(out, problem);
  if (problem) {
    throw InvalidInput("--out", out.string(), "a folder that may be made", problem.message());
  }
  for (const auto& [name, content] : flow_tables(report)) write_file(out / name, content);
  if (!o.json.empty()) write_file(o.json, flow_json(report));
  std::vector<std::string> notes = report.notes;
  if (!o.no_figures) {
    for (const std::string& note : draw_flow_figures(report, out)) notes.push_back(note);
  }
  for (const std::string& note : notes) fmt::print(stderr, "powderlink: {}\n", note);

  fmt::print("{}", table(report));
  if (report.slice_m) {
    fmt::print("solids flow along {} through {} = {:g} to {:g} m, {} states from {:g} s on\n",
               report.window().axis.name(), report.window().axis.letter(), report.slice_m->from,
               report.slice_m->to, report.times_s.size(), report.times_s.front());
  }
  for (const FlowFindings& findings : report.findings) fmt::print("{}", findings.text);
  fmt::print("{}tables{} are in {}\n", focus(report.particles), o.no_figures ? "" : " and figures",
             out.string());
}

}  // namespace

void add_flow_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "flow", "pressure slope, solids flow, velocities and concentration of a coupled run");
  auto o = std::make_shared<Options>();
  FlowOptions& flow = o->flow;
  c->add_option("case", o->folder, "folder of a coupled case (holds post/ and postProcessing/)")
      ->required();
  c->add_option("--json", o->json, "write the numbers to this file too");
  c->add_option("--out", o->out, "folder of tables and figures (default: flow/ in the case)");
  c->add_option("--from", flow.from_s, "the flow is established from this time of the gas on [s]")
      ->capture_default_str();
  c->add_option("--axis", flow.axis,
                "x, y, z, or -x, -y, -z for the way against it "
                "(default: where probes, mesh and particles point)");
  c->add_option("--from-z,--from-place", flow.from_m,
                "... and from this place on that axis on [m] "
                "(default: the last third of the channel)");
  c->add_option("--to-z,--to-place", flow.to_m, "... up to this one [m]");
  c->add_option("--slice", o->slice,
                "the solids flow is taken between these two places on the axis [m] "
                "(default: 10 mm in the middle of the established part)")
      ->expected(2);
  c->add_option("--slice-thickness", flow.slice_m,
                "slices of all profiles [m] (default: 1 mm, or a twentieth of a shorter channel)");
  c->add_option("--average", flow.measures.average_s,
                "window of the moving average of the solids flow [s]")
      ->capture_default_str();
  c->add_option("--cluster-threshold", flow.measures.cluster_threshold,
                "a cluster holds more than this many times the mean number of particles per length")
      ->capture_default_str();
  c->add_option("--cluster-length", flow.measures.cluster_length_m,
                "... over this length [m] or more")
      ->capture_default_str();
  c->add_option("--dt", flow.time_step_s,
                "DEM time step [s] (default: from the dumps, log.liggghts or in.*)");
  c->add_option("--log", flow.log, "output of powderFoam (default: the newest in the case)");
  c->add_option("--density", flow.density_kg_m3,
                "density of the gas [kg/m^3] (default: rho of constant/transportProperties)");
  c->add_option("--probes", flow.probes, "set of pressure probes, a folder of postProcessing/");
  c->add_flag("--no-figures", o->no_figures, "tables only");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
