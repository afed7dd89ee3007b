// SPDX-License-Identifier: GPL-3.0-or-later
/// \file critical_diameter.h
/// The critical diameter d_c of the Kinetic Adhesion Test: everything larger leaves the plate.
///
/// reduced model   bracketed from the closed form outwards, then bisected on log d
/// quick           from the critical speed (critical_speed.h), to 1e-3
/// closed forms    instant stop (Eq. 4.5) and slow stop (physics/kat/kat_theory.h)
/// Units: m, m/s. Searched between 0.1 um and 1 mm; outside, the state says which end was reached.
/// Tests: tests/analysis/kat/critical_diameter_test.cpp
#pragma once

#include <string>

#include "analysis/kat/reduced/reduced_model.h"

namespace powderlink::analysis {

inline constexpr double kSmallestDiameter_m = 1e-7;
inline constexpr double kLargestDiameter_m = 1e-3;

struct CriticalDiameter {
  enum class State { found, nothing_detaches, everything_detaches };
  State state = State::found;
  double diameter_m = 0.0;  ///< middle of the bracket, or the end of the range that was reached
  double largest_attached_m = 0.0;
  double smallest_detached_m = 0.0;
  int drops = 0;  ///< particles that were simulated

  bool found() const { return state == State::found; }
  /// For tables: "46.03", "> 1000 (nothing detaches)" [um].
  std::string text_um() const;
};

CriticalDiameter critical_diameter(const ReducedModel& model, double impact_velocity_m_s,
                                   double relative_tolerance = 1e-4);

/// As critical_diameter(), but without following the particle's motion where critical_speed.h knows
/// better: what fits call thousands of times. The bracket then has no width.
/// \param estimates  of critical_speed.h, for sums of effects
CriticalDiameter quick_critical_diameter(const ReducedModel& model, double impact_velocity_m_s,
                                         bool estimates = false);

/// Closed form of the limit that the stop is in, for smooth surfaces without other effects.
struct TheoryDiameter {
  double diameter_m = 0.0;
  const char* limit = "";  ///< "instant stop" or "slow stop"
};
TheoryDiameter theory_diameter(const ReducedModel& model, double impact_velocity_m_s);

}  // namespace powderlink::analysis
