// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/kat/experiment/contact_radii.h"
#include "analysis/kat/experiment/drop_study.h"
#include "analysis/kat/experiment/grain_files.h"
#include "analysis/kat/experiment/kat_analysis_figures.h"
#include "analysis/kat/experiment/kat_analysis_output.h"
#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/study_material.h"
#include "analysis/program/commands.h"
#include "analysis/program/segmentation_options.h"
#include "analysis/sizes/pictures/grain_source.h"
#include "base/files/write_file.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  GrainFiles files;
  SegmentationOptions segmentation;
  double pixel_size_um = 0.0;
  std::string particle, substrate, contact_radii, diameter = "area";
  double velocity = 0.0, velocity_sigma = 0.0;
  double contact_time_us = 0.0, contact_time_sigma_us = 0.0;
  double rebound = 0.0, deceleration = 0.0, deceleration_sigma = 0.0;
  double area_ratio = 0.0, fields_before = 0.0, fields_after = 0.0;
  int turns = RetentionOptions{}.bootstrap_turns;
  unsigned seed = RetentionOptions{}.seed;
  std::string json, out, study;
  bool no_figures = false;
};

double require_within(double value, double low, double high, const char* option, const char* unit,
                      const char* to_do) {
  if (value >= low && value <= high) return value;
  throw InvalidInput(option, fmt::format("{:g}{}", value, unit),
                     fmt::format("{:g} to {:g}{}", low, high, unit), to_do);
}

KatDrop read_drop(const CLI::App& c, const Options& o) {
  KatDrop drop;
  drop.particle = material_option(o.particle, "particle");
  drop.substrate = material_option(o.substrate, "substrate");
  if (c.count("--velocity") == 0) {
    throw InvalidInput("kat analyse: impact velocity", "nothing", "--velocity V in m/s",
                       "give the speed at which the plate met the anvil, such as 1.4");
  }
  drop.impact_velocity_m_s = require_velocity_m_s(o.velocity, "--velocity");
  drop.plate_rebound = require_within(o.rebound, 0.0, 1.0, "--plate-rebound", "",
                                      "0 is a plate that stays on the anvil");
  if (c.count("--contact-time-us") > 0) {
    drop.contact_time_s = 1e-6 * require_contact_time_us(o.contact_time_us, "--contact-time-us");
  }
  if (c.count("--deceleration") > 0) {
    drop.deceleration_m_s2 = require_within(o.deceleration, 1.0, 1e9, "--deceleration", " m/s^2",
                                            "give the plate's peak deceleration in m/s^2");
  }
  if (!o.contact_radii.empty()) drop.contact_radii = read_contact_radii(o.contact_radii);
  return drop;
}

RetentionOptions read_retention(const CLI::App& c, const Options& o, const GrainDiameters& grains) {
  RetentionOptions r;
  r.bootstrap_turns = static_cast<int>(require_within(o.turns, 50.0, 1e5, "--bootstrap", " turns",
                                                      "use 200, or 2000 for a smoother interval"));
  r.seed = o.seed;
  r.nominal_ratio = grains.ratio_of_files();
  r.pixel_um = grains.pixel_size_um.value_or(0.0);
  if (c.count("--area-ratio") > 0) r.area_ratio = o.area_ratio;
  if (c.count("--fields-before") > 0) {
    r.area_ratio = require_within(o.fields_after, 1.0, 1e6, "--fields-after", "",
                                  "count the images taken after the drop") /
                   require_within(o.fields_before, 1.0, 1e6, "--fields-before", "",
                                  "count the images taken before the drop");
  }
  if (r.area_ratio) {
    require_within(*r.area_ratio, 1e-3, 1e3, "area after over area before", "",
                   "correct --area-ratio or the numbers of fields");
  }
  return r;
}

