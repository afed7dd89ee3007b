// SPDX-License-Identifier: GPL-3.0-or-later
/// \file rebound_time.h
/// Gamma from a detachment that lasts half a Hertzian rebound:
///
///   Gamma = 8/9 rho R_c^2 v/t_d,  t_d = t_r/2,  t_r = 2.865 (m^2/(R E*^2 v))^(1/5)
///
/// Symbols: t_r duration of a rebound of the grain at v [s], m its mass [kg], E* effective modulus
/// [Pa], others as in energy.h. The mean deceleration v/t_d acts on m and meets the pull-off force.
/// Validity: an estimate; the plate is taken to stop as fast as the grain itself would rebound.
/// Source: thesis of L. Pedrolli, Eqs. 2.4 (with E*^2, see docs/theory.md) and 4.10.
/// Tests: tests/analysis/kat/gamma_methods_test.cpp
#ifdef POWDERLINK_GAMMA_METHOD
POWDERLINK_GAMMA_METHOD(ReboundTime)
#else
#ifndef POWDERLINK_ANALYSIS_LABORATORY_METHODS_REBOUND_TIME_H
#define POWDERLINK_ANALYSIS_LABORATORY_METHODS_REBOUND_TIME_H

#include <fmt/format.h>

#include "analysis/kat/experiment/gamma_method.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

struct ReboundTime {
  static const GammaMethodInfo& info() {
    static const GammaMethodInfo i{
        "rebound_time",
        "rebound time",
        "Gamma = 8/9 rho R_c^2 v/t_d, t_d = 2.865/2 (m^2/(R_c E*^2 v))^(1/5)",
        "the grain is pulled off within half the time of its own Hertzian rebound",
        "an estimate of the order of the energy method",
        "Pedrolli, Eqs. 2.4 and 4.10",
        ""};
    return i;
  }

  static double gamma_J_m2(const KatDrop& d) {
    return physics::adhesive_energy_rebound_J_m2(d.modulus_Pa(), d.particle.density_kg_m3,
                                                 d.impact_velocity_m_s, d.critical_diameter_m);
  }

  static std::optional<GammaEstimate> estimate(const UncertainDrop& drop) {
    GammaEstimate e = propagated(drop, gamma_J_m2);
    const KatDrop& d = drop.best;
    e.note = fmt::format("rebound of {:.4g} ns",
                         1e9 * physics::rebound_time_s(d.modulus_Pa(), d.particle.density_kg_m3,
                                                       d.radius_m(), d.impact_velocity_m_s));
    return e;
  }
};

}  // namespace powderlink::analysis
#endif
#endif
