// SPDX-License-Identifier: GPL-3.0-or-later
/// \file schiller_naumann.h
/// Drag on a sphere alone.
///
///   F_D = (pi/8) C_D rho d^2 |u - v| (u - v) = K (u - v)
///   C_D = 24/Re (1 + 0.15 Re^0.687)    Re <= 1000
///       = 0.44                         Re >  1000
///
/// as K = 3 pi mu d (C_D Re / 24), which has no 0/0 at rest; Re = Re_p = alpha_f d |u - v| / nu.
/// Symbols: C_D drag coefficient [-], K [kg/s], d diameter [m], rho, mu, nu density and viscosities of
/// the fluid [kg/m^3, Pa s, m^2/s], alpha_f fluid fraction [-], u, v velocities of fluid (between the
/// particles) and particle [m/s].
/// Sign: the force pulls the particle along with the fluid.
/// Model: a single sphere, alpha_f -> 1, where A and B are one; K is taken as K_A (without pressure
/// gradient). No crowding: alpha_f enters through Re_p only.
/// Validity: Re < 800 within 5 %; C_D jumps from 0.438 up to 0.44 (+0.4 %) at Re 1000.
/// Source: L. Schiller, A. Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318; with the plateau as in C.T.
/// Crowe et al., Multiphase Flows with Droplets and Particles, 2nd ed. (2012), Chapter 4.
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(schiller_naumann, SchillerNaumann)
#else
#ifndef POWDERLINK_FORCES_LAWS_SCHILLER_NAUMANN_H
#define POWDERLINK_FORCES_LAWS_SCHILLER_NAUMANN_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class SchillerNaumann : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"schiller_naumann",
                             ForceKind::drag,
                             "C_D = 24/Re (1 + 0.15 Re^0.687), 0.44 above Re 1000",
                             "single sphere, Re < 2e5",
                             "Schiller and Naumann 1933",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double, double) const override {
    if (reynolds > 1000.0) return 0.44 * reynolds / 24.0;
    return 1.0 + 0.15 * std::pow(reynolds, 0.687);
  }
};

}  // namespace powderlink::forces
#endif
#endif
