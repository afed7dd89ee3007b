// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_interval.h
/// 95 % intervals of the critical diameter by bootstrap.
///
/// Every turn keeps the diameters of both samples and draws anew which of them were seen after the
/// drop, with the fitted p(d) (retention_likelihood.h); then everything is estimated again.
///   critical    {d : 2 (ln L_max - ln L(d)) <= q}, ln L(d) with the best width for that d, and q the
///               95 % point of the same quantity over the turns, but not less than theory has: 3.84
///               for a smeared fraction, 5.99 while an ideal truncation is not excluded.
///   truncation  the same with w = 0, q = 5.99: if the truncation were ideal. Exact then: k more
///               grains before and none after have the chance (1 + r)^-k.
///   largest     d_c = largest * d^_c/largest*, 2.5 and 97.5 % points over the turns: where d_c is,
///               seen from the largest remaining grain. It lies below d_c of a truncation and above
///               that of a smeared fraction; this is undone.
/// The scatter of pixels is part of p(d) throughout, and widens what is exact without it; their shift
/// (pixel_scatter.h) is added to the intervals afterwards.
/// Deterministic: the generator (Mersenne twister, Boost.Random) starts from a given seed.
/// Source: A. C. Davison, D. V. Hinkley, Bootstrap Methods and their Application, Cambridge 1997,
/// Sections 4.2.2, 5.2.1 (parametric bootstrap of a likelihood ratio, basic intervals).
/// Tests: tests/analysis/kat/retention_coverage_test.cpp
#pragma once

#include <cstdint>

#include "analysis/kat/experiment/retention_fit.h"

namespace powderlink::analysis {

inline constexpr double kConfidence = 0.95;

struct LogInterval {
  double low = 0.0, high = 0.0;
};

struct RetentionIntervals {
  LogInterval critical, truncation, largest_remaining;  ///< of ln(d_c/um)
  double threshold = 0.0;                               ///< q
};

/// \param fit  of fit_width() to the same likelihood
RetentionIntervals retention_intervals(const RetentionLikelihood& likelihood,
                                       const RetentionFit& fit, int turns, std::uint32_t seed);

}  // namespace powderlink::analysis
