// SPDX-License-Identifier: GPL-3.0-or-later
/// \file di_felice.h
/// Drag with a voidage exponent that follows the Reynolds number.
///
///   F_D = (pi/8) C_D rho d^2 alpha_f^(2-chi) |u - v| (u - v)
///   C_D = (0.63 + 4.8 Re^-1/2)^2
///   chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)
///   K   = 3 pi mu d (0.63 Re^1/2 + 4.8)^2/24 alpha_f^(1-chi),   Re = alpha_f d |u - v| / nu
///
/// Symbols and sign as in schiller_naumann.h; chi voidage exponent [-].
/// Model: K is K_A: exponent -chi on the superficial velocity; model B has -(chi + 1) (Kafui et al.).
/// Validity: spheres, any alpha_f, 0.01 < Re < 1e4. Dallavalle's C_D tends to 23.04/Re: K is 4 %
/// below Stokes for Re -> 0; kept as in the source.
/// Source: R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153; J.M. Dallavalle, Micromeritics
/// (1948); for the model K.D. Kafui, C. Thornton, M.J. Adams, Chem. Eng. Sci. 57 (2002) 2395.
/// Tests: tests/physics/fluid_forces/drag_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(di_felice, DiFelice)
#else
#ifndef POWDERLINK_FORCES_LAWS_DI_FELICE_H
#define POWDERLINK_FORCES_LAWS_DI_FELICE_H

#include <algorithm>
#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class DiFelice : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"di_felice",
                             ForceKind::drag,
                             "Dallavalle's C_D times alpha_f^-chi(Re)",
                             "spheres, 0.01 < Re < 1e4; 4 % below Stokes at Re -> 0",
                             "Di Felice 1994",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double fluid_fraction, double) const override {
    const double root = 0.63 * std::sqrt(reynolds) + 4.8;
    const double distance = 1.5 - std::log10(std::max(reynolds, 1e-100));
    const double chi = 3.7 - 0.65 * std::exp(-0.5 * distance * distance);
    return root * root / 24.0 * std::pow(fluid_fraction, 1.0 - chi);
  }
};

}  // namespace powderlink::forces
#endif
#endif
