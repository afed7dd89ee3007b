// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_classes.h
/// Counts before and after in classes of size, for figures and for studies of retained fractions.
///
/// Classes have equal ratios of their limits; one that holds fewer grains before than `fewest` is joined
/// to the next larger, the last to the one before it.
///   fraction of a class = after/(r before); 95 % interval from that of after/(before + after), which is
///   binomial with p = r s/(1 + r s) (Jeffreys)
/// Symbols: r area seen after over that before, s retained fraction. Units: um.
/// Tests: tests/analysis/kat/retention_analysis_test.cpp
#pragma once

#include <vector>

namespace powderlink::analysis {

struct RetentionClass {
  double low_um = 0.0, high_um = 0.0;
  double before = 0.0, after = 0.0;

  double middle_um() const;
  double fraction(double area_ratio) const { return after / (area_ratio * before); }
  /// Ends of the 95 % interval.
  double fraction_low(double area_ratio) const;
  double fraction_high(double area_ratio) const;
};

inline constexpr double kClassWidth = 0.1;  ///< relative
inline constexpr double kFewestBefore = 5.0;

std::vector<RetentionClass> retention_classes(const std::vector<double>& before_um,
                                              const std::vector<double>& after_um,
                                              double relative_width = kClassWidth,
                                              double fewest = kFewestBefore);

}  // namespace powderlink::analysis
