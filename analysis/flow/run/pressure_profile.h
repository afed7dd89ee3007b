// SPDX-License-Identifier: GPL-3.0-or-later
/// \file pressure_profile.h
/// Pressure along an axis s from OpenFOAM's probes, in Pa, averaged over time, and its slope.
///   p_i = rho <p_kin>_t,    <>_t weighted with the time since the row before
///   slope = -d p/d s downstream, by least squares over the probes in [from, to]: positive for a drop
/// Read are postProcessing/NAME/<start>/p; a later start replaces what earlier ones wrote after it
/// (restarts). Probes outside the mesh, for which OpenFOAM writes -1e300 (smaller than any
/// pressure), are left out.
/// Tests: tests/analysis/flow/flow_case_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow/run/flow_axis.h"

namespace powderlink::analysis {

struct ProbeMean {
  double place_m = 0.0;  ///< on the axis
  double pressure_Pa = 0.0;
};

struct PressureProfile {
  std::string name;  ///< of the set of probes
  std::vector<ProbeMean> probes;
  std::size_t rows = 0;  ///< times averaged over
};

struct PressureSlope {
  double intercept_Pa = 0.0, slope_Pa_m = 0.0, r_squared = 0.0;
  int way = 1;                      ///< of the axis: p = intercept - way slope s
  double from_m = 0.0, to_m = 0.0;  ///< places that were fitted
  std::size_t probes = 0;
};

/// Density of the gas: the option, else `rho` of constant/transportProperties; empty when neither.
std::optional<double> gas_density_kg_m3(const std::filesystem::path& case_folder,
                                        std::optional<double> given);

/// Names of the probe sets that recorded p.
std::vector<std::string> pressure_probe_sets(const std::filesystem::path& case_folder);

/// Where the probes of a set are; empty for a set that is not there, or has not recorded the field.
std::vector<Place> probe_places(const std::filesystem::path& case_folder, const std::string& set,
                                const std::string& field = "p");

/// Throws for damaged files. Rows before from_s do not count.
PressureProfile read_pressure(const std::filesystem::path& case_folder, const std::string& set,
                              double density_kg_m3, double from_s, const FlowAxis& axis = {});

/// Empty with fewer than two different places in the window.
std::optional<PressureSlope> fit_slope(const PressureProfile& profile, double from_m, double to_m,
                                       const FlowAxis& axis = {});

}  // namespace powderlink::analysis
