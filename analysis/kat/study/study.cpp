// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/study_material.h"
#include "base/toml/strict_table.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

constexpr const char* kRetention = "kat_retention";
const std::vector<std::string> kExperiments = {"kat_critical_diameter", kRetention};
constexpr const char* kPulseEffect = "finite_stop_pulse";
constexpr int kFewestParticles = 8;  // with fewer a bracket hardly shrinks from run to run
constexpr int kMostParticles = 100000;

FreeRange read_range(const StrictTable& table, const physics::EffectParameter& p,
                     std::size_t position) {
  const std::vector<double> values = *table.numbers(p.name);
  if (values.size() != 2 ||
      !(values[0] >= p.lower && values[0] < values[1] && values[1] <= p.upper)) {
    throw InvalidInput(
        table.place(p.name), fmt::format("[{}]", fmt::join(values, ", ")),
        fmt::format("[low, high] within {:g} to {:g}, or one number", p.lower, p.upper),
        "correct the bounds");
  }
  return {position, values[0], values[1]};
}

EffectChoice read_effect(const StrictTable& model, const StrictTable& tables,
                         const std::string& name) {
  const physics::EffectInfo* info = nullptr;
  try {
    info = physics::find_effect(name).info;
  } catch (const InvalidInput&) {
    std::vector<std::string> names;
    for (const auto& e : physics::effect_registry()) names.push_back(e.info->name);
    throw InvalidInput(model.place("effects"), "'" + name + "'",
                       fmt::format("{}", fmt::join(names, ", ")), "see 'powderlink effects'");
  }
  std::vector<std::string> keys;
  for (const auto& p : info->parameters) keys.push_back(p.name);
  const StrictTable table = tables.table(name, keys);
  EffectChoice choice{name, {}};
  for (const auto& p : info->parameters) {
    if (table.is_list(p.name)) {
      const FreeRange range = read_range(table, p, choice.parameters.size());
      choice.free.push_back(range);
      choice.parameters.push_back(std::clamp(p.typical, range.lower, range.upper));
      continue;
    }
    const double value = table.number(p.name).value_or(p.typical);
    if (!(value >= p.lower && value <= p.upper) && value != p.off) {
      throw InvalidInput(table.place(p.name), fmt::format("{:g}", value),
                         fmt::format("{:g} to {:g}", p.lower, p.upper), "see 'powderlink effects'");
    }
    choice.parameters.push_back(value);
  }
  return choice;
}

std::vector<EffectChoice> read_effects(const StrictTable& root) {
  const StrictTable model = root.table("model", {"effects"});
  const std::vector<std::string> names =
      model.texts("effects").value_or(std::vector<std::string>{});
  const StrictTable tables = root.table("effect", {});
  std::vector<EffectChoice> effects;
  for (const std::string& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1) {
      throw InvalidInput(model.place("effects"), "'" + name + "' twice", "every effect once",
                         "remove one of them");
    }
    effects.push_back(read_effect(model, tables, name));
  }
  for (const std::string& key : tables.keys()) {
    if (std::find(names.begin(), names.end(), key) == names.end()) {
      throw InvalidInput(tables.place(key), "parameters of an effect that is not switched on",
                         names.empty() ? "no table, as effects is empty"
                                       : fmt::format("{}", fmt::join(names, ", ")),
                         "add \"" + key + "\" to [model] effects, or remove the table");
    }
  }
  return effects;
}

EnergyRange read_energy(const StrictTable& root, bool needed) {
  const StrictTable fit = root.table("fit", {"adhesive_energy_J_m2", "model_discrepancy"});
  const std::string key = "adhesive_energy_J_m2";
  const std::string allowed = "bounds [low, high] with 0 < low < high, or one number > 0";
  if (!fit.has(key)) {
    if (!needed) return {};
    throw InvalidInput(fit.place(key), "nothing", allowed,
                       "give bounds such as [0.001, 1000.0] to fit it, or a number to fix it");
  }
  if (!fit.is_list(key)) {
    const double value = require_adhesive_energy_J_m2(*fit.number(key), fit.place(key));
    return {value, value};
  }
  const std::vector<double> values = *fit.numbers(key);
  if (values.size() != 2 || !(values[0] > 0.0 && values[0] < values[1])) {
    throw InvalidInput(fit.place(key), fmt::format("[{}]", fmt::join(values, ", ")), allowed,
                       "correct the bounds");
  }
  return {values[0], values[1]};
}

double read_discrepancy(const StrictTable& root, double by_default) {
  constexpr double largest = 0.5;
  const StrictTable fit = root.table("fit", {});
  const double value = fit.number("model_discrepancy").value_or(by_default);
  if (!(value >= 0.0 && value <= largest)) {
    throw InvalidInput(fit.place("model_discrepancy"), fmt::format("{:g}", value),
                       "0 to 0.5, relative", "use 0.015: 1.5 % for the form of a model");
  }
  return value;
}

