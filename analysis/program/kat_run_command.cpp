// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "analysis/evidence/study_fit.h"
#include "analysis/kat/dem/kat_output.h"
#include "analysis/kat/dem/kat_runner.h"
#include "analysis/kat/study/checks.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/process/progress.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kRefined = 0.1;  // of the study's resolution

struct Options {
  std::string study, json, out;
  int jobs = 0;
  double wall_limit_s = 3600.0;
  bool refine = false, keep = false;
};

void run(const Options& o) {
  const auto start = std::chrono::steady_clock::now();
  const Study study = read_study(o.study);
  for (const std::string& note : study.notes) fmt::print(stderr, "powderlink: {}\n", note);

  for (const KatRow& row : study.rows) {
    if (row.kind() == KatRow::Kind::critical_diameter) continue;
    throw InvalidInput(o.study, "rows of retained shares or residual speeds",
                       "critical diameters, or velocities_m_s",
                       "use 'powderlink compare' and 'powderlink diagnose' for it");
  }
  KatRunOptions run;
  run.runner = {find_liggghts(), o.wall_limit_s};
  run.out = o.out.empty() ? fs::path(o.study).parent_path() / "results" : fs::path(o.out);
  run.jobs =
      o.jobs > 0 ? o.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  run.resolution = study.kat.resolution * (o.refine ? kRefined : 1.0);
  run.keep_all_pictures = o.keep;
  std::error_code problem;
  fs::create_directories(run.out, problem);
  if (problem) {
    throw InvalidInput("--out", run.out.string(), "a folder that may be made", problem.message());
  }
  if (!o.json.empty()) require_folder_of(o.json);

  const StudyFit energies = fit_study(study);
  if (energies.fitted) {
    const std::string warning = adhesive_energy_warning(energies.adhesive_energy_J_m2[0], "fit");
    if (!warning.empty()) fmt::print(stderr, "powderlink: {}\n", warning);
  }
  const std::vector<KatPoint> points =
      run_study(energies.study, energies.adhesive_energy_J_m2, run);

  write_file(run.out / "kat.csv", kat_csv(study.name, points));
  write_file(run.out / "particles.csv", particles_csv(study.name, points));
  if (!o.json.empty()) write_file(o.json, kat_json(points));

  std::string effects;
  for (const EffectChoice& e : study.effects) effects += (effects.empty() ? "" : ", ") + e.name;
  fmt::print("{}: {} on {}, effects: {}\nadhesive energy: {}\n\n{}\n", study.name,
             study.particle.name, study.substrate.name, effects.empty() ? "none" : effects,
             energies.origin, kat_table(points));
  double balance = 0.0;
  for (const KatPoint& p : points) balance = std::max(balance, p.dem.largest_balance);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print(
      "energy balance of the worst particle: {:.1e} of its impact energy; {} in all\n"
      "runs, kat.csv and particles.csv are in {}\n",
      balance, short_time(wall), run.out.string());
}

}  // namespace

void add_kat_run_command(CLI::App& kat) {
  CLI::App* c = kat.add_subcommand(
      "run",
      "critical diameters of a study with LIGGGHTS, beside theory, reduced model and measurement");
  auto o = std::make_shared<Options>();
  c->add_option("study", o->study, "study file (TOML)")->required();
  c->add_option("--json", o->json, "write the points to this file too");
  c->add_option("--out", o->out, "folder of the runs (default: results/ beside the study)");
  c->add_option("--jobs,-j", o->jobs, "rows side by side (default: all cores)")
      ->check(CLI::PositiveNumber);
  c->add_option("--wall-limit", o->wall_limit_s, "longest time of one LIGGGHTS run [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  c->add_flag("--refine", o->refine, "bracket ten times narrower than the study's resolution");
  c->add_flag("--keep", o->keep,
              "keep the particle states of every run, not of each row's first one only");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