void run(const CLI::App& c, const Options& o) {
  if (!o.json.empty()) require_folder_of(o.json);
  KatAnalysisInput input;
  input.drop = read_drop(c, o);
  input.velocity_sigma_m_s = o.velocity_sigma;
  input.contact_time_sigma_s = 1e-6 * o.contact_time_sigma_us;
  input.deceleration_sigma_m_s2 = o.deceleration_sigma;
  GrainFiles files = o.files;
  files.by_perimeter = o.diameter == "perimeter";
  if (c.count("--pixel-size-um") > 0) files.pixel_size_um = o.pixel_size_um;
  check_segmentation_options(o.segmentation);
  std::vector<std::pair<std::string, std::string>> overlays;
  GrainDiameters grains = read_grains(files, [&](const auto& names, const auto& pixel_size_um) {
    GrainSource source = read_grain_source(names, pixel_size_um, o.segmentation, show_pictures);
    overlays = std::move(source.overlays);
    return std::move(source.set);
  });
  for (const std::string& note : grains.notes) fmt::print(stderr, "powderlink: {}\n", note);
  input.retention = read_retention(c, o, grains);
  input.digits_um2 = grains.digits_um2;
  input.before_um = std::move(grains.before_um);
  input.after_um = std::move(grains.after_um);

  const KatAnalysis analysis = analyse_kat(input);
  std::optional<DropStudy> study;
  if (!o.study.empty()) study.emplace(o.study, analysis);  // refused before anything is written
  std::vector<std::string> notes;
  if (!o.out.empty()) {
    std::error_code problem;
    fs::create_directories(o.out, problem);
    if (problem) {
      throw InvalidInput("--out", o.out, "a folder that may be made", problem.message());
    }
    for (const auto& [name, content] : kat_analysis_tables(analysis, input))
      write_file(fs::path(o.out) / name, content);
    for (const auto& [name, content] : overlays) write_file(fs::path(o.out) / name, content);
    if (!o.no_figures) notes = draw_kat_analysis(analysis, o.out);
  }
  if (!o.json.empty()) write_file(o.json, kat_analysis_json(analysis, input));
  if (study) study->write();

  fmt::print("{}", kat_analysis_text(analysis, input));
  if (!o.out.empty())
    fmt::print("\ntables{} are in {}\n", o.no_figures ? "" : " and figures", o.out);
  if (study) fmt::print("\n{} has {} drop(s) now\n", o.study, study->rows());
  for (const std::string& note : notes) fmt::print(stderr, "powderlink: {}\n", note);
  for (const std::string& text : analysis.warnings)
    fmt::print(stderr, "powderlink: warning: {}\n", text);
}

void add_options(CLI::App& c, Options& o) {
  const std::string names = material_option_help();
  c.add_option("--before", o.files.before,
               "tables or pictures of grains before the drop (patterns may be quoted)")
      ->required();
  c.add_option("--after", o.files.after, "the same after the drop")->required();
  c.add_option("--pixel-size-um", o.pixel_size_um,
               "side of a pixel [um], for tables in pixels and pictures that do not say it");
  c.add_option("--velocity", o.velocity, "impact velocity [m/s]");
  c.add_option("--particle", o.particle, names)->required();
  c.add_option("--substrate", o.substrate, names)->required();
  c.add_option("--velocity-sigma", o.velocity_sigma, "its standard deviation [m/s]")
      ->check(CLI::NonNegativeNumber);
  c.add_option("--contact-time-us", o.contact_time_us, "contact of carrier and anvil [us]");
  c.add_option("--contact-time-sigma-us", o.contact_time_sigma_us, "its standard deviation [us]")
      ->check(CLI::NonNegativeNumber);
  c.add_option("--plate-rebound", o.rebound, "speed of the plate after the stop over that before")
      ->capture_default_str();
  c.add_option("--deceleration", o.deceleration, "peak deceleration of the plate [m/s^2]");
  c.add_option("--deceleration-sigma", o.deceleration_sigma, "its standard deviation [m/s^2]")
      ->check(CLI::NonNegativeNumber);
  c.add_option("--contact-radii", o.contact_radii,
               "CSV of grains at rest: contact_radius_um, radius_um, wavelength_nm");
  c.add_option("--diameter", o.diameter, "of a grain, by its area or by area and perimeter")
      ->check(CLI::IsMember({"area", "perimeter"}))
      ->capture_default_str();
  CLI::Option* ratio = c.add_option("--area-ratio", o.area_ratio,
                                    "area seen after over area seen before "
                                    "(default: from the grains that are too small to leave)");
  CLI::Option* before =
      c.add_option("--fields-before", o.fields_before, "images taken before, all of one size")
          ->excludes(ratio);
  CLI::Option* after = c.add_option("--fields-after", o.fields_after, "images taken after");
  before->needs(after);
  after->needs(before);
  c.add_option("--bootstrap", o.turns, "turns of the bootstrap")->capture_default_str();
  c.add_option("--seed", o.seed, "of its random numbers")->capture_default_str();
  c.add_option("--json", o.json, "write the results to this file too");
  c.add_option("--out", o.out, "write tables, figures and overlays of pictures into this folder");
  add_segmentation_options(c, o.segmentation);
  c.add_flag("--no-figures", o.no_figures, "tables only");
  c.add_option("--study", o.study,
               "study file (TOML) to add the drop to, with its table beside it; made if absent");
}

}  // namespace

void add_kat_analyse_command(CLI::App& kat) {
  CLI::App* c = kat.add_subcommand(
      "analyse", "critical diameter and Gamma of one drop from its grains before and after");
  auto o = std::make_shared<Options>();
  add_options(*c, *o);
  c->callback([c, o] { run(*c, *o); });
}

}  // namespace powderlink::analysis
