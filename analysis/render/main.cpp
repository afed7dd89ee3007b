// SPDX-License-Identifier: GPL-3.0-or-later
/// \file main.cpp
/// powderlink-render series|png|table: what a drop test left behind, to look at;
/// flow|flow-series: the same for a coupled run.
#include <unistd.h>
#include <vtkLogger.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include "analysis/render/flow_picture.h"
#include "analysis/render/flow_series.h"
#include "analysis/render/picture.h"
#include "analysis/render/residual_table.h"
#include "analysis/render/run_directory.h"
#include "analysis/render/series.h"
#include "base/files/write_file.h"

namespace {

using namespace powderlink::render;

/// Progress with the time left, on a terminal and only when it takes long.
class Meter {
 public:
  void operator()(std::size_t done, std::size_t all) {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start_;
    if (isatty(STDERR_FILENO) == 0 || since.count() < 2.0) return;
    const double left = since.count() * static_cast<double>(all - done) / static_cast<double>(done);
    std::fprintf(stderr, "\rpowderlink-render: %zu of %zu states, %.0f s left ", done, all, left);
    if (done == all) std::fputc('\n', stderr);
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Arguments {
  std::string run, picture_file = "kat.png", table_file;
  std::optional<double> time_step_s;
  PictureOptions picture;
  std::string flow_file = "flow.png";
  FlowPictureOptions flow;
};

void add_common(CLI::App* command, Arguments& arguments) {
  command->add_option("run", arguments.run, "folder of a drop test (holds post/)")->required();
  command->add_option("--time-step", arguments.time_step_s,
                      "time step [s]; default: time_step_s of kat_results.json");
  command->add_option("--fix", arguments.picture.fix, "id of the fix kat/drop in the input script")
      ->capture_default_str();
}

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Drop tests and coupled runs for ParaView, as pictures and as tables.",
               "powderlink-render");
  app.require_subcommand(1);

  auto* series = app.add_subcommand("series", "write particles.pvd and plate.pvd for ParaView");
  add_common(series, arguments);

  auto* png = app.add_subcommand("png", "draw a picture, no display needed");
  add_common(png, arguments);
  png->add_option("-o,--output", arguments.picture_file, "the picture")->capture_default_str();
  auto* time = png->add_option("--time", arguments.picture.time_s, "one state, nearest to T [s]");
  auto* last = png->add_flag("--last", arguments.picture.last, "one state, the last one");
  auto* frames = png->add_option("--frames", arguments.picture.frames,
                                 "states side by side, from before the impact on")
                     ->capture_default_str();
  time->excludes(last)->excludes(frames);
  last->excludes(frames);
  png->add_option("--flight", arguments.picture.flight_s,
                  "free flight after the last state [s]; default: as long as the picture needs");
  png->add_option("--window", arguments.picture.window_um, "width of the part shown [um]");
  png->add_option("--width", arguments.picture.width_px, "width of the picture [pixels]")
      ->capture_default_str();
  png->add_option("--title", arguments.picture.title, "instead of velocity and critical diameter");

  auto* table = app.add_subcommand("table", "kat_results.json as columns for gnuplot");
  table->add_option("run", arguments.run, "folder of a drop test")->required();
  table->add_option("-o,--output", arguments.table_file, "default: standard output");

  auto* flow_series = app.add_subcommand(
      "flow-series", "coupled run: write particles.pvd and case.foam for ParaView");
  auto* flow = app.add_subcommand("flow", "coupled run: draw gas and particles, no display needed");
  for (auto* command : {flow_series, flow}) {
    command->add_option("case", arguments.run, "folder of a coupled run (holds post/)")->required();
    command->add_option("--dt", arguments.flow.time_step_s,
                        "DEM time step [s]; default: from the dumps, log.liggghts or in.*");
  }
  flow->add_option("-o,--output", arguments.flow_file, "the picture")->capture_default_str();
  flow->add_option("--time", arguments.flow.time_s,
                   "the dump nearest to T of the gas [s]; default: the last");
  flow->add_option("--axis", arguments.flow.axis,
                   "x, y or z, to the right; default: that of the channel");
  flow->add_option("--length", arguments.flow.length_m,
                   "length of a strip [m]; default: 8 times the channel's height");
  flow->add_option("--at", arguments.flow.at_m,
                   "one strip around this place on the axis [m]; default: begin, middle and end");
  flow->add_option("--width", arguments.flow.width_px, "width of the picture [pixels]")
      ->capture_default_str();
  flow->add_option("--title", arguments.flow.title, "instead of the time");

  CLI11_PARSE(app, argc, argv);
  if (*flow_series) {
    const FlowSeriesFiles written =
        write_flow_series(arguments.run, arguments.flow.time_step_s, Meter());
    std::cout << written.states << " states: " << written.particles_pvd.string() << ", "
              << written.foam.string() << '\n';
    return 0;
  }
  if (*flow) {
    write_flow_picture(arguments.run, arguments.flow_file, arguments.flow);
    std::cout << arguments.flow_file << '\n';
    return 0;
  }
  if (*table) {
    const std::string text = residual_table(read_results(arguments.run), arguments.run);
    if (arguments.table_file.empty()) {
      std::cout << text;
    } else {
      powderlink::write_file(arguments.table_file, text);
    }
    return 0;
  }
  const RunDirectory directory = open_run(arguments.run, arguments.time_step_s);
  if (*series) {
    const SeriesFiles written = write_series(directory, arguments.picture.fix, Meter());
    std::cout << written.states << " states: " << written.particles_pvd.string() << ", "
              << written.plate_pvd.string() << '\n';
  } else {
    write_picture(directory, arguments.picture_file, arguments.picture);
    std::cout << arguments.picture_file << '\n';
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    // Errors still reach the observers of the readers; the user gets one message.
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "powderlink-render: " << error.what() << '\n';
    return 1;
  }
}
