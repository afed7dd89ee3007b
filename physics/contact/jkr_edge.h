// SPDX-License-Identifier: GPL-3.0-or-later
/// \file jkr_edge.h
/// A JKR contact whose edge is out of equilibrium: contact radius and overlap are independent.
///
///   G = E* (a^2/R* - delta)^2 / (2 pi a)            energy release rate of the edge
///   F = 2 E* a (delta - a^2/(3 R*))                 normal force, > 0 pushes apart
///
/// G equals Gamma in equilibrium and exceeds it when the edge wants to recede; on the equilibrium
/// curve F is that of jkr_law.h.
/// Symbols: a contact radius [m], delta overlap, < 0 in the neck [m], R* reduced radius [m], E*
/// effective Young's modulus [Pa], G and Gamma [J/m^2], F [N].
/// Validity: a << R*; the interface's processes are confined to the edge.
/// Source: D. Maugis, M. Barquins, J. Phys. D 11 (1978) 1989.
/// Tests: tests/physics/jkr_law_test.cpp
#pragma once

#include "physics/contact/jkr_law.h"

namespace powderlink::physics {

inline double energy_release_rate_J_m2(const JkrLaw& law, double contact_radius_m, double overlap_m,
                                       double radius_m) {
  const double misfit = contact_radius_m * contact_radius_m / radius_m - overlap_m;
  return law.effective_modulus_Pa() * misfit * misfit / (2.0 * JkrLaw::kPi * contact_radius_m);
}

inline double force_off_equilibrium_N(const JkrLaw& law, double contact_radius_m, double overlap_m,
                                      double radius_m) {
  return 2.0 * law.effective_modulus_Pa() * contact_radius_m *
         (overlap_m - contact_radius_m * contact_radius_m / (3.0 * radius_m));
}

}  // namespace powderlink::physics
