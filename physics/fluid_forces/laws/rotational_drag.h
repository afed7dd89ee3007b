// SPDX-License-Identifier: GPL-3.0-or-later
/// \file rotational_drag.h
/// Torque on a sphere that spins relative to the fluid.
///
///   T   = (rho/2) (d/2)^5 C_R |Omega| Omega = K_r Omega,   Omega = curl u/2 - omega
///   C_R = 64 pi/Re_r                              Re_r <= 32:  K_r = pi mu d^3
///       = 12.9/sqrt(Re_r) + 128.4/Re_r            Re_r >  32
///   Re_r = rho |Omega| d^2/mu
///
/// as K_r = pi mu d^3 (C_R Re_r/(64 pi)), which has no 0/0 at Omega = 0.
/// Symbols: T torque [N m], omega spin of the particle, Omega that of the fluid against it [rad/s], K_r
/// rotational drag coefficient [N m s], C_R torque coefficient [-]; else as in schiller_naumann.h.
/// Sign: the torque turns the particle along with the fluid; it only dissipates the relative spin.
/// Model: the same in A and B. The fluid gets no momentum from it.
/// Validity: Re_r < 1000, no slip velocity; C_R rises by 0.16 % when Re_r passes 32.
/// Source: S.C.R. Dennis, S.N. Singh, D.B. Ingham, J. Fluid Mech. 101 (1980) 257: 6.45/sqrt(R) +
/// 32.1/R with R = Re_r/4; in Re_r C.T. Crowe et al., Multiphase Flows with Droplets and Particles,
/// 2nd ed. (2012), Chapter 4; Stokes: H. Lamb, Hydrodynamics, Chapter XI (8 pi mu a^3).
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
///        tests/physics/fluid_forces/settling_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(rotational_drag, RotationalDrag)
#else
#ifndef POWDERLINK_FORCES_LAWS_ROTATIONAL_DRAG_H
#define POWDERLINK_FORCES_LAWS_ROTATIONAL_DRAG_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class RotationalDrag : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"rotational_drag",
                             ForceKind::rotation,
                             "T = pi mu d^3 (curl u/2 - omega) up to Re_r 32, Dennis's fit above",
                             "sphere, Re_r < 1000",
                             "Dennis, Singh and Ingham 1980",
                             {"velocity_curl_1_s"},
                             false};
    return i;
  }

  explicit RotationalDrag(const ForceSettings&) {}

  /// Torque over Stokes's.
  static double stokes_factor(double rotation_reynolds) {
    if (rotation_reynolds <= 32.0) return 1.0;
    return (12.9 * std::sqrt(rotation_reynolds) + 128.4) / (64.0 * kPi);
  }

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    t.rotational_drag_Nms = kPi * dynamic_viscosity_Pa_s(f) * p.diameter_m * p.diameter_m *
                            p.diameter_m * stokes_factor(rotation_reynolds(f, p));
    return t;
  }
};

}  // namespace powderlink::forces
#endif
#endif
