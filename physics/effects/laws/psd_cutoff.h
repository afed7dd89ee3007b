// SPDX-License-Identifier: GPL-3.0-or-later
/// \file psd_cutoff.h
/// The sample had no grain larger than d_max, so no larger critical diameter can be seen.
///
///   d_observed = (d_c^-q + d_max^-q)^(-1/q);   q -> infinity: min(d_c, d_max)
///
/// Symbols: d_c critical diameter of the contact, d_max largest grain of the sample [um], q sharpness
/// of the cut [-]: a sieve cut is sharp, the coarse end of a natural size distribution thins out.
/// Validity: d_c is read as the largest grain that stayed. Nothing changes in the contact: DEM has
/// no use for it, studies apply it to what LIGGGHTS finds.
/// Source: definition, joined smoothly; sieve cuts and size distributions of the powder.
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(psd_cutoff, PsdCutoff)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_PSD_CUTOFF_H
#define POWDERLINK_PHYSICS_EFFECTS_PSD_CUTOFF_H

#include <cmath>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class PsdCutoff : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{"psd_cutoff",
                              "(measurement) no grain larger than d_max was in the sample",
                              "flat at low v, then -1.2",
                              {{"d_max_um", std::numeric_limits<double>::infinity(), 100.0, 1.0,
                                1000.0, 5.0, 500.0, "powders of this method, 5 to 500 um"},
                               {"cut_sharpness", std::numeric_limits<double>::infinity(), 8.0, 4.0,
                                100.0, 4.0, 100.0, "coarse ends that thin out to sieve cuts"}},
                              "sieve a sample with larger grains: the flat part must rise"};
    return i;
  }

  explicit PsdCutoff(const std::vector<double>& p)
      : largest_m_(p.at(0) * 1e-6), sharpness_(p.at(1)) {
    for (std::size_t i = 0; i < 2; ++i) require_range(info(), i, p[i]);
  }

  bool of_measurement() const override { return true; }
  double observed_diameter_m(double critical_diameter) const override {
    const double smaller = std::fmin(critical_diameter, largest_m_);
    if (!std::isfinite(sharpness_) || !std::isfinite(largest_m_)) return smaller;
    const double ratio = smaller / std::fmax(critical_diameter, largest_m_);
    return smaller * std::pow(1.0 + std::pow(ratio, sharpness_), -1.0 / sharpness_);
  }

 private:
  double largest_m_, sharpness_;
};

}  // namespace powderlink::physics
#endif
#endif
