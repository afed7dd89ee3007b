// SPDX-License-Identifier: GPL-3.0-or-later
/// \file energy.h
/// Gamma from the energy of an instant stop:
///
///   1/2 m v^2 = W(C->D):  Gamma = v^(6/5) R_c (8 K^2 rho^3/(3^5 pi^2 1.0107^3))^(1/5)
///
/// Symbols: v impact velocity [m/s], R_c = d_c/2 [m], K = 4/3 E* [Pa], rho density of the grain [kg/m^3].
/// Validity: JKR; the plate stops in much less than the contact's own period (0.1 to 3 us).
/// Source: thesis of L. Pedrolli, Eq. 4.5. Tests: tests/analysis/kat/gamma_methods_test.cpp
#ifdef POWDERLINK_GAMMA_METHOD
POWDERLINK_GAMMA_METHOD(Energy)
#else
#ifndef POWDERLINK_ANALYSIS_LABORATORY_METHODS_ENERGY_H
#define POWDERLINK_ANALYSIS_LABORATORY_METHODS_ENERGY_H

#include <fmt/format.h>

#include "analysis/kat/experiment/gamma_method.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

struct Energy {
  static const GammaMethodInfo& info() {
    static const GammaMethodInfo i{
        "energy",
        "energy",
        "Gamma = v^(6/5) R_c (8 K^2 rho^3/(3^5 pi^2 1.0107^3))^(1/5)",
        "the plate stops at once, from rest of the contact, and nothing is lost",
        "JKR; stop much shorter than the contact's own period",
        "Pedrolli, Eq. 4.5",
        ""};
    return i;
  }

  static double gamma_J_m2(const KatDrop& d) {
    return physics::adhesive_energy_instant_J_m2(d.modulus_Pa(), d.particle.density_kg_m3,
                                                 d.impact_velocity_m_s, d.critical_diameter_m);
  }

  static std::optional<GammaEstimate> estimate(const UncertainDrop& drop) {
    GammaEstimate e = propagated(drop, gamma_J_m2);
    const double period = contact_period_s(drop.best, e.value);
    e.note = fmt::format("contact's period {:.3g} us", 1e6 * period);
    if (drop.best.contact_time_s && *drop.best.contact_time_s > period) {
      e.warnings.push_back(fmt::format(
          "energy: the stop of {:.4g} us is {:.3g} times the contact's own period of {:.3g} us, "
          "so it is not instant and this Gamma is far too high",
          1e6 * *drop.best.contact_time_s, *drop.best.contact_time_s / period, 1e6 * period));
    }
    return e;
  }
};

}  // namespace powderlink::analysis
#endif
#endif
