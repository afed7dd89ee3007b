// SPDX-License-Identifier: GPL-3.0-or-later
/// \file plastic_contact.h
/// Adhesion itself presses the contact beyond yield: it flattens, and the pull-off grows.
///
///   p     = 6 pi Gamma R* / (pi a0^2),   a0^3 = 9 pi Gamma R*^2/(2 E*)
///   R_p/R* = (p/p_y)^(3/2) for p > p_y, else 1;   Gamma_eff = Gamma R_p/R*
///
/// so that the pull-off is 1.5 pi Gamma R_p. Derivation: at rest JKR carries the apparent Hertz load
/// P = 6 pi Gamma R*; where its mean pressure p exceeds p_y the contact grows until P = pi a^2 p_y,
/// and unloads elastically with the radius of curvature R_p that has this a at this P. Yield is taken
/// to set in at once, where it really spreads gradually from below the surface.
/// p ~ Gamma^(1/3) E*^(2/3) R*^(-1/3): small grains yield first.
/// Symbols: p, p_y mean pressure, and at yield [Pa], R*, R_p reduced and flattened radius [m], a0
/// contact radius at rest [m], Gamma work of adhesion [J/m^2], E* effective modulus [Pa].
/// Validity: yield by adhesion alone (no other preload), a << R*, no hardening.
/// Source: D. Maugis, H. M. Pollock, Acta Metall. 32 (1984) 1323; flattened radius: C. Thornton,
/// Z. Ning, Powder Technol. 99 (1998) 154.
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(plastic_contact, PlasticContact)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_PLASTIC_CONTACT_H
#define POWDERLINK_PHYSICS_EFFECTS_PLASTIC_CONTACT_H

#include <cmath>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class PlasticContact : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "plastic_contact",
        "adhesion presses the contact beyond yield: it flattens and pulls harder",
        "slope from -1.2 (large d, low v) to -0.8 (small d, high v)",
        {{"yield_pressure_Pa", std::numeric_limits<double>::infinity(), 2e9, 1e6, 1e12, 1e8, 1e10,
          "hardness: soft polymers 1e8 Pa, metals 0.5-3e9 Pa, glass 6e9 Pa"}},
        "a harder plate, or rest times and preloads that differ"};
    return i;
  }

  explicit PlasticContact(const std::vector<double>& p) : yield_pressure_(p.at(0)) {
    require_range(info(), 0, p[0]);
  }

  double flattening_factor(const JkrLaw& law, double reduced_radius) const override {
    if (!law.adhesive()) return 1.0;
    const double a0 = law.equilibrium_contact_radius_m(reduced_radius);
    const double ratio =
        6.0 * law.work_of_adhesion_J_m2() * reduced_radius / (a0 * a0 * yield_pressure_);
    return ratio > 1.0 ? ratio * std::sqrt(ratio) : 1.0;
  }

 private:
  double yield_pressure_;
};

}  // namespace powderlink::physics
#endif
#endif
