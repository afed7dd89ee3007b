// SPDX-License-Identifier: GPL-3.0-or-later
/// \file virtual_mass.h
/// The fluid that a particle must accelerate with itself.
///
///   F_vm = C_vm rho_f V (Du/Dt - dv/dt)
///
/// handed back as added mass m_a = C_vm rho_f V and explicit force m_a Du/Dt, so that the host
/// solves (m + m_a) dv/dt: taking dv/dt of the last step instead is unstable for light particles.
/// Symbols: C_vm 1/2 for a sphere [-], rho_f density of the fluid [kg/m^3], V = pi d^3/6 [m^3], m, m_a
/// mass of the particle and added mass [kg], Du/Dt acceleration of the fluid along its own path
/// [m/s^2], dv/dt that of the particle.
/// Sign: along the fluid's acceleration relative to the particle's.
/// Model: the same in A and B; the fluid gets -F_vm, which holds the -m_a dv/dt.
/// Validity: sphere alone; at finite Re as well (J. Magnaudet, M. Rivero, J. Fabre, J. Fluid Mech.
/// 284 (1995) 97). For metal in gas m_a/m is 1e-4.
/// Source: T.R. Auton, J.C.R. Hunt, M. Prud'homme, J. Fluid Mech. 197 (1988) 241 (D/Dt, not the d/dt
/// along the particle).
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp, foam_cases/added_mass
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(virtual_mass, VirtualMass)
#else
#ifndef POWDERLINK_FORCES_LAWS_VIRTUAL_MASS_H
#define POWDERLINK_FORCES_LAWS_VIRTUAL_MASS_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class VirtualMass : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"virtual_mass",
                             ForceKind::inertia,
                             "F = C rho_f V (Du/Dt - dv/dt), C = 1/2",
                             "single sphere",
                             "Auton, Hunt and Prud'homme 1988",
                             {"acceleration_m_s2"},
                             true};
    return i;
  }

  explicit VirtualMass(const ForceSettings& s) : coefficient_(s.virtual_mass_coefficient) {
    if (!(coefficient_ >= 0.0 && std::isfinite(coefficient_))) {
      throw InvalidInput("force virtual_mass: virtual_mass_coefficient", number_text(coefficient_),
                         ">= 0 and finite", "0.5 is a sphere");
    }
  }

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    t.added_mass_kg = coefficient_ * f.density_kg_m3 * volume_m3(p);
    t.force_N = scaled(t.added_mass_kg, f.acceleration_m_s2);
    return t;
  }

 private:
  double coefficient_;
};

}  // namespace powderlink::forces
#endif
#endif
