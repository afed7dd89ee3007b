// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "analysis/evidence/comparison.h"
#include "analysis/evidence/dem_prediction.h"
#include "analysis/evidence/evidence_json.h"
#include "analysis/evidence/quantity.h"
#include "analysis/kat/dem/drop_run.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"
#include "base/text/units.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string study, json, out, backend = "reduced";
  int jobs = 0;
  double wall_limit_s = 3600.0;
};

std::string bounds_text(const ProfileInterval& i) {
  return fmt::format("{}{:.4g} .. {:.4g}{}", i.open_low ? "<= " : "", i.low, i.high,
                     i.open_high ? " or more" : "");
}

std::string quantity_with_unit(KatRow::Kind kind) {
  const Quantity& q = quantity_of(kind);
  return *q.unit == '\0' ? q.name : fmt::format("{} [{}]", q.name, q.unit + 1);
}

void print(const Comparison& c, const Study& study, const Observations& observations) {
  TextTable points(
      {"v [m/s]", "d [um]", "measured", "sigma", "model", "error", "residual [sigma]", "of"});
  points.flush_left(7);
  for (std::size_t i = 0; i < c.model.size(); ++i) {
    const Observation& o = observations.list[i];
    const bool diameter = o.row.kind() == KatRow::Kind::critical_diameter;
    const double error = o.error(c.model[i]);
    points.add(
        {fmt::format("{:g}", o.row.impact_velocity_m_s),
         o.row.diameter_um ? fmt::format("{:g}", *o.row.diameter_um) : "",
         fmt::format("{:.4g}", o.measured),
         diameter ? fmt::format("{:.1f} %", 100.0 * o.sigma) : fmt::format("{:.2g}", o.sigma),
         fmt::format("{:.4g}", c.model[i]),
         diameter ? fmt::format("{:+.1f} %", 100.0 * error) : fmt::format("{:+.3g}", error),
         fmt::format("{:+.2f}", c.residuals[i]), quantity_with_unit(o.row.kind())});
  }
  TextTable parameters({"parameter", "value", "unit", "68 % interval", "plausible"});
  parameters.flush_left(2);
  std::size_t fitted = 0;
  for (const ParameterEstimate& p : c.fit.parameters) {
    const bool is_fitted = p.role == ParameterEstimate::Role::fitted;
    parameters.add({p.name, fmt::format("{:.4g}", p.value), unit_of(p.name),
                    is_fitted ? bounds_text(c.intervals[fitted]) : "given",
                    p.plausible() ? "yes" : "NO"});
    if (is_fitted) ++fitted;
  }
  fmt::print("{}: {} on {}\n\n{}\n{}\n", study.name, study.particle.name, study.substrate.name,
             points.text(), parameters.text());
  fmt::print("{}, chi^2/dof {:.3g}\nverdict: {}\n", rms_sentence(c.rms), c.chi2_per_dof,
             to_string(c.verdict));
  for (const std::string& sentence : c.words) fmt::print("- {}\n", sentence);
}

void run(const Options& o) {
  const Study study = read_study(o.study);
  for (const std::string& note : study.notes) fmt::print(stderr, "powderlink: {}\n", note);
  if (!o.json.empty()) require_folder_of(o.json);
  const Observations observations = observe(study);
  Comparison c = compare(study, observations);
  if (o.backend == "dem") {
    KatRunOptions run;
    run.runner = {find_liggghts(), o.wall_limit_s};
    run.out = o.out.empty() ? fs::path(o.study).parent_path() / "results" : fs::path(o.out);
    run.jobs =
        o.jobs > 0 ? o.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    run.resolution = study.kat.resolution;
    judge(c, study, observations, dem_predictions(study, c.fit, run));
  }
  if (!o.json.empty()) write_file(o.json, json_of(c, observations, o.backend).dump(1) + "\n");
  print(c, study, observations);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "compare", "fits what a study leaves free and shows where its model fits and fails");
  auto o = std::make_shared<Options>();
  c->add_option("study", o->study, "study file (TOML)")->required();
  c->add_option("--backend", o->backend,
                "reduced: one particle; dem: LIGGGHTS runs with the values fitted by 'reduced'")
      ->check(CLI::IsMember({"reduced", "dem"}))
      ->capture_default_str();
  c->add_option("--json", o->json, "write the comparison to this file too");
  c->add_option("--out", o->out, "folder of the runs (default: results/ beside the study)");
  c->add_option("--jobs,-j", o->jobs, "rows side by side (default: all cores)")
      ->check(CLI::PositiveNumber);
  c->add_option("--wall-limit", o->wall_limit_s, "longest time of one LIGGGHTS run [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
