// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "analysis/program/commands.h"
#include "analysis/program/segmentation_options.h"
#include "analysis/sizes/pictures/powder_inputs.h"
#include "analysis/sizes/pictures/psd_figures.h"
#include "analysis/sizes/pictures/psd_report.h"
#include "base/files/file_patterns.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> files;
  std::string json, out = "psd";
  PsdOptions psd;
  std::optional<double> bar_um, bar_px;
  double density_kg_m3 = 7980.0;
  int classes = 30;
  bool no_figures = false;
};

std::optional<double> scale_from_bar(const Options& o) {
  if (!o.bar_um && !o.bar_px) return std::nullopt;
  if (!o.bar_um || !o.bar_px || !(*o.bar_px > 0.0) || o.psd.pixel_size_um) {
    throw InvalidInput("scale bar",
                       o.psd.pixel_size_um ? "a pixel size and a scale bar"
                                           : "not both its lengths, or one that is not above 0",
                       "--scale-bar-um L with --scale-bar-px N, or --pixel-size-um",
                       "measure the bar in pixels and give both of its lengths");
  }
  return require_pixel_size_um(*o.bar_um / *o.bar_px, "scale bar, um per pixel");
}

void check(const PsdOptions& o) {
  if (o.pixel_size_um) require_pixel_size_um(*o.pixel_size_um, "option --pixel-size-um");
  if (!(o.min_um >= 0.0 && o.max_um > o.min_um)) {
    throw InvalidInput("options --min-diameter-um and --max-diameter-um",
                       fmt::format("{:g} and {:g}", o.min_um, o.max_um),
                       "0 or more, and the largest above the smallest", "correct them");
  }
  check_segmentation_options(o.segmentation);
}

std::string law_text(const char* by, bool cut_off, const std::optional<RosinRammlerFit>& fit) {
  const std::string name = fmt::format("Rosin-Rammler by {}", by);
  const char* const cut = cut_off ? ", cut off" : "";
  if (!fit) return fmt::format("{}{}: these sizes decide no such law\n", name, cut);
  const RosinRammler& law = fit->law;
  if (!fit->fits()) {
    return fmt::format("{}{}: does not fit; the share finer than {:.3g} um is off by {:.1f} %\n",
                       name, cut, fit->miss_um, 100.0 * fit->miss);
  }
  const std::string between =
      cut_off ? fmt::format(" between {:.4g} and {:.4g} um", law.min_um, law.max_um) : "";
  return fmt::format("{}{}: x0 {:.4g} +- {:.2g} um, n {:.4g} +- {:.2g}, R^2 {:.4f}\n", name,
                     between, law.x0_um, fit->x0_sigma_um, law.n, fit->n_sigma, fit->r_squared);
}

std::string text_of(const PsdReport& r) {
  TextTable t({"diameters [um]", "D10", "D50", "D90", "95 % of D50"});
  const auto row = [&](const char* name, const std::array<Quantity95, 3>& q, const char* format) {
    const auto number = [&](double x) { return fmt::format(fmt::runtime(format), x); };
    t.add({name, number(q[0].value), number(q[1].value), number(q[2].value),
           number(q[1].interval.low) + " to " + number(q[1].interval.high)});
  };
  row("by number", r.by_number, "{:.4g}");
  row("by mass", r.by_mass, "{:.4g}");
  row("circularity", r.circularity, "{:.3f}");
  if (r.with_aspect_ratio > 0) row("aspect ratio", r.aspect_ratio, "{:.3f}");
  std::string text = t.text();
  const bool area = r.options.diameter == DiameterKind::area;
  text += fmt::format("{} grains; diameters are {}, {} has D50 {:.4g} um by number\n",
                      r.set.particles.size(), area ? "sqrt(4A/pi)" : "4A/P",
                      area ? "4A/P" : "sqrt(4A/pi)", r.d50_other.value);
  text += law_text("number", false, r.rr_number) + law_text("mass", false, r.rr_mass);
  return text + law_text("number", true, r.cut_number) + law_text("mass", true, r.cut_mass);
}

void run(Options o) {
  if (!o.json.empty()) require_folder_of(o.json);
  check(o.psd);
  if (const auto scale = scale_from_bar(o)) o.psd.pixel_size_um = scale;
  const PsdReport report = analyse_sizes(expand_patterns(o.files), o.psd, show_pictures);
  std::vector<std::pair<std::string, std::string>> files = psd_tables(report);
  files.emplace_back("in.powder", liggghts_powder(report, o.density_kg_m3, o.classes));
  files.emplace_back("sizeDistribution", openfoam_sizes(report));
  for (const auto& overlay : report.overlays) files.push_back(overlay);

  const fs::path out = o.out;
  std::error_code problem;
  fs::create_directories(out, problem);
  if (problem) {
    throw InvalidInput("--out", out.string(), "a folder that may be made", problem.message());
  }
  for (const auto& [name, content] : files) write_file(out / name, content);
  if (!o.json.empty()) write_file(o.json, psd_json(report));
  std::vector<std::string> notes = report.set.notes;
  if (!o.no_figures) {
    for (const std::string& note : draw_psd_figures(report, out)) notes.push_back(note);
  }
  for (const std::string& note : notes) fmt::print(stderr, "powderlink: {}\n", note);
  fmt::print("{}tables{}{} are in {}\n", text_of(report), o.no_figures ? "" : ", figures",
             report.overlays.empty() ? "" : ", overlays", out.string());
}

}  // namespace

void add_psd_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "psd",
      "particle sizes from ImageJ tables or micrographs: quantiles, Rosin-Rammler, input files");
  auto o = std::make_shared<Options>();
  PsdOptions& psd = o->psd;
  c->add_option("files", o->files, "tables (.csv, .txt, .xls) and pictures; patterns may be quoted")
      ->required();
  c->add_option("--pixel-size-um", psd.pixel_size_um,
                "side of a pixel [um]; 1 for tables of an image that had its scale in um; "
                "not needed for TIFFs that say it");
  c->add_option("--scale-bar-um", o->bar_um, "... or what the picture's scale bar says [um]");
  c->add_option("--scale-bar-px", o->bar_px, "... and its length in pixels");
  c->add_option("--json", o->json, "write the numbers to this file too");
  c->add_option("--out", o->out, "folder of tables, figures, overlays and input files")
      ->capture_default_str();
  static const std::map<std::string, DiameterKind> kinds = {{"area", DiameterKind::area},
                                                            {"perimeter", DiameterKind::perimeter}};
  c->add_option("--diameter", psd.diameter, "area: sqrt(4A/pi), perimeter: 4A/P (default: area)")
      ->transform(CLI::CheckedTransformer(kinds));
  c->add_option("--min-diameter-um", psd.min_um, "leave out smaller grains; lower end of the law");
  c->add_option("--max-diameter-um", psd.max_um, "leave out larger grains; upper end of the law");
  c->add_flag("--drop-specks", psd.drop_specks, "leave out what is flagged as dust or noise");
  add_segmentation_options(*c, psd.segmentation);
  c->add_option("--replicates", psd.bootstrap.replicates, "of the bootstrap")
      ->capture_default_str();
  c->add_option("--seed", psd.bootstrap.seed, "of the bootstrap")->capture_default_str();
  c->add_option("--density-kg-m3", o->density_kg_m3, "of the grains, for LIGGGHTS's input")
      ->capture_default_str();
  c->add_option("--classes", o->classes, "of LIGGGHTS's input")->capture_default_str();
  c->add_flag("--no-figures", o->no_figures, "no SVG figures");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
