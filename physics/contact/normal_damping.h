// SPDX-License-Identifier: GPL-3.0-or-later
/// \file normal_damping.h
/// Viscous damping of a contact, in overlap and in the neck.
///
///   F_d = -gamma_n v_n,   gamma_n = -2 sqrt(5/6) beta sqrt(S_n m*),   S_n = 2 E* a
///   gamma_t = -2 sqrt(5/6) beta sqrt(k_t m*),                         k_t = 8 G* a
///   beta = ln e / sqrt(ln^2 e + pi^2)   (<= 0)
///
/// Symbols: e coefficient of restitution [-], m* reduced mass [kg] (plate: the sphere's own mass),
/// a contact radius [m], E*, G* effective moduli [Pa], v_n normal velocity, > 0 when separating
/// [m/s]; gamma_n, gamma_t normal and tangential damping [kg/s], S_n, k_t stiffnesses [N/m].
/// Sign: F_d > 0 pushes apart; it only takes energy. gamma_t is made where k_t is known (model jkr).
/// The neck is damped as the overlap is, through the contact radius that both have in common.
/// Validity: e is the restitution of the non-adhesive Hertz contact.
/// Source: Tsuji et al., Powder Technol. 71 (1992) 239; thesis of L. Pedrolli, Appendix B, with
/// 2 sqrt(5/6) for the printed 5/3 and m* the reduced mass.
/// Tests: tests/physics/contact_laws_test.cpp
#pragma once

#include <cmath>

#include "base/invalid_input.h"

namespace powderlink::physics {

inline constexpr double kTwoSqrtFiveSixths = 1.82574185835055371;

/// beta of the restitution coefficient e, 0 < e <= 1.
inline double damping_ratio(double restitution) {
  if (!(restitution > 0.0 && restitution <= 1.0)) {
    throw InvalidInput("restitution coefficient", number_text(restitution), "0 < e <= 1",
                       "use 1 for no damping");
  }
  const double log_e = std::log(restitution);
  constexpr double pi = 3.14159265358979323846;
  return log_e / std::sqrt(log_e * log_e + pi * pi);
}

/// gamma_n [kg/s].
inline double normal_damping_kg_s(double beta, double modulus_Pa, double contact_radius_m,
                                  double reduced_mass_kg) {
  return -kTwoSqrtFiveSixths * beta *
         std::sqrt(2.0 * modulus_Pa * contact_radius_m * reduced_mass_kg);
}

}  // namespace powderlink::physics
