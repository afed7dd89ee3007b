// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_fit.h
/// Largest likelihood of a retained fraction: as an ideal truncation (w = 0), with a width, or at a
/// d_c that is asked for. The likelihood of a narrow width has a step at every grain, so widths are
/// tried on a ladder, diameters on a grid as fine as the width, and only then refined (Brent).
/// Which of both: the width is kept when the ideal truncation is excluded at 5 %, that is when
/// 2 ln(L_width/L_ideal) > 5.99 (-2 ln 0.05: ln L of a truncation has a step at every grain, and twice
/// its fall from the top is then distributed as chi^2 with two degrees of freedom).
/// Tests: tests/analysis/kat/retention_likelihood_test.cpp
#pragma once

#include <vector>

#include "analysis/kat/experiment/retention_likelihood.h"

namespace powderlink::analysis {

struct RetentionFit {
  double log_critical = 0.0;  ///< ln(d_c/um), 50 % point
  double width = 0.0;         ///< 0: ideal truncation
  double log_likelihood = 0.0;
};

/// Where to look.
struct RetentionSearch {
  double log_low = 0.0, log_high = 0.0;
  std::vector<double> widths;  ///< rising, without 0
};

/// The whole sample, all widths from a hundredth to the whole range of sizes.
RetentionSearch whole_search(const GrainSample& sample);
/// Around a fit, as wide as its repetition may fall.
RetentionSearch search_around(const RetentionFit& fit, const GrainSample& sample);

RetentionFit fit_truncation(const RetentionLikelihood& likelihood);
RetentionFit fit_width(const RetentionLikelihood& likelihood, const RetentionSearch& search);
/// d_c is given; the best width, 0 among them.
RetentionFit fit_at(const RetentionLikelihood& likelihood, const RetentionSearch& search,
                    double log_critical);

/// 95 % points of 2 ln(L_max/L).
inline constexpr double kStepThreshold = 5.991;    ///< ln L with a step at every grain
inline constexpr double kSmoothThreshold = 3.841;  ///< ln L smooth in ln d_c

/// 2 ln(L_width/L_ideal), and whether it excludes the ideal truncation.
double width_evidence(const RetentionFit& ideal, const RetentionFit& width);
inline bool ideal_excluded(double evidence) { return evidence > kStepThreshold; }

}  // namespace powderlink::analysis
