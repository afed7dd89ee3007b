// SPDX-License-Identifier: GPL-3.0-or-later
/// \file openfoam_sphere.h
/// Drag on a sphere alone, as OpenFOAM's `sphereDrag`.
///
///   C_D = 24/Re (1 + Re^(2/3)/6)    Re <= 1000
///       = 0.424                     Re >  1000
///
/// K = 3 pi mu d (C_D Re / 24), Re = Re_p = alpha_f d |u - v| / nu.
/// Symbols and sign as in schiller_naumann.h.
/// Model: a single sphere, alpha_f -> 1; K is taken as K_A. No crowding.
/// Validity: Re < 2e5; the two branches meet at Re 1000 (0.424).
/// Source: A. Putnam, ARS J. 31 (1961) 1467; A.A. Amsden, P.J. O'Rourke, T.D. Butler, KIVA-II,
/// LA-11560-MS (1989).
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(openfoam_sphere, OpenfoamSphere)
#else
#ifndef POWDERLINK_FORCES_LAWS_OPENFOAM_SPHERE_H
#define POWDERLINK_FORCES_LAWS_OPENFOAM_SPHERE_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class OpenfoamSphere : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"openfoam_sphere",
                             ForceKind::drag,
                             "C_D = 24/Re (1 + Re^(2/3)/6), 0.424 above Re 1000",
                             "single sphere, Re < 2e5",
                             "Putnam 1961",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double, double) const override {
    if (reynolds > 1000.0) return 0.424 * reynolds / 24.0;
    return 1.0 + std::cbrt(reynolds * reynolds) / 6.0;
  }
};

}  // namespace powderlink::forces
#endif
#endif
