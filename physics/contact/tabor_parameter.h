// SPDX-License-Identifier: GPL-3.0-or-later
/// \file tabor_parameter.h
/// Which adhesion theory holds: JKR for soft, strongly adhering contacts, DMT for hard, weak ones.
///
///   mu_T = (R* Gamma^2 / (E*^2 z0^3))^(1/3)
///
/// Symbols: R* reduced radius [m], Gamma work of adhesion of the interface [J/m^2], E* effective
/// modulus [Pa], z0 equilibrium separation of the surfaces [m], about 0.3 nm.
/// Validity: mu_T > 5 JKR, mu_T < 0.1 DMT, Maugis-Dugdale between.
/// Source: D. Tabor, J. Colloid Interface Sci. 58 (1977) 2.
/// Tests: tests/physics/contact_laws_test.cpp
#pragma once

#include <cmath>

namespace powderlink::physics {

inline constexpr double kEquilibriumSeparation_m = 0.3e-9;

inline double tabor_parameter(double radius_m, double work_of_adhesion_J_m2, double modulus_Pa,
                              double separation_m = kEquilibriumSeparation_m) {
  return std::cbrt(radius_m * work_of_adhesion_J_m2 * work_of_adhesion_J_m2 /
                   (modulus_Pa * modulus_Pa * separation_m * separation_m * separation_m));
}

inline const char* adhesion_theory(double tabor) {
  return tabor > 5.0 ? "JKR" : tabor < 0.1 ? "DMT" : "Maugis-Dugdale";
}

}  // namespace powderlink::physics
