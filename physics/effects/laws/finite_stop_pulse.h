// SPDX-License-Identifier: GPL-3.0-or-later
/// \file finite_stop_pulse.h
/// The plate stops over a time tau, not at once.
///
///   A(t) = pi v (1 + e_p)/(2 tau) sin(pi t/tau)
///   slow limit (tau much longer than the contact's period): m A_max = 1.5 pi Gamma R,
///   so d_c ~ v^(-1/2)
///
/// Symbols: A deceleration of the plate [m/s^2], v impact speed [m/s], tau contact time of carrier and
/// anvil [s], e_p rebound of the plate [-]; m, R mass [kg] and radius [m] of the grain, Gamma work of
/// adhesion [J/m^2]. Sign: A > 0 slows the plate.
/// Validity: stiff plate; any ratio of tau to the contact's period.
/// Source: thesis of L. Pedrolli, Section 4.3 (contact times of 50-200 us on the device).
/// Tests: tests/physics/effects_test.cpp, tests/analysis/kat/reduced_model_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(finite_stop_pulse, FiniteStopPulse)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_FINITE_STOP_PULSE_H
#define POWDERLINK_PHYSICS_EFFECTS_FINITE_STOP_PULSE_H

#include "physics/effects/effect.h"

namespace powderlink::physics {

class FiniteStopPulse : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "finite_stop_pulse",
        "the plate stops over a time tau (half-sine), with rebound e_p",
        "slope near -1/2; needs a Gamma 100-1000 times below the instant stop's",
        {{"tau_s", 0.0, 1e-4, 1e-7, 1e-2, 5e-5, 2e-4, "device: carrier-anvil contact of 50-200 us"},
         {"plate_restitution", 0.0, 0.0, 0.0, 1.0, 0.0, 0.9, "elastic limit 1"}},
        "measure the contact time of carrier and anvil, and change it (softer or stiffer anvil): "
        "d_c must follow its square root"};
    return i;
  }

  explicit FiniteStopPulse(const std::vector<double>& p) {
    for (std::size_t i = 0; i < 2; ++i) require_range(info(), i, p.at(i));
    pulse_ = p[0] > 0.0 ? StopPulse::half_sine(p[0], p[1]) : StopPulse::instant(p[1]);
  }

  std::optional<StopPulse> stop() const override { return pulse_; }

 private:
  StopPulse pulse_;
};

}  // namespace powderlink::physics
#endif
#endif
