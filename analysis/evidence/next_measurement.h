// SPDX-License-Identifier: GPL-3.0-or-later
/// \file next_measurement.h
/// The measurement that would separate the leading explanations best.
///
///   separation(v) = |ln(d_a/d_b)| / sqrt(sigma^2 + s_a^2 + s_b^2)
///
/// Symbols: d_a, d_b predictions; s their uncertainty from the fitted parameters (first order);
/// sigma noise of one drop. Velocities from half the slowest to twice the fastest row.
/// Tests: tests/analysis/evidence/next_measurement_test.cpp, tests/analysis/evidence/diagnosis_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/candidate.h"

namespace powderlink::analysis {

/// d_c over v with one-sigma bands, for figures [m/s, um].
struct PredictedCurve {
  std::string name;
  std::vector<double> velocity_m_s, diameter_um, low_um, high_um;
};

/// \param velocity_m_s  where; contact times are interpolated from the rows
PredictedCurve predicted_curve(const Study& study, const Candidate& candidate,
                               const std::vector<double>& velocity_m_s);

/// From half the slowest to twice the fastest row.
std::vector<double> velocities_around(const Study& study);

struct NextMeasurement {
  std::string text;
  double velocity_m_s = 0.0;  ///< 0: no velocity separates them
  double separation_sigma = 0.0;
  std::vector<PredictedCurve> curves;
};

/// \param leading  at least one, best first
NextMeasurement next_measurement(const Study& study, const Observations& observations,
                                 const std::vector<const Candidate*>& leading);

}  // namespace powderlink::analysis
