// SPDX-License-Identifier: GPL-3.0-or-later
/// \file buoyancy.h
/// Weight and Archimedes' force.
///
///   F = (rho_p - rho_f) V g     weight_in_dem = false
///   F = -rho_f V g              weight_in_dem = true: the DEM code applies m g (fix gravity)
///
/// Symbols: rho_p, rho_f densities of particle and fluid [kg/m^3], V = pi d^3/6 [m^3], g [m/s^2].
/// Sign: along g for a particle that is heavier than the fluid; against g with weight_in_dem.
/// Model: the same in A and B. The pressure of FluidState is dynamic, so its hydrostatic part
/// rho_f g is counted here and only here; `pressure_gradient` never holds it. In a settling
/// suspension the greater buoyancy of the mixture is in the dynamic pressure gradient,
/// alpha_s (rho_p - rho_f) g. The fluid gets no reaction: with the dynamic pressure its own weight
/// has gone as well.
/// Validity: g even, rho_f even over the particle.
/// Source: C.T. Crowe et al., Multiphase Flows with Droplets and Particles, 2nd ed. (2012),
/// Chapter 4.
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(buoyancy, Buoyancy)
#else
#ifndef POWDERLINK_FORCES_LAWS_BUOYANCY_H
#define POWDERLINK_FORCES_LAWS_BUOYANCY_H

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class Buoyancy : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{
        "buoyancy",
        ForceKind::body,
        "F = (rho_p - rho_f) V g, or -rho_f V g when the DEM applies the weight",
        "pressure is dynamic",
        "Archimedes; Crowe et al. 2012",
        {"gravity_m_s2"},
        false};
    return i;
  }

  explicit Buoyancy(const ForceSettings& s) : weight_in_dem_(s.weight_in_dem) {}

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    const double weight = weight_in_dem_ ? 0.0 : p.density_kg_m3;
    ForceTerms t;
    t.force_N = scaled((weight - f.density_kg_m3) * volume_m3(p), f.gravity_m_s2);
    return t;
  }

 private:
  bool weight_in_dem_;
};

}  // namespace powderlink::forces
#endif
#endif
