// SPDX-License-Identifier: GPL-3.0-or-later
/// \file ganser.h
/// Drag on an isometric particle that is not a sphere.
///
///   C_D = 24/(Re K1) (1 + 0.1118 (Re K1 K2)^0.6567) + 0.4305 K2/(1 + 3305/(Re K1 K2))
///   K1  = 1/(1/3 + 2/3 psi^-1/2)                 shape factor of Stokes flow
///   K2  = 10^(1.8148 (-log10 psi)^0.5743)        shape factor of Newton's range
///   K   = 3 pi mu d (C_D Re/24),   Re = alpha_f d |u - v| / nu
///
/// Symbols: psi sphericity [-], d diameter of the sphere of equal volume [m]; else, and sign, as in
/// schiller_naumann.h.
/// Model: a single particle, alpha_f -> 1; K is taken as K_A. No crowding.
/// Validity: isometric particles (cubes, octahedra, crushed grains), random orientation, far from
/// walls; Re K1 K2 < 1e5; psi from about 0.5 for isometric shapes. The fit spans all shapes: at
/// psi = 1 it is below Schiller-Naumann's, by 13 % at Re 10 and 26 % at Re 100. For spheres take a
/// sphere's law.
/// Source: G.H. Ganser, Powder Technol. 77 (1993) 143, Eq. 18 and Table 7 (isometric).
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(ganser, Ganser)
#else
#ifndef POWDERLINK_FORCES_LAWS_GANSER_H
#define POWDERLINK_FORCES_LAWS_GANSER_H

#include <algorithm>
#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class Ganser : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"ganser",
                             ForceKind::drag,
                             "C_D(Re K1 K2) with Stokes and Newton shape factors of the sphericity",
                             "single isometric particle, Re K1 K2 < 1e5",
                             "Ganser 1993",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double, double sphericity) const override {
    const double k1 = 1.0 / (1.0 / 3.0 + 2.0 / (3.0 * std::sqrt(sphericity)));
    const double minus_log = std::max(0.0, -std::log10(sphericity));
    const double k2 = std::pow(10.0, 1.8148 * std::pow(minus_log, 0.5743));
    const double x = reynolds * k1 * k2;
    return (1.0 + 0.1118 * std::pow(x, 0.6567)) / k1 +
           0.4305 * k2 * reynolds / 24.0 * x / (x + 3305.0);
  }
};

}  // namespace powderlink::forces
#endif
#endif
