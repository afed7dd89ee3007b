// SPDX-License-Identifier: GPL-3.0-or-later
/// \file critical_speed.h
/// The stop that just takes a sphere off, without following its motion; many times faster than
/// ReducedModel::drop() and as good as the fits need.
///
///   instant stop            v_c = v_esc(d)               by energy, exact without damping
///   half-sine, Hertz stop   v_c = v_esc g(tau/T)         no forces across the gap; gravity by peak load
///   moving edge             v_c = v_esc h(v* T/a0, n)    instant stop, rate_dependent_adhesion, no
///                                                        forces across the gap
///
/// Two effects at once have no such shortcut. With `estimates` their works and forces are added, to
/// some per cent: for the search over pairs, where integration would take minutes.
///
/// JKR has one scale each of length, force and time, so that g and h are the same for all materials,
/// Gamma and sizes. They are tabulated from the reduced model itself at first use.
/// Symbols: v_c speed change of the plate, v (1 + e_p) [m/s], v_esc that of an instant stop; T period
/// of the contact at rest [s]; a0 contact radius at rest [m]; v*, n of
/// physics/effects/laws/rate_dependent_adhesion.h.
/// Validity: restitution 1; everything else is not `available` and needs the integration.
/// Accuracy: 1e-3 of d_c. Tests: tests/analysis/kat/critical_speed_test.cpp
#pragma once

#include "analysis/kat/reduced/reduced_model.h"

namespace powderlink::physics {
class RateDependentAdhesion;
}

namespace powderlink::analysis {

class CriticalSpeed {
 public:
  /// \param model  not owned, must outlive this object
  /// \param estimates  take sums of effects where nothing better is there
  explicit CriticalSpeed(const ReducedModel& model, bool estimates = false);

  bool available() const { return kind_ != Kind::none; }
  /// Speed change [m/s]; 0 when the weight suffices.
  double speed_change_m_s(double diameter_m) const;

 private:
  double edge_factor(double diameter_m, double time_s) const;

  enum class Kind { none, instant, slow_pulse, moving_edge, estimate };

  const ReducedModel& model_;
  Kind kind_ = Kind::none;
  const physics::RateDependentAdhesion* edge_ = nullptr;
};

}  // namespace powderlink::analysis
