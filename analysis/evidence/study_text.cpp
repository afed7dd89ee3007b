// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/study_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/kat/study/study_material.h"
#include "base/toml/toml_text.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

std::string effect_text(const Candidate& c, const EffectChoice& choice) {
  std::string text = fmt::format("\n[effect.{}]\n", choice.name);
  const auto& known = physics::find_effect(choice.name).info->parameters;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const ParameterEstimate* p = c.find(known[i].name);
    const bool held = p != nullptr && p->role == ParameterEstimate::Role::held;
    const std::string comment = p == nullptr ? "  # the measurements have it row by row"
                                : held       ? "  # typical: the data do not determine it"
                                : p->role == ParameterEstimate::Role::fitted ? "  # fitted"
                                                                             : "";
    text += fmt::format("{} = {:.6g}{}\n", known[i].name, choice.parameters[i], comment);
  }
  return text;
}

std::string kat_text(const KatOptions& o) {
  std::string text = fmt::format(
      "\n[kat]\nwall = \"{}\"\nframe = \"{}\"\nrestitution = {:.9g}\nparticles = {}\nresolution = "
      "{:.9g}\n",
      o.mesh_wall ? "mesh" : "primitive", o.moving_frame ? "moving" : "plate", o.restitution,
      o.particles, o.resolution);
  // The default depends on the effects: only another choice is kept.
  const double dt = o.time_step_rayleigh;
  if (dt != KatOptions{}.time_step_rayleigh && dt != kRateDependentTimeStep)
    text += fmt::format("time_step_rayleigh = {:.9g}\n", dt);
  if (o.diameter_range_um) {
    text += fmt::format("diameter_range_um = [{:.9g}, {:.9g}]\n", o.diameter_range_um->first,
                        o.diameter_range_um->second);
  }
  return text;
}

}  // namespace

std::string study_text(const Study& study, const Candidate& c, const fs::path& file) {
  std::vector<std::string> names;
  for (const EffectChoice& e : c.hypothesis.effects) names.push_back(quoted(e.name));
  std::string text =
      fmt::format("# {} with {}, written by powderlink add\n[study]\nname = {}\nexperiment = {}\n",
                  quoted(study.name), fmt::join(c.added, ", "),
                  quoted(study.name + "+" + fmt::format("{}", fmt::join(c.added, "+"))),
                  quoted(study.experiment));
  std::vector<std::string> tables;
  for (const fs::path& table : study.measurements) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    tables.push_back(quoted(fs::proximate(table, folder).generic_string()));
  }
  text += tables.size() == 1 ? "measurements = " + tables.front() + "\n"
                             : fmt::format("measurements = [{}]\n", fmt::join(tables, ", "));
  text += material_text("particle", study.particle) + material_text("substrate", study.substrate);
  text += fmt::format("\n[model]\neffects = [{}]\n", fmt::join(names, ", "));
  for (const EffectChoice& e : c.hypothesis.effects) text += effect_text(c, e);
  text += "\n[fit]\n";
  if (!study.rows.front().adhesive_energy_J_m2) {
    text += study.adhesive_energy.fixed()
                ? fmt::format("adhesive_energy_J_m2 = {:.9g}\n", study.adhesive_energy.lower_J_m2)
                : fmt::format("adhesive_energy_J_m2 = [{:.9g}, {:.9g}]  # fitted: {:.6g}\n",
                              study.adhesive_energy.lower_J_m2, study.adhesive_energy.upper_J_m2,
                              c.hypothesis.adhesive_energy_J_m2);
  }
  text += fmt::format("model_discrepancy = {:.9g}\n", study.model_discrepancy);
  return text + kat_text(study.kat);
}

}  // namespace powderlink::analysis