KatOptions read_kat(const StrictTable& kat, bool rate_dependent) {
  KatOptions o;
  if (rate_dependent) o.time_step_rayleigh = kRateDependentTimeStep;
  const auto choice = [&](const char* key, const char* first, const char* second) {
    const std::string word = kat.text(key).value_or(first);
    if (word != first && word != second) {
      throw InvalidInput(kat.place(key), "'" + word + "'",
                         fmt::format("\"{}\" or \"{}\"", first, second), "use one of them");
    }
    return word == second;
  };
  const auto within = [&](const char* key, double value, bool ok, const char* allowed,
                          const char* to_do) {
    if (!ok) throw InvalidInput(kat.place(key), fmt::format("{:g}", value), allowed, to_do);
    return value;
  };
  o.mesh_wall = choice("wall", "primitive", "mesh");
  o.moving_frame = choice("frame", "plate", "moving");
  if (o.moving_frame && !o.mesh_wall) {
    throw InvalidInput(kat.place("frame"), "\"moving\" with a primitive wall",
                       "\"moving\" with wall = \"mesh\"",
                       "add wall = \"mesh\", or use frame = \"plate\"");
  }
  const double dt = kat.number("time_step_rayleigh").value_or(o.time_step_rayleigh);
  o.time_step_rayleigh =
      within("time_step_rayleigh", dt, dt > 0.0 && dt <= physics::kLargestRayleighFraction,
             "> 0 and <= 0.5 Rayleigh times", "use 0.1");
  const double e = kat.number("restitution").value_or(o.restitution);
  o.restitution =
      within("restitution", e, e > 0.0 && e <= 1.0, "> 0 and <= 1", "use 1 for no damping");
  const long n = kat.integer("particles").value_or(o.particles);
  o.particles = static_cast<int>(within("particles", static_cast<double>(n),
                                        n >= kFewestParticles && n <= kMostParticles, "8 to 100000",
                                        "use 64"));
  const double r = kat.number("resolution").value_or(o.resolution);
  o.resolution = within("resolution", r, r >= 1e-6 && r <= 0.5, "1e-6 to 0.5", "use 0.002");
  if (const auto range = kat.numbers("diameter_range_um")) {
    const std::string place = kat.place("diameter_range_um");
    if (range->size() != 2 || !((*range)[0] < (*range)[1])) {
      throw InvalidInput(place, fmt::format("[{}]", fmt::join(*range, ", ")),
                         "[low, high] with low < high",
                         "correct the range, or remove it to have it chosen");
    }
    o.diameter_range_um = {require_diameter_um((*range)[0], place),
                           require_diameter_um((*range)[1], place)};
  }
  return o;
}

void read_rows(const StrictTable& root, const StrictTable& study_table, const StrictTable& kat,
               Study& study) {
  std::vector<std::string> tables;
  if (study_table.is_list("measurements"))
    tables = *study_table.texts("measurements");
  else if (const auto one = study_table.text("measurements"))
    tables = {*one};
  const bool csv = !tables.empty();
  const auto velocities = kat.numbers("velocities_m_s");
  if (csv && velocities) {
    throw InvalidInput(kat.place("velocities_m_s"), "a measurement file and velocities",
                       "one of them", "remove velocities_m_s, or the key measurements of [study]");
  }
  if (csv) {
    for (const std::string& table : tables) {
      study.measurements.push_back(study.file.parent_path() / table);
      Measurements m = read_measurements(study.measurements.back());
      for (KatRow& row : m.rows) row.table = study.measurements.size() - 1;
      study.rows.insert(study.rows.end(), m.rows.begin(), m.rows.end());
      study.notes.insert(study.notes.end(), m.notes.begin(), m.notes.end());
      if (!m.unknown_columns.empty()) {
        study.notes.push_back(fmt::format("{}: columns that are not used: {}", m.table.file,
                                          fmt::join(m.unknown_columns, ", ")));
      }
    }
    for (const KatRow& row : study.rows) {
      if (row.adhesive_energy_J_m2.has_value() !=
              study.rows.front().adhesive_energy_J_m2.has_value() ||
          row.contact_time_us.has_value() != study.rows.front().contact_time_us.has_value()) {
        throw InvalidInput(study_table.place("measurements"),
                           "tables of which some have contact_time_us or adhesive_energy_J_m2",
                           "these columns in all tables or in none", "add or remove the columns");
      }
    }
    return;
  }
  if (!velocities || velocities->empty()) {
    throw InvalidInput(root.place("study") + " measurements", "nothing",
                       "measurements = \"file.csv\" in [study], or velocities_m_s = [...] in [kat]",
                       "say which drops to compute");
  }
  for (const double v : *velocities) {
    study.rows.push_back({require_velocity_m_s(v, kat.place("velocities_m_s"))});
  }
}

