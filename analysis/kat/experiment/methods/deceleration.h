// SPDX-License-Identifier: GPL-3.0-or-later
/// \file deceleration.h
/// Gamma from the measured peak deceleration of the plate, a stop that is slow for the contact:
///
///   m A = 1.5 pi Gamma R_c:  Gamma = 8/9 rho R_c^2 A
///
/// Symbols: A peak deceleration of carrier and plate [m/s^2], others as in energy.h.
/// Validity: JKR; the pulse is much longer than the contact's own period, and A is that of the plate
/// itself (from the anvil's, a_carrier = a_anvil m_anvil/m_carrier).
/// Source: thesis of L. Pedrolli, Section 4.3. Tests: tests/analysis/kat/gamma_methods_test.cpp
#ifdef POWDERLINK_GAMMA_METHOD
POWDERLINK_GAMMA_METHOD(Deceleration)
#else
#ifndef POWDERLINK_ANALYSIS_LABORATORY_METHODS_DECELERATION_H
#define POWDERLINK_ANALYSIS_LABORATORY_METHODS_DECELERATION_H

#include "analysis/kat/experiment/gamma_method.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

struct Deceleration {
  static const GammaMethodInfo& info() {
    static const GammaMethodInfo i{
        "deceleration",
        "deceleration",
        "Gamma = 8/9 rho R_c^2 A",
        "the plate's measured peak deceleration pulls the grain off as a steady load would",
        "JKR; stop much longer than the contact's own period",
        "Pedrolli, Section 4.3",
        "--deceleration"};
    return i;
  }

  static double gamma_J_m2(const KatDrop& d) {
    return physics::adhesive_energy_slow_J_m2(d.particle.density_kg_m3, *d.deceleration_m_s2,
                                              d.critical_diameter_m);
  }

  static std::optional<GammaEstimate> estimate(const UncertainDrop& drop) {
    if (!drop.best.deceleration_m_s2) return std::nullopt;
    return propagated(drop, gamma_J_m2);
  }
};

}  // namespace powderlink::analysis
#endif
#endif
