// SPDX-License-Identifier: GPL-3.0-or-later
/// \file grain_sample.h
/// Grains seen before and after a drop, in one list sorted by diameter: what the retained fraction is
/// estimated from. A class holds grains of one diameter, or of diameters that need not be told apart.
/// Units: log_diameter is ln(d/um); counts are numbers of grains, not densities.
/// Tests: tests/analysis/kat/retention_likelihood_test.cpp
#pragma once

#include <vector>

namespace powderlink::analysis {

struct GrainClass {
  double log_diameter = 0.0;
  double before = 0.0, after = 0.0;
  double count() const { return before + after; }
};

class GrainSample {
 public:
  GrainSample(const std::vector<double>& before_um, const std::vector<double>& after_um);
  explicit GrainSample(std::vector<GrainClass> sorted_classes);

  const std::vector<GrainClass>& classes() const { return classes_; }
  double before() const { return before_.back(); }
  double after() const { return after_.back(); }
  double count() const { return before() + after(); }
  /// Sums over the first n classes.
  double before_of(std::size_t n) const { return before_[n]; }
  double after_of(std::size_t n) const { return after_[n]; }
  /// Number of classes with a diameter below this one.
  std::size_t below(double log_diameter) const;
  /// ln of the largest diameter seen after the drop; needs after() > 0.
  double largest_after() const;

  /// Fewer classes: neighbours are joined where they are closer than resolution + growth |x - centre|.
  GrainSample joined(double centre, double resolution, double growth) const;

 private:
  void sum_up();

  std::vector<GrainClass> classes_;
  std::vector<double> before_, after_;
};

}  // namespace powderlink::analysis
