// SPDX-License-Identifier: GPL-3.0-or-later
/// \file measurements.h
/// Measurements of the Kinetic Adhesion Test. What a table holds is told by its columns:
///
///   critical diameters, one row per drop
///     impact_velocity_m_s            needed
///     critical_diameter_um           needed
///     critical_diameter_sigma_um     optional, standard deviation
///   retained shares, one row per drop and size class
///     impact_velocity_m_s, diameter_um, count_before, count_after      needed
///     diameter_low_um, diameter_high_um    optional, limits of the class; else 5 % on either side
///   retained shares from tables of grains, one row per drop; each becomes one row per size class
///     impact_velocity_m_s, before_files, after_files                  needed; patterns, separated by ';'
///     pixel_size_um                  of tables in pixels that do not state it
///     area_ratio                     seen after over before; else from the grains that all stay
///     class_width_percent            of the diameter; else 10
///   residual speeds, one row per grain or mean of grains that left
///     impact_velocity_m_s, diameter_um, residual_velocity_m_s         needed
///     residual_velocity_sigma_m_s          optional; else 5 % of the impact velocity
///   in all of them
///     contact_time_us                optional, measured contact of carrier and anvil
///     adhesive_energy_J_m2           optional, work of adhesion of the interface for this row
/// Columns may be named otherwise (measurement_names.h); forms of tables: csv_table.h.
/// Other columns are named in `unknown_columns` and kept, as numbers where all cells are.
/// Errors: InvalidInput with file, line and column. Tests: tests/analysis/kat/measurements_test.cpp
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/csv/csv_table.h"

namespace powderlink::analysis {

/// One row: measured, or only asked for (then without a diameter).
struct KatRow {
  double impact_velocity_m_s = 0.0;
  std::optional<double> critical_diameter_um{};
  std::optional<double> critical_diameter_sigma_um{};
  std::optional<double> contact_time_us{};
  std::optional<double> adhesive_energy_J_m2{};
  std::optional<double> diameter_um{};  ///< of the grains; absent in a row of critical diameters
  std::optional<double> diameter_low_um{}, diameter_high_um{};
  std::optional<double> count_before{}, count_after{};
  /// Area seen after over that before, where both are samples of their own; else count_after are those
  /// of count_before that stayed.
  std::optional<double> area_ratio{};
  std::optional<double> residual_velocity_m_s{}, residual_velocity_sigma_m_s{};
  std::map<std::string, double> other{};  ///< unknown columns whose cells are all numbers
  std::size_t table = 0;                  ///< position in the study's list of tables

  enum class Kind { critical_diameter, retained_share, residual_speed };
  Kind kind() const {
    if (count_before) return Kind::retained_share;
    return residual_velocity_m_s ? Kind::residual_speed : Kind::critical_diameter;
  }
};

struct Measurements {
  CsvTable table;
  std::vector<KatRow> rows;
  std::vector<std::string> unknown_columns;
  std::vector<std::string>
      notes;  ///< what a reader of the result should know: doubtful units and tables
};

Measurements read_measurements(const std::filesystem::path& file);

}  // namespace powderlink::analysis
