// SPDX-License-Identifier: GPL-3.0-or-later
/// \file value_range.h
/// Least and largest of the finite values that were added; empty: low > high.
/// Tests: tests/analysis/report/study_result_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

namespace powderlink::analysis {

struct ValueRange {
  double low = INFINITY, high = -INFINITY;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace powderlink::analysis
