// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "analysis/program/commands.h"
#include "analysis/report/report_page.h"
#include "base/files/write_file.h"
#include "base/gnuplot/gnuplot.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> studies, dem;
  std::string output;
  bool first_only = false;
};

void assign(std::vector<std::unique_ptr<StudyResult>>& results, const std::string& file) {
  const DemFile dem = read_dem_file(file);
  bool taken = false;
  for (const auto& r : results) taken = r->take(dem) || taken;
  if (!taken) {
    throw InvalidInput("--dem " + file, "rows or fitted values of none of these studies",
                       "a comparison of one of them as it is now",
                       "write it anew with: powderlink compare STUDY --backend dem --json FILE");
  }
}

void run(const Options& o) {
  if (!have_gnuplot()) {
    throw InvalidInput("drawing the figures of a report", "no gnuplot in PATH", "gnuplot 5.4",
                       "install gnuplot-nox, or use 'compare' and 'diagnose'");
  }
  require_folder_of(o.output);
  ReportPage page;
  std::vector<fs::path> inputs;
  for (const std::string& file : o.studies) {
    page.results.push_back(
        std::make_unique<StudyResult>(file, page.results.empty() || !o.first_only));
    const StudyResult& r = *page.results.back();
    for (const std::string& note : r.study.notes) fmt::print(stderr, "powderlink: {}\n", note);
    inputs.emplace_back(file);
    for (const fs::path& table : r.study.measurements) {
      if (std::find(inputs.begin(), inputs.end(), table) == inputs.end()) inputs.push_back(table);
    }
  }
  for (const std::string& file : o.dem) {
    assign(page.results, file);
    inputs.emplace_back(file);
  }

  const fs::path output = o.output;
  page.folder = output.parent_path() / (output.stem().string() + "_figures");
  std::error_code problem;
  fs::create_directories(page.folder, problem);
  if (problem) {
    throw InvalidInput("folder of the figures", page.folder.string(), "a folder that may be made",
                       problem.message() + "; name another file with -o");
  }
  std::map<std::string, int> seen;
  for (const auto& r : page.results) {
    std::string prefix = safe_name(r->study.name);
    const int count = ++seen[prefix];
    if (count > 1) prefix += fmt::format("_{}", count);
    page.figures.push_back(draw_study(*r, page.folder, prefix));
  }
  const bool all_diameters = std::all_of(
      page.results.begin(), page.results.end(),
      [](const auto& r) { return std::isfinite(rms_relative_error(r->comparison.rms)); });
  if (page.results.size() > 1 && all_diameters)
    page.staircase = draw_staircase(page.results, page.folder);
  page.version = POWDERLINK_VERSION;
  page.facts = provenance(page.version, inputs);
  write_file(output, html(page));

  for (const auto& r : page.results) {
    fmt::print(
        "{}: {}, {}{}{}\n", r->study.name, to_string(r->comparison.verdict),
        rms_sentence(r->comparison.rms),
        r->dem ? fmt::format(", with LIGGGHTS {:.2f} %", 100.0 * r->dem->rms_relative_error) : "",
        r->diagnosis ? "; " + to_string(r->diagnosis->verdict) : "");
  }
  fmt::print("report: {}\nfigures: {}\n", output.string(), page.folder.string());
}

}  // namespace

void add_report_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "report", "one HTML page on studies: fit, missing effects, error before and after, figures");
  auto o = std::make_shared<Options>();
  c->add_option("studies", o->studies, "study files (TOML), in the order in which effects came")
      ->required();
  c->add_option("-o,--output", o->output, "file of the page; NAME_figures/ comes beside it")
      ->required();
  c->add_option("--dem", o->dem,
                "JSON of 'compare --backend dem' for one of the studies; may be given for each")
      ->take_all();
  c->add_flag("--diagnose-first", o->first_only,
              "diagnose the first study only, compare the others: "
              "a diagnosis on top of an added effect takes some seconds more");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
