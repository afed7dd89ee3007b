// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gidaspow.h
/// Drag in a packed bed (Ergun) and in a suspension (Wen and Yu).
///
///   alpha_f <  0.8   beta_A = 150 alpha_s^2 mu/(alpha_f d^2) + 1.75 alpha_s rho |u - v|/d
///   alpha_f >= 0.8   beta_A = 3/4 C_D alpha_s alpha_f rho |u - v|/d alpha_f^-2.65
///   K = beta_A V/alpha_s = 3 pi mu d f
///   f = (150 alpha_s + 1.75 Re) / (18 alpha_f)    or    (C_D Re/24) alpha_f^-2.65
///
/// C_D of Schiller and Naumann at Re = Re_p = alpha_f d |u - v| / nu, 0.44 from Re 1000 on.
/// Symbols: beta_A exchange coefficient [kg/(m^3 s)], alpha_s = 1 - alpha_f, V = pi d^3/6 [m^3];
/// else, and sign, as in schiller_naumann.h.
/// Model: K is K_A, without the pressure gradient force. Summed over the n particles of a volume,
/// n K (u - v) = -alpha_f dp/dx; with V (-dp/dx) from each of them this is the whole of Ergun's -dp/dx.
/// Validity: spheres, any alpha_f. The law *jumps* at alpha_f 0.8: for Re -> 0 from 2.083 (Ergun)
/// down to 1.806 (Wen-Yu), -13 %; this is the law of the source and is kept.
/// Source: D. Gidaspow, Multiphase Flow and Fluidization (1994), Chapter 2, after S. Ergun, Chem.
/// Eng. Prog. 48 (1952) 89 and C.Y. Wen, Y.H. Yu, Chem. Eng. Prog. Symp. 62 (1966) 100.
/// Tests: tests/physics/fluid_forces/drag_test.cpp, tests/physics/fluid_forces/packed_bed_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(gidaspow, Gidaspow)
#else
#ifndef POWDERLINK_FORCES_LAWS_GIDASPOW_H
#define POWDERLINK_FORCES_LAWS_GIDASPOW_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class Gidaspow : public DragLaw {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"gidaspow",
                             ForceKind::drag,
                             "Ergun below fluid fraction 0.8, Wen-Yu alpha_f^-2.65 above",
                             "spheres, any fluid fraction; jumps by -13 % at 0.8",
                             "Gidaspow 1994; Ergun 1952; Wen and Yu 1966",
                             {},
                             true};
    return i;
  }
  using DragLaw::DragLaw;

  double stokes_factor(double reynolds, double fluid_fraction, double) const override {
    if (fluid_fraction < 0.8) {
      return (150.0 * (1.0 - fluid_fraction) + 1.75 * reynolds) / (18.0 * fluid_fraction);
    }
    const double sphere =
        reynolds >= 1000.0 ? 0.44 * reynolds / 24.0 : 1.0 + 0.15 * std::pow(reynolds, 0.687);
    return sphere * std::pow(fluid_fraction, -2.65);
  }
};

}  // namespace powderlink::forces
#endif
#endif
