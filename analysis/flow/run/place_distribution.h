// SPDX-License-Identifier: GPL-3.0-or-later
/// \file place_distribution.h
/// Percentiles of a coordinate of many particles in bounded memory: classes of a fixed width that
/// are added where values come, linear within a class. A percentile is within one class of the
/// exact one; the class is chosen far below a particle's radius.
/// Tests: tests/analysis/flow/flow_statistics_test.cpp
#pragma once

#include <cstdint>
#include <vector>

namespace powderlink::analysis {

class PlaceDistribution {
 public:
  explicit PlaceDistribution(double class_width_m) : width_(class_width_m) {}

  void add(double value_m);
  std::uint64_t count() const { return count_; }
  /// Value below which the fraction 0 ... 1 of all lies; NaN without values.
  double quantile(double fraction) const;
  /// Length of the central interval that holds the fraction: from quantile (1 - f)/2 to (1 + f)/2.
  double central_width(double fraction) const;

 private:
  double width_;
  std::int64_t first_ = 0;  ///< number of the first class; class k holds [k, k + 1) width
  std::vector<std::uint32_t> classes_;
  std::uint64_t count_ = 0;
};

}  // namespace powderlink::analysis
