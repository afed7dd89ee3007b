// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_likelihood.h
/// Likelihood of two samples of grains, before and after a drop, under a retained fraction s(d).
///
///   before: Poisson with density n(d);  after: Poisson with density r n(d) s(d)
///   a grain of either sample is one of those after with probability p(d) = r s/(1 + r s)
///   ln L = sum_after ln p(d_i) + sum_before ln(1 - p(d_j))
///   s(d) = e + (1 - e) Phi(ln(d_c/d)/sqrt(w^2 + m^2)),  m = m(d_c)
///
/// Given the diameters of both samples the size distribution n(d) drops out: nothing is assumed of it.
/// The two samples need not show the same grains nor the same area; if they do show the same grains
/// the intervals that follow are wider than need be.
/// Symbols: r area seen after over area seen before [-], given or estimated from the grains that stay;
/// d_c 50 % point; w width of ln d_c from grain to grain, 0 is the ideal truncation; m scatter of one
/// measured ln d by pixels (pixel_scatter.h); e share of strays that stay whatever their size (dust,
/// clumps, misread). Phi normal distribution function.
/// Validity: grains independent of each other, seen with the same chance before and after.
/// Source: R. L. Prentice, R. Pyke, Biometrika 66 (1979) 403 (two samples, conditional likelihood).
/// Tests: tests/analysis/kat/retention_likelihood_test.cpp
#pragma once

#include <optional>
#include <vector>

#include "analysis/kat/experiment/grain_sample.h"

namespace powderlink::analysis {

/// Retained fraction without strays; critical and width in ln d, diameter as ln d.
double retained_fraction(double log_diameter, double log_critical, double width);

class RetentionLikelihood {
 public:
  /// \param sample  not owned, must outlive this object
  /// \param area_ratio  absent: the best one is taken for every pair of parameters
  /// \param pixel_um  side of a pixel, 0: diameters are taken as exact
  RetentionLikelihood(const GrainSample& sample, std::optional<double> area_ratio, double strays,
                      double pixel_um = 0.0);

  /// ln L; an infinite critical diameter is "nothing left".
  double operator()(double log_critical, double width) const;
  /// What is seen of a width: with the scatter of pixels.
  double seen_width(double log_critical, double width) const;
  /// The area ratio that goes with these parameters.
  double area_ratio(double log_critical, double width) const;

  const GrainSample& sample() const { return sample_; }
  double strays() const { return strays_; }
  std::optional<double> fixed_ratio() const { return fixed_ratio_; }
  double pixel_um() const { return pixel_um_; }

 private:
  struct Split;  // classes that all stay, those in between, those that all leave
  Split split(double log_critical, double width) const;
  double log_ratio(const Split& s) const;

  const GrainSample& sample_;
  std::optional<double> fixed_ratio_;
  double strays_, pixel_um_;
  mutable std::vector<double> share_;  // of the classes in between; kept to spare allocations
};

}  // namespace powderlink::analysis
