// SPDX-License-Identifier: GPL-3.0-or-later
/// \file pressure_profile.h
/// Pressure along z from OpenFOAM's probes, in Pa, averaged over time, and its slope.
///   p_i = rho <p_kin>_t,    <>_t weighted with the time since the row before
///   slope = -d p/d z by least squares over the probes in [from_z, to_z]: positive for a drop
/// Read are postProcessing/NAME/<start>/p; a later start replaces what earlier ones wrote after it
/// (restarts). Probes outside the mesh, for which OpenFOAM writes -1e300 (smaller than any
/// pressure), are left out.
/// Tests: tests/analysis/flow_case_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

struct ProbeMean {
  double z_m = 0.0;
  double pressure_Pa = 0.0;
};

struct PressureProfile {
  std::string name;  ///< of the set of probes
  std::vector<ProbeMean> probes;
  std::size_t rows = 0;  ///< times averaged over
};

struct PressureSlope {
  double intercept_Pa = 0.0, slope_Pa_m = 0.0, r_squared = 0.0;  ///< p = intercept - slope z
  std::size_t probes = 0;
};

/// Density of the gas: the option, else `rho` of constant/transportProperties; empty when neither.
std::optional<double> gas_density_kg_m3(const std::filesystem::path& case_folder,
                                        std::optional<double> given);

/// Names of the probe sets that recorded p.
std::vector<std::string> pressure_probe_sets(const std::filesystem::path& case_folder);

/// Throws for damaged files. Rows before from_s do not count.
PressureProfile read_pressure(const std::filesystem::path& case_folder, const std::string& set,
                              double density_kg_m3, double from_s);

/// Empty with fewer than two different places in the window.
std::optional<PressureSlope> fit_slope(const PressureProfile& profile, double from_z_m,
                                       double to_z_m);

}  // namespace powderlink::analysis
