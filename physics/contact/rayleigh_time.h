// SPDX-License-Identifier: GPL-3.0-or-later
/// \file rayleigh_time.h
/// Time a Rayleigh wave needs around a sphere: the yardstick of the DEM time step.
///
///   dt_R = pi R sqrt(rho/G) / (0.8766 + 0.1631 nu),   G = E / (2 (1 + nu))
///
/// Symbols: R radius [m], rho density [kg/m^3], E, G Young's and shear modulus [Pa], nu Poisson's
/// ratio [-].
/// Validity: explicit integration wants 0.1-0.2 dt_R; above 0.5 dt_R powderlink refuses to run.
/// Source: Thornton and Randall, in Micromechanics of Granular Materials (1988) 133.
/// Tests: tests/physics/contact_laws_test.cpp
#pragma once

#include <cmath>

#include "physics/contact/material.h"

namespace powderlink::physics {

inline constexpr double kLargestRayleighFraction = 0.5;

inline double rayleigh_time_s(double radius_m, const Material& m) {
  constexpr double pi = 3.14159265358979323846;
  return pi * radius_m * std::sqrt(m.density_kg_m3 / m.shear_modulus_Pa()) /
         (0.8766 + 0.1631 * m.poissons_ratio);
}

}  // namespace powderlink::physics
