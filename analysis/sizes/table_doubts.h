// SPDX-License-Identifier: GPL-3.0-or-later
/// \file table_doubts.h
/// What cannot be in a table of grains, and what is doubtful.
///
///   4 pi A/P^2 <= (d/(d - 1))^2    d [pixels]: a disk whose edge runs through the centres of its
///                                  outer pixels; 1.1 where the pixel is not known
///   4 pi A/P^2 >= 0.01             in most rows; a line of 80 times its width has as little
///   q/(4 A) <= 0.02                in nine of ten rows: half a step q of the printed digits, in d
///
/// Beyond them: InvalidInput with the row, its reason told where a known one fits: another definition of
/// circularity, units that differ, points or commas that group thousands. Single rows are noted.
/// Tests: tests/analysis/sizes/table_doubts_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/sizes/particle.h"
#include "analysis/sizes/particle_columns.h"

namespace powderlink::analysis {

/// A table whose particles are in its own unit.
struct RawTable {
  const CsvTable& table;
  const ParticleColumns& columns;
  const std::vector<Particle>& particles;
  std::optional<double> pixel;  ///< its side in the table's unit
  double unit_um;               ///< of the table
};

/// 4 pi A/P^2, of whatever size.
double isoperimetric_ratio(const Particle& particle);

/// Throws; returns notes.
std::vector<std::string> check_shapes(const RawTable& raw);

/// The step of the printed areas in the table's unit, 0 for counts of pixels. Throws where the digits
/// cannot tell the grains apart, and notes where they are felt.
double check_digits(const RawTable& raw, std::vector<std::string>& notes);

/// Of areas in steps q: a diameter d is known to +-digits/d, half a step in A; sqrt(4A/pi) moves by half as
/// much as 4A/P.
inline double digits_um2(double area_step_um2, bool by_perimeter) {
  return (by_perimeter ? 2.0 : 1.0) * area_step_um2 / boost::math::constants::pi<double>();
}

/// Noise that was measured as grains: low circularity, or a few pixels each. Empty without doubt.
std::string noise_doubt(const std::vector<Particle>& particles, std::optional<double> pixel_size_um,
                        const std::string& where);

/// The middle one of the circularities; 0 without grains.
double median_circularity(const std::vector<Particle>& particles);

}  // namespace powderlink::analysis
