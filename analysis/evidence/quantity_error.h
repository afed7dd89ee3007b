// SPDX-License-Identifier: GPL-3.0-or-later
/// \file quantity_error.h
/// Root mean square of what a model is off, for each quantity on its own: relative for critical
/// diameters, the difference of retained shares, that of residual speeds [m/s].
///
///   rms = sqrt(mean e^2),  e of Observation::error
///
/// Tests: tests/analysis/evidence/retention_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/observation.h"

namespace powderlink::analysis {

struct QuantityError {
  KatRow::Kind kind = KatRow::Kind::critical_diameter;
  double rms = 0.0;
};

/// \param errors  one per row; one entry for each quantity that was measured
std::vector<QuantityError> rms_errors(const Observations& observations,
                                      const std::vector<double>& errors);

/// What one axis can show: the first quantity of the list, in hundredths.
struct AxisError {
  double hundredths = 0.0;
  const char* unit = "%";  ///< of critical diameters; "points of share" or "cm/s" for the others
};
AxisError axis_error(const std::vector<QuantityError>& errors);

/// That of the critical diameters; NaN without any.
double rms_relative_error(const std::vector<QuantityError>& errors);

/// "7.3 %", "0.031", "0.05 m/s"; several separated by commas.
std::string rms_text(const std::vector<QuantityError>& errors, int decimals = 1);

/// "rms relative error of critical diameters 7.3 %, rms error of retained shares 0.031".
std::string rms_sentence(const std::vector<QuantityError>& errors);

}  // namespace powderlink::analysis
