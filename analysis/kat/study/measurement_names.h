// SPDX-License-Identifier: GPL-3.0-or-later
/// \file measurement_names.h
/// Columns of a measurement file under the names that the program knows: "Critical diameter [µm]", and
/// "critical_diameter" over a row of units that says um, are critical_diameter_um. What carries
/// another unit keeps its name, and is refused where the row of units contradicts the name.
/// Tests: tests/analysis/kat/measurements_test.cpp
#pragma once

#include <string>
#include <vector>

#include "base/csv/csv_table.h"

namespace powderlink::analysis {

/// Gives columns of the table the known names that they mean.
void name_columns(CsvTable& table, const std::vector<std::string>& known);

/// "; 'critical diameter [mm]' is in mm, not um": a column that is the missing one but for its unit.
std::string same_in_other_unit(const CsvTable& table, const std::string& missing);

}  // namespace powderlink::analysis
