// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_columns.h
/// Which column of a table of grains is what, and in which unit.
/// Tests: tests/psd/particle_table_test.cpp
#pragma once

#include <optional>
#include <string>

#include "analysis/csv_table.h"

namespace powderlink::analysis {

struct ParticleColumns {
  std::size_t area = 0;
  std::optional<std::size_t> perimeter, circularity, aspect_ratio, roundness, feret, pixel_size;
  bool in_um = false;  ///< else in pixels
};

/// Throws unless there are an area and a perimeter or circularity, all lengths in one unit.
ParticleColumns find_particle_columns(const CsvTable& table);

/// The number after `pixel_size_um:` in a comment line, if there is one.
std::optional<double> stated_pixel_size_um(const CsvTable& table);

}  // namespace powderlink::analysis
