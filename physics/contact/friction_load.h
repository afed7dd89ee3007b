// SPDX-License-Identifier: GPL-3.0-or-later
/// \file friction_load.h
/// Normal load that limits friction and rolling resistance of an adhesive contact.
///
///   N = |F + 2 F_po|,   F_po = 1.5 pi Gamma R*,   |F_t| <= mu N
///
/// At F = 0 the surfaces are still pressed together by adhesion, so mu |F| would let a glued grain
/// slide freely. Adding twice the pull-off force keeps N = F_po > 0 even at the pull-off point
/// F = -F_po, and the limit falls back to Coulomb's mu F for Gamma = 0.
/// Symbols: N load that limits, F_t tangential force [N]; F normal contact force, > 0 pushing apart
/// [N]; F_po pull-off force [N]; Gamma work of adhesion of the interface [J/m^2]; R* reduced radius
/// [m]; mu friction coefficient [-].
/// Validity: JKR contacts, neck included (there F >= -F_po).
/// Source: C. Thornton, J. Phys. D 24 (1991) 1942.
/// Tests: tests/physics/contact_laws_test.cpp
#pragma once

#include <cmath>

namespace powderlink::physics {

inline double friction_load_N(double normal_force_N, double pull_off_force_N) {
  return std::fabs(normal_force_N + 2.0 * pull_off_force_N);
}

}  // namespace powderlink::physics
