// SPDX-License-Identifier: GPL-3.0-or-later
/// \file capillary_bridge.h
/// A liquid bridge between sphere and plate, from touch to rupture.
///
///   F(h) = -4 pi R gamma (1 - h/H),   H = sqrt(h^2 + V/(pi R)),   0 <= h <= h_r
///   V = h_r^3                          (rupture at the cube root of the volume)
///
/// Derivation: bridge of immersion H between plate and parabola, V = pi R (H^2 - h^2), Laplace
/// pressure 2 gamma/H on the wetted area 2 pi R (H - h), contact angles zero.
/// Symbols: gamma surface tension [N/m], R radius of the sphere [m], h gap [m], h_r = kappa R rupture
/// distance [m], V volume [m^3].
/// Sign: F < 0 attracts; while the solids overlap it stays at its value of h = 0.
/// Validity: small volume, quasi-static bridge (no viscous force), full wetting.
/// Source: D. Maugis, J. Adhesion Sci. Technol. 1 (1987) 105; rupture: G. Lian et al.,
/// J. Colloid Interface Sci. 161 (1993) 138.
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(capillary_bridge, CapillaryBridge)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_CAPILLARY_BRIDGE_H
#define POWDERLINK_PHYSICS_EFFECTS_CAPILLARY_BRIDGE_H

#include <cmath>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class CapillaryBridge : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "capillary_bridge",
        "a liquid bridge with force and rupture distance",
        "slope towards -2 at low Gamma",
        {{"surface_tension_N_m", 0.0, 0.0728, 1e-4, 10.0, 0.02, 0.0728,
          "organic films to clean water"},
         {"rupture_distance_over_R", 0.0, 0.05, 1e-4, 1.0, 1e-3, 0.3,
          "adsorbed films to pendular bridges"}},
        "dry the powder and the air (below 20 % relative humidity): d_c at low speed must fall"};
    return i;
  }

  explicit CapillaryBridge(const std::vector<double>& p) : tension_(p.at(0)), kappa_(p.at(1)) {
    for (std::size_t i = 0; i < 2; ++i) require_range(info(), i, p[i]);
  }

  double gap_force_N(double gap, double radius) const override {
    if (off() || gap > range_m(radius)) return 0.0;
    const double h = std::fmax(gap, 0.0);
    return -4.0 * kPi * radius * tension_ * (1.0 - h / std::sqrt(h * h + volume_over_pi_R(radius)));
  }
  double gap_energy_J(double gap, double radius) const override {
    const double end = range_m(radius);
    if (off() || gap > end) return 0.0;
    const double h = std::fmax(gap, 0.0);
    const double inside = std::fmin(gap, 0.0);  // constant force while the solids overlap
    const double w = volume_over_pi_R(radius);
    return -4.0 * kPi * radius * tension_ *
           (end - std::sqrt(end * end + w) - (h - std::sqrt(h * h + w)) - inside);
  }
  double range_m(double radius) const override { return off() ? 0.0 : kappa_ * radius; }
  bool formed_by_touch() const override { return true; }

 private:
  static constexpr double kPi = 3.14159265358979323846;
  /// No tension or no liquid: no bridge, not one of zero length.
  bool off() const { return tension_ == 0.0 || kappa_ == 0.0; }
  double volume_over_pi_R(double radius) const {
    const double end = range_m(radius);
    return end * end * end / (kPi * radius);
  }
  double tension_, kappa_;
};

}  // namespace powderlink::physics
#endif
#endif
