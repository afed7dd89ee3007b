// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/critical_speed.h"

#include <algorithm>
#include <cmath>

#include "analysis/universal_tables.h"
#include "models/effects/rate_dependent_adhesion.h"

namespace powderlink::analysis {

using models::StopPulse;

CriticalSpeed::CriticalSpeed(const ReducedModel& model) : model_(model) {
  const KatSetup& setup = model.setup();
  if (setup.restitution != 1.0 || setup.work_of_adhesion_J_m2 <= 0.0) return;
  const StopPulse::Shape shape = setup.stop.shape();
  if (!model.rate_dependent()) {
    if (shape == StopPulse::Shape::instant) kind_ = Kind::instant;
    if ((shape == StopPulse::Shape::half_sine || shape == StopPulse::Shape::hertz) &&
        !model.gap_forces()) {
      kind_ = Kind::slow_pulse;
    }
    return;
  }
  if (shape != StopPulse::Shape::instant || model.gap_forces()) return;
  int moving_edges = 0;
  for (const auto& e : setup.effects) {
    if (!e->rate_dependent()) continue;
    ++moving_edges;
    edge_ = dynamic_cast<const models::RateDependentAdhesion*>(e.get());
  }
  if (moving_edges == 1 && edge_ != nullptr) kind_ = Kind::moving_edge;
}

double CriticalSpeed::speed_change_m_s(double diameter_m) const {
  const double escape = model_.escape_speed_m_s(diameter_m);
  if (kind_ == Kind::instant || escape == 0.0) return escape;
  const double period = model_.contact_period_s(diameter_m);
  if (kind_ == Kind::moving_edge) {
    const double radius = 0.5 * diameter_m;
    const double a0 = model_.law(radius).equilibrium_contact_radius_m(radius);
    return escape * moving_edge_factor(edge_->v_star_m_s() * period / a0, edge_->exponent());
  }
  const StopPulse& stop = model_.setup().stop;
  // Gravity helps the peak load of a slow stop; to an instant one it makes no difference.
  const double peak_of_unit_speed = stop.peak_deceleration_m_s2(1.0) / stop.speed_change_m_s(1.0);
  return std::max(0.0, escape * slowness_factor(stop.shape(), stop.duration_s() / period) -
                           model_.setup().gravity_m_s2 / peak_of_unit_speed);
}

}  // namespace powderlink::analysis
