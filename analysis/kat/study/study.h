// SPDX-License-Identifier: GPL-3.0-or-later
/// \file study.h
/// A study: who sticks to what, which effects are switched on, and the drops to explain. TOML:
///
///   [study]      name, experiment = "kat_critical_diameter" or "kat_retention",
///                measurements = "file.csv" or a list of them (relative to the study file)
///   [particle]   material = NAME, or density_kg_m3, youngs_modulus_Pa, poissons_ratio
///   [substrate]  the same
///   [model]      effects = [NAME...]                    names of `powderlink effects`
///   [effect.NAME]  parameters of that effect            a number fixes one, [low, high] leaves it
///                to the fit; absent ones have their typical values
///   [fit]        adhesive_energy_J_m2 = [low, high]     bounds of a fit; a single number fixes it
///                model_discrepancy = 0.015              what the form of a prediction may be off
///   [kat]        all optional: velocities_m_s = [...] (without a measurement file), wall =
///                "primitive"|"mesh", frame = "plate"|"moving", time_step_rayleigh = 0.1
///                (0.02 with a rate-dependent effect), restitution = 1.0, particles = 64,
///                resolution = 0.002, diameter_range_um = [low, high]
///
/// Unknown keys, unknown names and impossible values are InvalidInput with file, line and key.
/// Tests: tests/analysis/kat/study_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/kat/reduced/reduced_model.h"
#include "analysis/kat/study/measurements.h"
#include "physics/contact/material.h"

namespace powderlink::analysis {

/// Bounds of a parameter that a study leaves free.
struct FreeRange {
  std::size_t parameter = 0;  ///< position in the registry's order
  double lower = 0.0, upper = 0.0;
};

struct EffectChoice {
  std::string name;
  std::vector<double> parameters;  ///< all of them, in the registry's order
  std::vector<FreeRange> free{};   ///< those to fit; `parameters` has their start
};

struct KatOptions {
  bool mesh_wall = false;
  bool moving_frame = false;
  double time_step_rayleigh = 0.1;  ///< of the smallest particle, (0, 0.5]; 0.02 if rate dependent
  double restitution = 1.0;         ///< of the Hertz contact
  int particles = 64;               ///< per run
  double resolution = 0.002;        ///< relative width of the final bracket of d_c
  std::optional<std::pair<double, double>> diameter_range_um{};
};

/// Default of time_step_rayleigh with a rate-dependent effect, whose edge is first order in time: d_c
/// would be 1 % off at 0.1.
inline constexpr double kRateDependentTimeStep = 0.02;

struct EnergyRange {
  double lower_J_m2 = 0.0;
  double upper_J_m2 = 0.0;
  bool fixed() const { return lower_J_m2 == upper_J_m2; }
};

struct Study {
  std::filesystem::path file;
  std::string name;
  std::string experiment;
  physics::Material particle;
  physics::Material substrate;
  std::vector<EffectChoice> effects;
  EnergyRange adhesive_energy;
  KatOptions kat;
  std::vector<std::filesystem::path> measurements;  ///< files of the rows
  double model_discrepancy = 0.015;  ///< of a prediction's form, relative, beside the noise
  std::vector<KatRow> rows;
  std::vector<std::string> notes;  ///< for stderr: kept columns, unusual values
};

Study read_study(const std::filesystem::path& file);

/// The reduced model's set-up for one row: effects made, a measured contact time taken as tau.
KatSetup row_setup(const Study& study, const KatRow& row, double work_of_adhesion_J_m2);

/// The same with other effects than the study's.
KatSetup row_setup(const Study& study, const std::vector<EffectChoice>& effects, const KatRow& row,
                   double work_of_adhesion_J_m2);

/// Effects with the parameters that hold for this row.
std::vector<EffectChoice> row_effects(std::vector<EffectChoice> effects, const KatRow& row);

/// True when the measurements themselves give this parameter of the effect, row by row.
bool given_by_rows(const Study& study, const std::string& effect, std::size_t parameter);

}  // namespace powderlink::analysis
