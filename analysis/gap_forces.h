// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gap_forces.h
/// Sum of the attractions that act across the gap beside the contact, and whether they let go.
///
/// Symbols: gap h [m] between sphere and plate, negative while they overlap; R radius [m].
/// Validity: each attraction only falls with the gap. Hooks: models/effect.h.
/// Tests: tests/analysis/reduced_model_test.cpp
#pragma once

#include <vector>

#include "models/effect.h"

namespace powderlink::analysis {

class GapForces {
 public:
  GapForces() = default;
  /// Keeps the effects that attract; not owned, must outlive this object.
  explicit GapForces(const std::vector<const models::Effect*>& effects);

  bool none() const { return effects_.empty(); }
  double force_N(double gap_m, double radius_m) const;   ///< 0 or negative
  double energy_J(double gap_m, double radius_m) const;  ///< 0 or negative
  double range_m(double radius_m) const;                 ///< of the longest; may be infinite

  /// True when a free sphere that moves away is never turned back, with its weight [N] as the only
  /// push: m u^2/2 + U(h) - m g h is above its highest value further out.
  bool let_go(double gap_m, double radius_m, double mass_kg, double speed_m_s,
              double weight_N) const;

 private:
  std::vector<const models::Effect*> effects_;
};

}  // namespace powderlink::analysis
