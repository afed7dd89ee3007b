// SPDX-License-Identifier: GPL-3.0-or-later
/// \file beetstra.h
/// Drag from lattice-Boltzmann simulations up to Re 1000.
///
///   F = 10 phi/alpha_f^2 + alpha_f^2 (1 + 1.5 sqrt(phi))
///       + 0.413 Re/(24 alpha_f^2)
///         (1/alpha_f + 3 alpha_f phi + 8.4 Re^-0.343) / (1 + 10^(3 phi) Re^-(1 + 4 phi)/2)
///   F_D = 3 pi mu d alpha_f F (u - v),   K = 3 pi mu d alpha_f F
///
/// phi = 1 - alpha_f, Re = Re_p = alpha_f d |u - v| / nu. Monodisperse form.
/// Symbols: F over Stokes at the superficial velocity [-]; else, and sign, as in schiller_naumann.h.
/// Model: the source's F excludes the pressure gradient force: K is K_A. Its total force is F/alpha_f.
/// Validity: 0 <= phi <= 0.6, Re <= 1000, random arrays of equal spheres.
/// Source: R. Beetstra, M.A. van der Hoef, J.A.M. Kuipers, AIChE J. 53 (2007) 489, with its erratum
/// AIChE J. 53 (2007) 3020; Re -> 0: M.A. van der Hoef, R. Beetstra, J.A.M. Kuipers, J. Fluid Mech.
/// 528 (2005) 233.
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(beetstra, Beetstra)
#else
#ifndef POWDERLINK_FORCES_LAWS_BEETSTRA_H
#define POWDERLINK_FORCES_LAWS_BEETSTRA_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class Beetstra : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"beetstra",
                             ForceKind::drag,
                             "F(phi, Re) of random arrays of equal spheres",
                             "phi <= 0.6, Re <= 1000",
                             "Beetstra, van der Hoef and Kuipers 2007",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double fluid_fraction, double) const override {
    const double phi = 1.0 - fluid_fraction;
    const double square = fluid_fraction * fluid_fraction;
    const double viscous = 10.0 * phi / square + square * (1.0 + 1.5 * std::sqrt(phi));
    // Numerator and denominator times Re^(1 + 4 phi)/2: no division by 0 at rest.
    const double growth = std::pow(reynolds, 0.5 * (1.0 + 4.0 * phi));
    const double inertial = 0.413 / (24.0 * square) *
                            (reynolds * (1.0 / fluid_fraction + 3.0 * fluid_fraction * phi) +
                             8.4 * std::pow(reynolds, 1.0 - 0.343)) *
                            growth / (growth + std::pow(10.0, 3.0 * phi));
    return fluid_fraction * (viscous + inertial);
  }
};

}  // namespace powderlink::forces
#endif
#endif
