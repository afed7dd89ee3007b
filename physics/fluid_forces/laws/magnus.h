// SPDX-License-Identifier: GPL-3.0-or-later
/// \file magnus.h
/// Lift on a sphere that spins relative to the fluid.
///
///   F    = (pi/8) rho d^2 C_LR |u - v| (Omega x (u - v))/|Omega|,   Omega = curl u/2 - omega
///   C_LR = 0.45 + (Re_r/Re - 0.45) exp(-0.05684 Re_r^0.4 Re^0.3)
///   Re   = Re_p = alpha_f d |u - v| / nu,   Re_r = rho |Omega| d^2/mu
///
/// For Re, Re_r -> 0, alpha_f = 1: F = (pi/8) rho d^3 Omega x (u - v), Rubinow and Keller's.
/// Symbols: omega spin of the particle [rad/s], C_LR lift coefficient [-]; else as in
/// schiller_naumann.h.
/// Sign: a particle with spin omega and velocity v in fluid at rest feels F along omega x v.
/// Model: the same in A and B; the fluid gets -F.
/// Validity: Re < 140 and Re_r/(2 Re) < 6 (data of the source 10 < Re < 140); often used to 2000.
/// Source: B. Oesterle, T. Bui Dinh, Exp. Fluids 25 (1998) 16, with gamma = d |Omega|/(2 |u - v|):
///   C_LR = 0.45 + (2 gamma - 0.45) exp(-0.075 gamma^0.4 Re^0.7)
/// in Re_r as in C.T. Crowe et al., Multiphase Flows with Droplets and Particles, 2nd ed. (2012),
/// Chapter 4; limit: S.I. Rubinow, J.B. Keller, J. Fluid Mech. 11 (1961) 447.
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(magnus, Magnus)
#else
#ifndef POWDERLINK_FORCES_LAWS_MAGNUS_H
#define POWDERLINK_FORCES_LAWS_MAGNUS_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class Magnus : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{"magnus",
                             ForceKind::lift,
                             "F = (pi/8) rho d^2 C_LR |u - v| Omega x (u - v)/|Omega|",
                             "sphere, Re < 140, |Omega| d / (2 |u - v|) < 6",
                             "Oesterle and Bui Dinh 1998; Rubinow and Keller 1961",
                             {"velocity_curl_1_s"},
                             true};
    return i;
  }

  explicit Magnus(const ForceSettings&) {}

  static double lift_coefficient(double reynolds, double rotation_reynolds) {
    return 0.45 +
           (rotation_reynolds / reynolds - 0.45) *
               std::exp(-0.05684 * std::pow(rotation_reynolds, 0.4) * std::pow(reynolds, 0.3));
  }

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    const double reynolds = particle_reynolds(f, p);
    const double rotation = rotation_reynolds(f, p);
    if (!(reynolds > 0.0 && rotation > 0.0)) return t;
    const Vec3 slip = slip_velocity_m_s(f, p);
    const Vec3 spin = slip_spin_rad_s(f, p);
    t.force_N = scaled(kPi / 8.0 * f.density_kg_m3 * p.diameter_m * p.diameter_m *
                           lift_coefficient(reynolds, rotation) * norm(slip) / norm(spin),
                       cross(spin, slip));
    return t;
  }
};

}  // namespace powderlink::forces
#endif
#endif
