// SPDX-License-Identifier: GPL-3.0-or-later
/// \file pressure_gradient.h
/// The pressure gradient of the undisturbed flow acts on the particle's volume.
///
///   F = -V grad p
///
/// Symbols: V = pi d^3/6 [m^3], p dynamic pressure, without the hydrostatic part [Pa].
/// Sign: towards lower pressure.
/// Model: A. In B the pressure is in the fluid only, the drag carries its share (force.h): F = 0.
/// The fluid gets no reaction: its own term is -alpha_f grad p.
/// Validity: grad p even over the particle. The hydrostatic part belongs to `buoyancy`, so that nothing
/// is counted twice.
/// Source: C.T. Crowe et al., Multiphase Flows with Droplets and Particles, 2nd ed. (2012),
/// Chapter 4; Z.Y. Zhou, S.B. Kuang, K.W. Chu, A.B. Yu, J. Fluid Mech. 661 (2010) 482, set II.
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
///        tests/physics/fluid_forces/packed_bed_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(pressure_gradient, PressureGradient)
#else
#ifndef POWDERLINK_FORCES_LAWS_PRESSURE_GRADIENT_H
#define POWDERLINK_FORCES_LAWS_PRESSURE_GRADIENT_H

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class PressureGradient : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"pressure_gradient",
                             ForceKind::pressure,
                             "F = -V grad p (dynamic pressure); zero in model B",
                             "gradient even over the particle",
                             "Crowe et al. 2012",
                             {"pressure_gradient_Pa_m"},
                             false};
    return i;
  }

  explicit PressureGradient(const ForceSettings& s) : model_(s.model) {}

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    if (model_ == MomentumModel::A) t.force_N = scaled(-volume_m3(p), f.pressure_gradient_Pa_m);
    return t;
  }

 private:
  MomentumModel model_;
};

}  // namespace powderlink::forces
#endif
#endif
