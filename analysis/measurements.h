// SPDX-License-Identifier: GPL-3.0-or-later
/// \file measurements.h
/// Measured critical diameters of the Kinetic Adhesion Test, one row per drop.
///
///   impact_velocity_m_s            needed
///   critical_diameter_um           needed
///   critical_diameter_sigma_um     optional, standard deviation
///   contact_time_us                optional, measured contact of carrier and anvil
///   adhesive_energy_J_m2           optional, work of adhesion of the interface for this row
/// Other columns are named in `unknown_columns` and kept, as numbers where all cells are.
/// Errors: InvalidInput with file, line and column. Tests: tests/analysis/measurements_test.cpp
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/csv_table.h"

namespace powderlink::analysis {

/// One drop: measured, or only asked for (then without a diameter).
struct KatRow {
  double impact_velocity_m_s = 0.0;
  std::optional<double> critical_diameter_um{};
  std::optional<double> critical_diameter_sigma_um{};
  std::optional<double> contact_time_us{};
  std::optional<double> adhesive_energy_J_m2{};
  std::map<std::string, double> other{};  ///< unknown columns whose cells are all numbers
};

struct Measurements {
  CsvTable table;
  std::vector<KatRow> rows;
  std::vector<std::string> unknown_columns;
};

Measurements read_measurements(const std::filesystem::path& file);

}  // namespace powderlink::analysis
