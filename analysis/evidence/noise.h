// SPDX-License-Identifier: GPL-3.0-or-later
/// \file noise.h
/// How well each row was measured, and how that is known.
///
///   stated      a column of the table
///   counted     grains: binomial or Poisson
///   replicates  rows that repeat a drop, of those that state nothing: s^2 with at least 3 degrees of
///               freedom, to which the assumption adds 2 of its own
///   assumed     5 % of a critical diameter, of the impact velocity for a residual speed; chi^2 of such
///               rows is no test
///
/// A drop is repeated where the velocity is the same within 0.5 % (or the column
/// impact_velocity_sigma_m_s), the contact time within 2 % and Gamma within 0.5 %: d_c then changes by
/// 1 % at most.
/// Tests: tests/analysis/evidence/noise_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/study/study.h"

namespace powderlink::analysis {

enum class NoiseOrigin { stated, counted, replicates, assumed };

inline constexpr double kAssumedRelativeNoise = 0.05;

/// What the rows of one table have in common.
struct TableNoise {
  std::size_t table = 0;  ///< position in the study's list
  KatRow::Kind kind = KatRow::Kind::critical_diameter;
  NoiseOrigin origin = NoiseOrigin::stated;
  double mean = 0.0;                ///< relative for diameters, else of shares or [m/s]
  double degrees_of_freedom = 0.0;  ///< behind an estimate from replicates
  double discrepancy = 0.0;         ///< of the model's form, relative
  std::size_t rows = 0;
  std::string text() const;
};

/// Noise of critical diameters without sigma, from those among them that repeat a drop; assumed when
/// they are too few.
TableNoise noise_of_unstated(const std::vector<KatRow>& rows);

/// All tables in a sentence; with the names of the tables where there are several.
std::string noise_text(const std::vector<TableNoise>& tables, const Study& study);

}  // namespace powderlink::analysis
