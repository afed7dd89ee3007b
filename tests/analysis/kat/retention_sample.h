// SPDX-License-Identifier: GPL-3.0-or-later
/// \file retention_sample.h
/// Grains before and after a drop with a known d_c: sizes lognormal, ln d_c of every grain normal.
#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace powderlink::analysis {

struct RetentionTruth {
  double critical_um = 46.0, width = 0.0;
  int grains = 600;         ///< before
  double area_ratio = 1.0;  ///< after over before
  double median_um = 42.0, spread = 0.45;
};

struct RetentionSample {
  std::vector<double> before_um, after_um;
};

inline RetentionSample draw_sample(const RetentionTruth& t, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto size = [&] { return t.median_um * std::exp(t.spread * normal(random)); };
  RetentionSample s;
  for (int i = 0; i < t.grains; ++i) s.before_um.push_back(size());
  const int seen = static_cast<int>(std::lround(t.area_ratio * t.grains));
  for (int i = 0; i < seen; ++i) {
    const double d = size();
    if (d < t.critical_um * std::exp(t.width * normal(random))) s.after_um.push_back(d);
  }
  return s;
}

}  // namespace powderlink::analysis
