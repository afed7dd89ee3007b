// SPDX-License-Identifier: GPL-3.0-or-later
/// \file surface_roughness.h
/// Asperities carry the contact: the adhesion of a rough interface falls with the particle's size.
///
///   Gamma_eff = Gamma / (1 + R*/r_a)
///
/// so that the pull-off 1.5 pi Gamma_eff R* is that of an asperity of radius r_a on the sphere.
/// Symbols: r_a asperity radius [m], R* reduced radius [m], Gamma work of adhesion of the smooth
/// interface [J/m^2].
/// Validity: one asperity carries the contact; r_a >> R* is the smooth limit.
/// Source: H. Rumpf, Chem. Ing. Tech. 42 (1970) 538 (asperity in series with the sphere).
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(surface_roughness, SurfaceRoughness)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_SURFACE_ROUGHNESS_H
#define POWDERLINK_PHYSICS_EFFECTS_SURFACE_ROUGHNESS_H

#include <cmath>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class SurfaceRoughness : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "surface_roughness",
        "asperities limit the contact: Gamma falls with R",
        "slope from -1.2 (small d) towards -0.6 (large d)",
        {{"asperity_radius_m", std::numeric_limits<double>::infinity(), 1e-6, 1e-9, 1e-2, 1e-9,
          1e-5, "asperities of powder and polished plates, 1 nm to 10 um"}},
        "a polished plate, or one of known roughness"};
    return i;
  }

  explicit SurfaceRoughness(const std::vector<double>& p) : asperity_radius_(p.at(0)) {
    require_range(info(), 0, p[0]);
  }

  double adhesion_factor(double reduced_radius) const override {
    return 1.0 / (1.0 + reduced_radius / asperity_radius_);
  }

 private:
  double asperity_radius_;
};

}  // namespace powderlink::physics
#endif
#endif
