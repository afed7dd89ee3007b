// SPDX-License-Identifier: GPL-3.0-or-later
/// \file viscous_stress.h
/// The viscous stress of the undisturbed flow acts on the particle's volume.
///
///   F = V div tau,   tau = mu (grad u + (grad u)^T - 2/3 (div u) 1)
///
/// Symbols: V = pi d^3/6 [m^3], tau viscous stress [Pa], mu viscosity [Pa s], u velocity of the fluid
/// [m/s].
/// Sign: that of div tau, the force of the neighbouring fluid on the volume.
/// Model: A. In B the stress is in the fluid only: F = 0. The fluid gets no reaction, see force.h.
/// Validity: div tau even over the particle. With `pressure_gradient` this is the force
/// rho_f V (Du/Dt - g) that the fluid in the particle's place would feel, without its buoyancy.
/// Source: Z.Y. Zhou, S.B. Kuang, K.W. Chu, A.B. Yu, J. Fluid Mech. 661 (2010) 482, set II.
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(viscous_stress, ViscousStress)
#else
#ifndef POWDERLINK_FORCES_LAWS_VISCOUS_STRESS_H
#define POWDERLINK_FORCES_LAWS_VISCOUS_STRESS_H

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class ViscousStress : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"viscous_stress",
                             ForceKind::pressure,
                             "F = V div tau; zero in model B",
                             "stress divergence even over the particle",
                             "Zhou et al. 2010",
                             {"viscous_stress_divergence_N_m3"},
                             false};
    return i;
  }

  explicit ViscousStress(const ForceSettings& s) : model_(s.model) {}

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    if (model_ == MomentumModel::A) {
      t.force_N = scaled(volume_m3(p), f.viscous_stress_divergence_N_m3);
    }
    return t;
  }

 private:
  MomentumModel model_;
};

}  // namespace powderlink::forces
#endif
#endif
