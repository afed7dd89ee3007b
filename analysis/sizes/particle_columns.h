// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_columns.h
/// Which column of a table of grains is what, and in which unit: that of the name, `area_um2` or
/// `Area (mm^2)`, else that of a row of units, else pixels. Known are nm, um, mm, cm and pixels.
/// Tests: tests/analysis/sizes/particle_table_test.cpp, tests/analysis/sizes/table_doubts_test.cpp
#pragma once

#include <optional>
#include <string>

#include "base/csv/csv_table.h"

namespace powderlink::analysis {

struct ParticleColumns {
  std::size_t area = 0;
  std::optional<std::size_t> perimeter, circularity, aspect_ratio, roundness, feret, pixel_size;
  std::optional<double> unit_um;  ///< of lengths; empty: pixels
  bool imagej = false;            ///< named as ImageJ names them: Area, and Perim. or Circ.
};

/// Throws unless there are an area and a perimeter or circularity, all lengths in one unit; knows
/// ImageJ's table Summary, which has a row per picture.
ParticleColumns find_particle_columns(const CsvTable& table);

/// The number after `pixel_size_um:` in a comment line, if there is one.
std::optional<double> stated_pixel_size_um(const CsvTable& table);

/// Nothing where the column is absent, or the cell empty or ImageJ's NaN of shapes without axes.
std::optional<double> number_or_nothing(const CsvTable& table, const CsvTable::Row& row,
                                        const std::optional<std::size_t>& column);

}  // namespace powderlink::analysis
