// SPDX-License-Identifier: GPL-3.0-or-later
/// \file electrostatic_image_force.h
/// A uniformly charged sphere is attracted by its image in the plate.
///
///   F(h) = -q^2 / (16 pi eps0 (R + h)^2),   U(h) = -q^2 / (16 pi eps0 (R + h)),
///   q = 4 pi R^2 sigma
///
/// Symbols: q charge [C], sigma surface charge density [C/m^2], R radius [m], h gap [m], v impact
/// speed [m/s], rho density of the sphere [kg/m^3], eps0 8.8541878128e-12 F/m.
/// Sign: F < 0 attracts; U is 0 at infinity.
/// The potential scales with R^3 as the kinetic energy does, so below
/// v^2 = 3 sigma^2/(2 rho eps0) nothing leaves at any size.
/// Validity: conducting plate, charge that does not move on the sphere.
/// Source: J. D. Jackson, Classical Electrodynamics, Section 2.2. Breakdown of air at 3 MV/m limits
/// sigma to 2.7e-5 C/m^2 on large spheres; small ones hold some times more.
/// Tests: tests/physics/effects_test.cpp, tests/analysis/kat/reduced_model_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(electrostatic_image_force, ElectrostaticImageForce)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_ELECTROSTATIC_IMAGE_FORCE_H
#define POWDERLINK_PHYSICS_EFFECTS_ELECTROSTATIC_IMAGE_FORCE_H

#include "physics/effects/effect.h"

namespace powderlink::physics {

class ElectrostaticImageForce : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "electrostatic_image_force",
        "charge on the particle and its image in the plate attract beyond the neck",
        "d_c diverges at low v (nothing leaves below a speed), slope -1.2 at high v",
        {{"surface_charge_C_m2", 0.0, 2e-5, 1e-9, 1e-2, 0.0, 1e-4,
          "breakdown of air: 2.7e-5 C/m2 on large, some times more on small spheres"}},
        "neutralise the powder (ionised air, a conducting plate earthed): "
        "d_c at low speed must fall"};
    return i;
  }

  explicit ElectrostaticImageForce(const std::vector<double>& p) : charge_density_(p.at(0)) {
    require_range(info(), 0, p[0]);
  }

  double gap_force_N(double gap, double radius) const override {
    return gap_energy_J(gap, radius) / (radius + gap);
  }
  double gap_energy_J(double gap, double radius) const override {
    constexpr double pi = 3.14159265358979323846;
    constexpr double vacuum_permittivity_F_m = 8.8541878128e-12;
    const double charge = 4.0 * pi * radius * radius * charge_density_;
    return -charge * charge / (16.0 * pi * vacuum_permittivity_F_m * (radius + gap));
  }
  double range_m(double /*radius_m*/) const override {
    return charge_density_ > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
  }

 private:
  double charge_density_;
};

}  // namespace powderlink::physics
#endif
#endif
