// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_units.h
/// Units as tables write them: in a row of their own under the header, or in brackets.
/// Tests: tests/base/csv_table_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink {

/// "[µm]" -> "µm", "um" -> "um".
std::string unit_in_brackets(const std::string& cell);

/// One spelling of each unit: "µm^2", "um²" -> "um2"; "m s^-1", "m*s-1" -> "m/s"; small letters for
/// words such as "Microns" -> "um".
std::string plain_unit(const std::string& unit);

/// Whether every cell is empty, a dash, or a unit, and at least one is a unit.
bool is_row_of_units(const std::vector<std::string>& cells);

}  // namespace powderlink
