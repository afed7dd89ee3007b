// SPDX-License-Identifier: GPL-3.0-or-later
/// \file saffman_mei.h
/// Lift on a sphere in shear.
///
///   F   = rho V C_L (u - v) x curl u
///   C_L = 3/(2 pi sqrt(Re_w)) C'
///   C'  = 6.46 f(Re)                   Re < 40
///       = 6.46 0.0524 sqrt(beta Re)    Re >= 40
///   f   = (1 - 0.3314 sqrt(beta)) exp(-Re/10) + 0.3314 sqrt(beta)
///   beta = Re_w/(2 Re),  Re = Re_p = alpha_f d |u - v| / nu,  Re_w = rho |curl u| d^2/mu
///
/// that is F = 1.615 d^2 sqrt(rho mu/|curl u|) (C'/6.46) (u - v) x curl u: Saffman's for Re -> 0.
/// Symbols: V = pi d^3/6 [m^3], C_L lift coefficient [-], beta shear over slip [-]; else as in
/// schiller_naumann.h.
/// Sign: in u = G y e_x a particle that lags behind the fluid is lifted towards faster fluid (+y).
/// Model: the same in A and B; the fluid gets -F.
/// Validity: Saffman needs Re << sqrt(Re_w) << 1; Mei's fit 0.1 <= Re <= 100, 0.005 <= beta <= 0.4.
/// The two branches do not meet: at Re 40 C' falls by 6.46 exp(-4) (1 - 0.3314 sqrt(beta)), that is
/// 6 % at beta 0.4 and 14 % at 0.1. Spin adds nothing at this order; walls are not in it.
/// Source: P.G. Saffman, J. Fluid Mech. 22 (1965) 385 and 31 (1968) 624 (6.46); R. Mei, Int. J.
/// Multiphase Flow 18 (1992) 145; thesis of L. Pedrolli, Eqs. 2.21-2.27.
/// Tests: tests/physics/fluid_forces/other_forces_test.cpp
#ifdef POWDERLINK_FORCE
POWDERLINK_FORCE(saffman_mei, SaffmanMei)
#else
#ifndef POWDERLINK_FORCES_LAWS_SAFFMAN_MEI_H
#define POWDERLINK_FORCES_LAWS_SAFFMAN_MEI_H

#include <cmath>

#include "physics/fluid_forces/force.h"

namespace powderlink::forces {

class SaffmanMei : public Force {
 public:
  static const ForceInfo& info() {
    static const ForceInfo i{
        "saffman_mei",
        ForceKind::lift,
        "F = 1.615 d^2 sqrt(rho mu/|curl u|) (u - v) x curl u times Mei's factor",
        "sphere far from walls, Re <= 100, 0.005 <= Re_w/(2 Re) <= 0.4",
        "Saffman 1965, 1968; Mei 1992",
        {"velocity_curl_1_s"},
        true};
    return i;
  }

  explicit SaffmanMei(const ForceSettings&) {}

  /// C'/6.46: lift over Saffman's.
  static double mei_factor(double reynolds, double shear_reynolds) {
    const double beta = 0.5 * shear_reynolds / reynolds;
    if (reynolds >= 40.0) return 0.0524 * std::sqrt(beta * reynolds);
    const double alpha = 0.3314 * std::sqrt(beta);
    return (1.0 - alpha) * std::exp(-0.1 * reynolds) + alpha;
  }

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    const double reynolds = particle_reynolds(f, p);
    const double shear = shear_reynolds(f, p);
    if (!(reynolds > 0.0 && shear > 0.0)) return t;
    const double lift = 3.0 * 6.46 / (2.0 * kPi * std::sqrt(shear)) * mei_factor(reynolds, shear);
    t.force_N = scaled(f.density_kg_m3 * volume_m3(p) * lift,
                       cross(slip_velocity_m_s(f, p), f.velocity_curl_1_s));
    return t;
  }
};

}  // namespace powderlink::forces
#endif
#endif
