// SPDX-License-Identifier: GPL-3.0-or-later
/// \file grain_drops.h
/// A table of drops that names tables of grains before and after each: rows of retained shares for a
/// study (measurements.h). Paths are relative to the table. Classes as in retention_classes.h; without
/// an area ratio it is that of the fit (retention_analysis.h).
/// Tests: tests/analysis/kat/grain_drops_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/study/measurements.h"

namespace powderlink::analysis {

bool is_grain_drops(const CsvTable& table);

/// Needed ones first.
const std::vector<std::string>& grain_drop_columns();

/// \param unknown  receives the names of columns that are not used
/// \param notes    receives what the tables of grains leave in doubt
std::vector<KatRow> grain_drop_rows(const CsvTable& table, std::vector<std::string>& unknown,
                                    std::vector<std::string>& notes);

}  // namespace powderlink::analysis
