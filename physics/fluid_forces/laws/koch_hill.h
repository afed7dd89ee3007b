// SPDX-License-Identifier: GPL-3.0-or-later
/// \file koch_hill.h
/// Drag from lattice-Boltzmann simulations of random arrays, with inertia.
///
///   beta_A = 18 mu alpha_f^2 alpha_s/d^2 (F0 + F3 Re/2),   K = 3 pi mu d alpha_f^2 (F0 + F3 Re/2)
///   F0 = (1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 17.14 phi)
///        / (1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3)                  phi <  0.4
///      = 10 phi/(1 - phi)^3                                           phi >= 0.4
///   F3 = 0.0673 + 0.212 phi + 0.0232/(1 - phi)^5
///
/// phi = 1 - alpha_f, Re = Re_p = alpha_f d |u - v| / nu (half of it in the source: hence F3 Re/2).
/// Symbols: F0, F3 viscous and inertial factor [-], phi solids fraction [-]; else, and sign, as in
/// schiller_naumann.h.
/// Model: the source's F is the *total* force with the mean pressure gradient, over
/// 3 pi mu d alpha_f (u - v): K_B = 3 pi mu d alpha_f F; K here is K_A = alpha_f K_B.
/// Validity: 0 < phi < 0.64, Re < 200. F0 falls by 3.8 % when phi passes 0.4. For phi -> 0 the law
/// is 1 + 0.045 Re: 9 % below Schiller-Naumann at Re 1, 3 % at Re 40, 49 % above at Re 200.
/// The factor is 17.14, not the 16.14 that some codes carry: only 17.14 - 0.681 gives the exact dilute
/// coefficient 16.456 of S. Kim, W.B. Russel, J. Fluid Mech. 154 (1985) 269.
/// Source: D.L. Koch, R.J. Hill, Annu. Rev. Fluid Mech. 33 (2001) 619; R.J. Hill, D.L. Koch, A.J.C.
/// Ladd, J. Fluid Mech. 448 (2001) 213 (F0) and 243 (F3); F0 from D.L. Koch, A.S. Sangani, J. Fluid
/// Mech. 400 (1999) 229.
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(koch_hill, KochHill)
#else
#ifndef POWDERLINK_FORCES_LAWS_KOCH_HILL_H
#define POWDERLINK_FORCES_LAWS_KOCH_HILL_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class KochHill : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"koch_hill",
                             ForceKind::drag,
                             "F0(phi) + F3(phi) Re/2 of random arrays of spheres",
                             "phi < 0.64, Re < 200; F0 falls by 3.8 % at phi 0.4",
                             "Koch and Hill 2001; Hill, Koch and Ladd 2001",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  static double viscous_factor(double phi) {
    if (phi >= 0.4) return 10.0 * phi / std::pow(1.0 - phi, 3);
    const double logarithm = phi > 0.0 ? phi * std::log(phi) : 0.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * phi) + 135.0 / 64.0 * logarithm + 17.14 * phi) /
           (1.0 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
  }
  static double inertial_factor(double phi) {
    return 0.0673 + 0.212 * phi + 0.0232 / std::pow(1.0 - phi, 5);
  }

  double stokes_factor(double reynolds, double fluid_fraction, double) const override {
    const double phi = 1.0 - fluid_fraction;
    return fluid_fraction * fluid_fraction *
           (viscous_factor(phi) + 0.5 * inertial_factor(phi) * reynolds);
  }
};

}  // namespace powderlink::forces
#endif
#endif
