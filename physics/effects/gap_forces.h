// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gap_forces.h
/// Sum of the attractions that act across the gap beside the contact, and whether they let go.
///
///   let go:  m u^2/2 + U(h) - m g h  >=  max over h' > h of (U(h') - m g h'),  u > 0
///
/// Symbols: h gap [m] between sphere and plate, negative while they overlap; R radius [m]; u speed
/// away from the plate [m/s]; U potential of the attractions [J]; m g weight, pulling away [N].
/// Sign: forces and potentials of attractions are 0 or negative.
/// A bridge is an attraction that a touch must form (Effect::formed_by_touch).
/// Validity: each attraction only falls with the gap.
/// Source: energy conservation; the laws are those of physics/effects/laws/.
/// Tests: tests/analysis/kat/reduced_model_test.cpp, tests/liggghts_styles/kat_drop_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class GapForces {
 public:
  GapForces() = default;
  /// Keeps the effects that attract; not owned, must outlive this object.
  explicit GapForces(const std::vector<const Effect*>& effects) {
    constexpr double any_radius_m = 1e-5;
    for (const Effect* e : effects) {
      if (e->range_m(any_radius_m) > 0.0) effects_.push_back(e);
    }
  }

  bool none() const { return effects_.empty(); }

  /// 0 or negative [N].
  double force_N(double gap_m, double radius_m, bool bridged = true) const {
    return sum(bridged, [&](const Effect& e) { return e.gap_force_N(gap_m, radius_m); });
  }
  /// 0 or negative [J].
  double energy_J(double gap_m, double radius_m, bool bridged = true) const {
    return sum(bridged, [&](const Effect& e) { return e.gap_energy_J(gap_m, radius_m); });
  }
  /// Of the longest; may be infinite.
  double range_m(double radius_m, bool bridged = true) const {
    double range = 0.0;
    sum(bridged, [&](const Effect& e) {
      range = std::max(range, e.range_m(radius_m));
      return 0.0;
    });
    return range;
  }
  /// Gap at which the longest bridge ruptures [m]; 0 without bridges.
  double bridge_range_m(double radius_m) const {
    double range = 0.0;
    for (const Effect* e : effects_) {
      if (e->formed_by_touch()) range = std::max(range, e->range_m(radius_m));
    }
    return range;
  }

  /// True when a free sphere that moves away is never turned back, its weight being the only push.
  bool let_go(double gap_m, double radius_m, double mass_kg, double speed_m_s, double weight_N,
              bool bridged = true) const {
    if (speed_m_s < 0.0) return false;
    return 0.5 * mass_kg * speed_m_s * speed_m_s >= climb_J(gap_m, radius_m, weight_N, bridged);
  }

  /// Work that a free sphere must have to get away from the gap it is at [J]; never negative.
  double climb_J(double gap_m, double radius_m, double weight_N, bool bridged = true) const {
    const double range = range_m(radius_m, bridged);
    const auto push = [&](double gap) { return force_N(gap, radius_m, bridged) + weight_N; };
    if (gap_m >= range || push(gap_m) >= 0.0) return 0.0;
    // The top of the potential: where the weight balances the attraction, or where that ends.
    double top = range;
    if (weight_N > 0.0) {
      if (!std::isfinite(range)) {
        top = gap_m + radius_m;
        while (push(top) < 0.0) top *= 2.0;
      }
      if (push(top) > 0.0) {
        constexpr int bits = 30;
        const boost::math::tools::eps_tolerance<double> tolerance(bits);
        top = boost::math::tools::bisect(push, gap_m, top, tolerance).second;
      }
    }
    double climb = -energy_J(gap_m, radius_m, bridged);
    if (std::isfinite(top)) climb += energy_J(top, radius_m, bridged) - weight_N * (top - gap_m);
    return climb;
  }

 private:
  template <class Law>
  double sum(bool bridged, const Law& law) const {
    double total = 0.0;
    for (const Effect* e : effects_) {
      if (bridged || !e->formed_by_touch()) total += law(*e);
    }
    return total;
  }

  std::vector<const Effect*> effects_;
};

}  // namespace powderlink::physics
