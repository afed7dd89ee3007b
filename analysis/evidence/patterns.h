// SPDX-License-Identifier: GPL-3.0-or-later
/// \file patterns.h
/// Shapes that no effect of the catalogue has, as foils: when one of them explains the residuals of
/// the baseline better than every effect does, the catalogue is not enough.
///
///   step   y = a + b [v > v_s]                         v_s between two rows
///   wave   y = a + b sin(w x) + c cos(w x)             x = v or ln v, from one to (n - 1)/2 periods
///
/// Symbols: y = ln(d_measured/d_baseline); n rows. Weighted least squares, scanned over v_s and w;
/// k counts a, b, c and what is scanned. Tests: tests/analysis/evidence/evidence_trends_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink::analysis {

struct Pattern {
  std::string name;  ///< "step" or "wave"
  std::string text;  ///< "a step of +23 % between 2.1 and 2.6 m/s"
  double chi2 = 0.0;
  int parameters = 0;
  std::vector<double> residuals{};  ///< in sigmas
};

/// \param x          impact velocities
/// \param residuals  of the baseline in sigmas: (model/measured - 1)/sigma
/// \param sigma      relative
std::vector<Pattern> foreign_patterns(const std::vector<double>& x,
                                      const std::vector<double>& residuals,
                                      const std::vector<double>& sigma);

}  // namespace powderlink::analysis