/// What the study says that it measures, against what its tables hold.
void check_experiment(const StrictTable& about, const Study& study) {
  if (study.measurements.empty()) return;
  const auto counts = std::find_if(study.rows.begin(), study.rows.end(), [](const KatRow& row) {
    return row.kind() == KatRow::Kind::retained_share;
  });
  const bool retention = study.experiment == kRetention;
  if (retention == (counts != study.rows.end())) return;
  throw InvalidInput(
      about.place("experiment"), "\"" + study.experiment + "\"",
      retention ? "a table with count_before and count_after, or with before_files and after_files"
                : fmt::format("no counts of grains, as {} has",
                              study.measurements[counts->table].filename().string()),
      retention
          ? "name such a table, or write \"kat_critical_diameter\""
          : fmt::format("write \"{}\": its tables may hold critical diameters too", kRetention));
}

}  // namespace

Study read_study(const std::filesystem::path& file) {
  const toml::table document =
      read_toml(file, "study file", "check the path; kat_cases/ has examples");
  const std::string shown = file.string();
  const StrictTable root(&document, shown, "",
                         {"study", "particle", "substrate", "model", "effect", "fit", "kat"});
  Study study;
  study.file = file;
  const StrictTable about = root.table("study", {"name", "experiment", "measurements"});
  study.name = about.text("name").value_or(file.stem().string());
  study.experiment = about.text("experiment").value_or("");
  if (std::find(kExperiments.begin(), kExperiments.end(), study.experiment) == kExperiments.end()) {
    throw InvalidInput(about.place("experiment"),
                       study.experiment.empty() ? "nothing" : "'" + study.experiment + "'",
                       fmt::format("\"{}\"", fmt::join(kExperiments, "\" or \"")),
                       "correct the experiment");
  }
  study.particle = read_material(root.table("particle", material_keys()));
  study.substrate = read_material(root.table("substrate", material_keys()));
  study.effects = read_effects(root);
  const StrictTable kat =
      root.table("kat", {"velocities_m_s", "wall", "frame", "time_step_rayleigh", "restitution",
                         "particles", "resolution", "diameter_range_um"});
  const bool rate_dependent =
      std::any_of(study.effects.begin(), study.effects.end(), [](const EffectChoice& e) {
        return physics::make_effect(e.name, e.parameters)->rate_dependent();
      });
  study.kat = read_kat(kat, rate_dependent);
  read_rows(root, about, kat, study);
  check_experiment(about, study);

  const bool energy_in_rows = study.rows.front().adhesive_energy_J_m2.has_value();
  study.adhesive_energy = read_energy(root, !energy_in_rows);
  study.model_discrepancy = read_discrepancy(root, study.model_discrepancy);
  if (energy_in_rows && root.table("fit", {}).has("adhesive_energy_J_m2")) {
    throw InvalidInput(root.table("fit", {}).place("adhesive_energy_J_m2"),
                       "a value here and a column adhesive_energy_J_m2 in the measurements",
                       "one of them", "remove the key, or the column");
  }
  const bool pulse = std::any_of(study.effects.begin(), study.effects.end(),
                                 [](const EffectChoice& e) { return e.name == kPulseEffect; });
  if (pulse && study.rows.front().contact_time_us) {
    study.notes.push_back(shown +
                          ": contact_time_us of the measurements is used as tau_s of the stop");
  }
  double highest = study.adhesive_energy.fixed() ? study.adhesive_energy.upper_J_m2 : 0.0;
  for (const KatRow& row : study.rows)
    highest = std::max(highest, row.adhesive_energy_J_m2.value_or(0.0));
  const std::string warning = adhesive_energy_warning(highest, shown);
  if (!warning.empty()) study.notes.push_back(warning);
  return study;
}

bool given_by_rows(const Study& study, const std::string& effect, std::size_t parameter) {
  return effect == kPulseEffect && parameter == 0 && study.rows.front().contact_time_us.has_value();
}

std::vector<EffectChoice> row_effects(std::vector<EffectChoice> effects, const KatRow& row) {
  for (EffectChoice& e : effects) {
    if (e.name == kPulseEffect && row.contact_time_us)
      e.parameters[0] = *row.contact_time_us * 1e-6;
  }
  return effects;
}

KatSetup row_setup(const Study& study, const std::vector<EffectChoice>& effects, const KatRow& row,
                   double work_of_adhesion_J_m2) {
  KatSetup setup;
  setup.particle = study.particle;
  setup.substrate = study.substrate;
  setup.work_of_adhesion_J_m2 = work_of_adhesion_J_m2;
  setup.restitution = study.kat.restitution;
  for (const EffectChoice& e : row_effects(effects, row)) {
    setup.effects.push_back(physics::make_effect(e.name, e.parameters));
  }
  return setup;
}

KatSetup row_setup(const Study& study, const KatRow& row, double work_of_adhesion_J_m2) {
  return row_setup(study, study.effects, row, work_of_adhesion_J_m2);
}

}  // namespace powderlink::analysis
