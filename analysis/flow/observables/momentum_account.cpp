// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/momentum_account.h"

#include <algorithm>
#include <cmath>

namespace powderlink::analysis {

/// Positions are on the axis, velocities downstream; linear in place between the states.
double MomentumAccount::crossing_m_s(const Grain& before, const Grain& after) const {
  const Grain& outside = holds(before) ? after : before;
  const double end = outside.place_m < part_m_.from ? part_m_.from : part_m_.to;
  const double part = (end - before.place_m) / (after.place_m - before.place_m);
  return before.velocity_m_s + part * (after.velocity_m_s - before.velocity_m_s);
}

void MomentumAccount::add(double time_s, const DumpState& state) {
  std::unordered_map<long, Grain> now;
  now.reserve(state.particles.size());
  double momentum = 0.0;
  for (const DumpParticle& p : state.particles) {
    const Grain grain{axis_.place_m(place_of(p)), axis_.velocity_m_s(p), p.mass_kg};
    now.emplace(p.id, grain);
    const bool inside = holds(grain);
    if (inside) {
      momentum += grain.mass_kg * grain.velocity_m_s;
      mass_sum_ += grain.mass_kg;
    }
    if (states_ == 0) continue;
    const auto at = before_.find(p.id);
    // LIGGGHTS may give the id of a grain that has left to a new one.
    const bool known = at != before_.end() && at->second.mass_kg == grain.mass_kg;
    if (!known) {
      if (inside) entered_ += grain.mass_kg * grain.velocity_m_s;
      continue;
    }
    longest_step_ = std::max(
        longest_step_, std::abs(grain.place_m - at->second.place_m) / (part_m_.to - part_m_.from));
    const bool was_inside = holds(at->second);
    if (inside != was_inside) {
      (inside ? entered_ : left_) += grain.mass_kg * crossing_m_s(at->second, grain);
    }
    before_.erase(at);
  }
  // Those that are left have vanished.
  for (const auto& [id, grain] : before_) {
    if (holds(grain)) left_ += grain.mass_kg * grain.velocity_m_s;
  }
  if (states_ == 0) {
    first_s_ = time_s;
    first_ = momentum;
  }
  last_s_ = time_s;
  last_ = momentum;
  ++states_;
  before_ = std::move(now);
}

double MomentumAccount::mean_mass_kg() const {
  return states_ == 0 ? 0.0 : mass_sum_ / static_cast<double>(states_);
}

}  // namespace powderlink::analysis
