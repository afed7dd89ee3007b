// SPDX-License-Identifier: GPL-3.0-or-later
/// \file softened_adhesion.h
/// The work of adhesion that goes with a lowered modulus: grains stick up to the same speed.
///
///   Gamma' = Gamma (E*'/E*)^(2/5)
///
/// A JKR contact loses W = 7.09 (Gamma^5 R*^4/E*^2)^(1/3) in each touch and go; Gamma' keeps it.
/// With it all lengths of the contact (overlap, neck, square of the contact radius) grow by
/// lambda = (E*/E*')^(2/5) and all its forces fall by lambda, so that work and, at any speed of
/// impact, the rebound stay as they are. Collisions last lambda times as long.
/// What is lost: static forces. The pull-off force 1.5 pi Gamma R* falls by lambda, so a force
/// lambda times smaller lifts a grain off. With Gamma unchanged the pull-off force stays, and the
/// sticking speed grows by (E*/E*')^(1/3).
///
/// Symbols: Gamma work of adhesion of the interface [J/m^2], E* effective modulus [Pa], R* reduced
/// radius [m], W [J]; ' with the lowered modulus.
/// Validity: JKR before and after; overlaps small against R*.
/// Source: Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; sticking speed: C. Thornton
/// and Z. Ning, Powder Technol. 99 (1998) 154; similarity: from the law (jkr_law.h).
/// Tests: tests/physics/collision_test.cpp
#pragma once

#include <cmath>

namespace powderlink::physics {

inline double softened_adhesion_J_m2(double work_of_adhesion_J_m2, double modulus_Pa,
                                     double softened_modulus_Pa) {
  return work_of_adhesion_J_m2 * std::pow(softened_modulus_Pa / modulus_Pa, 0.4);
}

}  // namespace powderlink::physics
