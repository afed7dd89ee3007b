// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "analysis/evidence/added_effects.h"
#include "analysis/evidence/study_text.h"
#include "analysis/evidence/verdict_words.h"
#include "analysis/kat/dem/drop_script.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string study, effect, output, script;
};

/// The drop of the middle row, around its d_c.
std::string script_text(const Study& study, const Candidate& c) {
  constexpr double below = 0.8;
  constexpr double above = 1.25;
  const KatRow& row = study.rows[study.rows.size() / 2];
  DropScript drop;
  drop.title = study.name + " with " + c.name;
  drop.particle = study.particle;
  drop.substrate = study.substrate;
  drop.work_of_adhesion_J_m2 = row.adhesive_energy_J_m2.value_or(c.hypothesis.adhesive_energy_J_m2);
  drop.impact_velocity_m_s = row.impact_velocity_m_s;
  drop.effects = row_effects(c.hypothesis.effects, row);
  drop.options = study.kat;
  drop.options.mesh_wall = drop.options.moving_frame = false;  // one file
  const ReducedModel model(row_setup(study, c.hypothesis.effects, row, drop.work_of_adhesion_J_m2));
  const double diameter = quick_critical_diameter(model, row.impact_velocity_m_s).diameter_m;
  drop.smallest_diameter_m = below * diameter;
  drop.largest_diameter_m = above * diameter;
  return drop_script(drop);
}

std::vector<std::string> split(const std::string& effects) {
  std::vector<std::string> names;
  std::size_t from = 0;
  while (true) {
    const std::size_t to = effects.find('+', from);
    names.push_back(effects.substr(from, to - from));
    if (to == std::string::npos) return names;
    from = to + 1;
  }
}

void run(const Options& o) {
  const Study study = read_study(o.study);
  for (const std::string& note : study.notes) fmt::print(stderr, "powderlink: {}\n", note);
  const std::vector<std::string> names = split(o.effect);
  for (const std::string& name : names) {
    physics::find_effect(name);
    const bool there = std::any_of(study.effects.begin(), study.effects.end(),
                                   [&](const EffectChoice& e) { return e.name == name; });
    if (there || std::count(names.begin(), names.end(), name) > 1) {
      throw InvalidInput("effect to add", "'" + name + "'", "one that the study has not yet",
                         "see [model] effects of " + o.study);
    }
  }
  require_folder_of(o.output);
  if (!o.script.empty()) require_folder_of(o.script);
  std::error_code absent;
  if (fs::equivalent(o.study, o.output, absent)) {
    throw InvalidInput("-o", o.output, "another file than the study itself",
                       "name a new file; the study stays as it is");
  }
  const Observations observations = observe(study);
  const Candidate c = fit_added(study, observations, names);
  write_file(o.output, study_text(study, c, o.output));
  if (!o.script.empty()) write_file(o.script, script_text(study, c));

  fmt::print("{}: {} with {}\n- {}\n- {}: {}\n- reduced model: {}\n", o.output, study.name, c.name,
             parameter_text(c), c.plausible ? "plausible" : "IMPLAUSIBLE", c.why,
             rms_sentence(c.rms));
  fmt::print("\npowderlink compare {} --backend dem  shows the error with LIGGGHTS\n", o.output);
}

}  // namespace

void add_add_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "add", "writes a new study with an effect added and its parameters fitted");
  auto o = std::make_shared<Options>();
  c->add_option("study", o->study, "study file (TOML)")->required();
  c->add_option("effect", o->effect, "name of 'powderlink effects', or two as a+b")->required();
  c->add_option("-o,--output", o->output, "file of the new study")->required();
  c->add_option("--script", o->script,
                "write a LIGGGHTS input script of the middle row with the effect switched on");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
