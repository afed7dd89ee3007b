// SPDX-License-Identifier: GPL-3.0-or-later
/// \file main.cpp
/// powderlink-render series|png|table: what a drop test left behind, to look at.
#include <unistd.h>
#include <vtkLogger.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include "analysis/render/files.h"
#include "analysis/render/picture.h"
#include "analysis/render/residual_table.h"
#include "analysis/render/run_directory.h"
#include "analysis/render/series.h"

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
  CLI::App app("Drop tests for ParaView, as pictures and as tables.", "powderlink-render");
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

  CLI11_PARSE(app, argc, argv);
  if (*table) {
    const std::string text = residual_table(read_results(arguments.run), arguments.run);
    if (arguments.table_file.empty()) {
      std::cout << text;
    } else {
      write_file(arguments.table_file, text);
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
