// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/gap_forces.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace powderlink::analysis {

GapForces::GapForces(const std::vector<const models::Effect*>& effects) {
  constexpr double any_radius_m = 1e-5;
  for (const models::Effect* e : effects) {
    if (e->range_m(any_radius_m) > 0.0) effects_.push_back(e);
  }
}

double GapForces::force_N(double gap_m, double radius_m) const {
  double force = 0.0;
  for (const models::Effect* e : effects_) force += e->gap_force_N(gap_m, radius_m);
  return force;
}

double GapForces::energy_J(double gap_m, double radius_m) const {
  double energy = 0.0;
  for (const models::Effect* e : effects_) energy += e->gap_energy_J(gap_m, radius_m);
  return energy;
}

double GapForces::range_m(double radius_m) const {
  double range = 0.0;
  for (const models::Effect* e : effects_) range = std::max(range, e->range_m(radius_m));
  return range;
}

bool GapForces::let_go(double gap_m, double radius_m, double mass_kg, double speed_m_s,
                       double weight_N) const {
  if (speed_m_s < 0.0) return false;
  const double range = range_m(radius_m);
  const auto push = [&](double gap) { return force_N(gap, radius_m) + weight_N; };
  if (gap_m >= range || push(gap_m) >= 0.0) return true;
  // The top of the potential: where the weight balances the attraction, or where that ends.
  double top = range;
  if (weight_N > 0.0) {
    if (!std::isfinite(range)) {
      top = gap_m + radius_m;
      while (push(top) < 0.0) top *= 2.0;
    }
    if (push(top) > 0.0) {
      constexpr int bits = 30;
      top = boost::math::tools::bisect(push, gap_m, top,
                                       boost::math::tools::eps_tolerance<double>(bits))
                .second;
    }
  }
  const double climb =
      (std::isfinite(top) ? energy_J(top, radius_m) - weight_N * (top - gap_m) : 0.0) -
      energy_J(gap_m, radius_m);
  return 0.5 * mass_kg * speed_m_s * speed_m_s >= climb;
}

}  // namespace powderlink::analysis
