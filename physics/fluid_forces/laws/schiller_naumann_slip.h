// SPDX-License-Identifier: GPL-3.0-or-later
/// \file schiller_naumann_slip.h
/// Drag on a sphere alone, blind to the fluid fraction: Re is that of the slip velocity.
///
///   F_D = (pi/8) C_D rho d^2 |u - v| (u - v) = K (u - v)
///   C_D = max(24/Re (1 + 0.15 Re^0.687), 0.44),    Re = d |u - v| / nu
///
/// as K = 3 pi mu d (C_D Re / 24), which has no 0/0 at rest.
/// Symbols: C_D drag coefficient [-], d diameter [m], rho, mu, nu density and viscosities of the fluid
/// [kg/m^3, Pa s, m^2/s], u interstitial velocity of the fluid, v of the particle [m/s].
/// Sign: the force pulls the particle along with the fluid.
/// Model: K is taken as K_A; in model B it is divided by alpha_f. The law of CFDEMcoupling's
/// SchillerNaumannDrag. Against `schiller_naumann`, whose Re has alpha_f in it, K is larger at
/// alpha_f 0.6, by 4 % at Re 1, 14 % at 10 and 35 % at 272; it is the same at alpha_f 1, but for the
/// plateau, which begins without a step.
/// Validity: a single sphere, Re < 800 within 5 %.
/// Source: L. Schiller, A. Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318.
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(schiller_naumann_slip, SchillerNaumannSlip)
#else
#ifndef POWDERLINK_FORCES_LAWS_SCHILLER_NAUMANN_SLIP_H
#define POWDERLINK_FORCES_LAWS_SCHILLER_NAUMANN_SLIP_H

#include <algorithm>
#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class SchillerNaumannSlip : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"schiller_naumann_slip",
                             ForceKind::drag,
                             "C_D = 24/Re (1 + 0.15 Re^0.687), at least 0.44, Re without alpha_f",
                             "single sphere, Re < 2e5",
                             "Schiller and Naumann 1933",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double fluid_fraction, double) const override {
    const double of_slip = reynolds / fluid_fraction;
    return std::max(1.0 + 0.15 * std::pow(of_slip, 0.687), 0.44 * of_slip / 24.0);
  }
};

}  // namespace powderlink::forces
#endif
#endif
