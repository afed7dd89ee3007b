// SPDX-License-Identifier: GPL-3.0-or-later
/// \file finite_stop.h
/// Gamma from the measured time of contact of carrier and anvil: a half-sine stop of that duration,
///
///   A(t) = pi v (1 + e_p)/(2 tau) sin(pi t/tau),   d_c(Gamma, tau, v) = d_c measured,
///
/// solved for Gamma with the reduced model (critical_speed.h), so that `compare` and `diagnose` with
/// finite_stop_pulse say the same.
/// Limits: tau much longer than the contact's period: Gamma = 8/9 rho R_c^2 A_max (slow stop);
/// tau much shorter: Eq. 4.5 with v (1 + e_p).
/// Symbols: tau contact time [s], e_p rebound of the plate [-], others as in energy.h.
/// Validity: JKR; the plate is stiff and the pulse a half-sine (within 15 % of Gamma for others of the
/// same duration: a Hertzian one has 1.14 times its peak).
/// Source: thesis of L. Pedrolli, Section 4.3. Tests: tests/analysis/kat/gamma_methods_test.cpp
#ifdef POWDERLINK_GAMMA_METHOD
POWDERLINK_GAMMA_METHOD(FiniteStop)
#else
#ifndef POWDERLINK_ANALYSIS_LABORATORY_METHODS_FINITE_STOP_H
#define POWDERLINK_ANALYSIS_LABORATORY_METHODS_FINITE_STOP_H

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "analysis/kat/experiment/gamma_method.h"
#include "analysis/kat/reduced/critical_speed.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

struct FiniteStop {
  static const GammaMethodInfo& info() {
    static const GammaMethodInfo i{
        "finite_stop",
        "finite stop",
        "d_c(Gamma, half-sine of duration tau and rebound e_p, v) = d_c, reduced model",
        "the plate stops as a half-sine within the measured contact time",
        "JKR; pulses of other shapes change Gamma by about 15 %",
        "Pedrolli, Section 4.3; slow limit m A = 1.5 pi Gamma R",
        "--contact-time-us"};
    return i;
  }

  static double gamma_J_m2(const KatDrop& d) {
    constexpr double tolerance = 1e-9;
    constexpr double stride = 2.0;
    const auto pulse = physics::StopPulse::half_sine(*d.contact_time_s, d.plate_rebound);
    const double density = d.particle.density_kg_m3;
    const auto excess = [&](double gamma) {
      KatSetup setup;
      setup.particle = d.particle;
      setup.substrate = d.substrate;
      setup.work_of_adhesion_J_m2 = gamma;
      setup.stop = pulse;
      const ReducedModel model(setup);
      return CriticalSpeed(model).speed_change_m_s(d.critical_diameter_m) -
             pulse.speed_change_m_s(d.impact_velocity_m_s);
    };
    // No stop is more violent than the instant one.
    const double slow = physics::adhesive_energy_slow_J_m2(
        density, pulse.peak_deceleration_m_s2(d.impact_velocity_m_s), d.critical_diameter_m);
    const double instant = physics::adhesive_energy_instant_J_m2(
        d.modulus_Pa(), density, pulse.speed_change_m_s(d.impact_velocity_m_s),
        d.critical_diameter_m);
    std::uintmax_t turns = 200;
    const auto root = boost::math::tools::bracket_and_solve_root(
        excess, std::min(slow, instant), stride, true,
        [](double a, double b) { return std::fabs(a - b) <= tolerance * std::fabs(a); }, turns);
    return 0.5 * (root.first + root.second);
  }

  static std::optional<GammaEstimate> estimate(const UncertainDrop& drop) {
    if (!drop.best.contact_time_s) return std::nullopt;
    GammaEstimate e = propagated(drop, gamma_J_m2);
    const double period = contact_period_s(drop.best, e.value);
    e.note = fmt::format("{:.4g} us are {:.3g} periods of the contact",
                         1e6 * *drop.best.contact_time_s, *drop.best.contact_time_s / period);
    return e;
  }
};

}  // namespace powderlink::analysis
#endif
#endif
