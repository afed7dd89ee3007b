// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_analysis.h
/// From the grains before and after one drop to the retained fraction and the critical diameter.
///
/// Counts are compared per area: `area_ratio` is the area seen after over that seen before. Given, it is
/// taken; else it is estimated from the grains that are too small to leave, and `nominal_ratio` (of the
/// numbers of files) only serves to notice exchanged tables.
/// Strays, a share of grains that stay whatever their size, are a quarter of a grain unless the
/// likelihood asks for more (at 1 %).
/// Errors: InvalidInput where d_c cannot be seen: nothing left, nothing remained, more after than before.
/// Units: um. Tests: tests/analysis/kat/retention_analysis_test.cpp
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/kat/experiment/retention_interval.h"

namespace powderlink::analysis {

struct RetentionOptions {
  std::optional<double> area_ratio{};
  double nominal_ratio = 1.0;
  double pixel_um = 0.0;  ///< side of a pixel, by which measured diameters scatter; 0: not known
  int bootstrap_turns = 200;
  std::uint32_t seed = 1;
};

/// Standard deviations from the middle to an end of a 95 % interval of a normal distribution.
inline constexpr double kNormal95 = 1.96;

/// A diameter with its 95 % interval [um].
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

struct RetentionAnalysis {
  double before = 0.0, after = 0.0;  ///< numbers of grains
  double area_ratio = 1.0;
  double strays = 0.0;  ///< share
  bool strays_fitted = false;
  RetentionFit ideal, width;
  double evidence = 0.0;  ///< 2 ln(L_width/L_ideal)
  bool smeared = false;
  Estimate critical, truncation, half_point, largest_remaining;
  std::vector<std::string> warnings;

  /// The fit that was decided for.
  const RetentionFit& fit() const { return smeared ? width : ideal; }
  /// Why, in one sentence.
  std::string decision() const;
};

RetentionAnalysis analyse_retention(const std::vector<double>& before_um,
                                    const std::vector<double>& after_um,
                                    const RetentionOptions& options);

/// The fit alone, without intervals.
RetentionAnalysis fit_retention(const std::vector<double>& before_um,
                                const std::vector<double>& after_um,
                                const RetentionOptions& options);

}  // namespace powderlink::analysis
