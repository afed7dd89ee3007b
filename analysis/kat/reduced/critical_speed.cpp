// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/reduced/critical_speed.h"

#include <algorithm>
#include <cmath>

#include "analysis/kat/reduced/universal_tables.h"
#include "physics/effects/laws/rate_dependent_adhesion.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

using physics::StopPulse;

CriticalSpeed::CriticalSpeed(const ReducedModel& model, bool estimates) : model_(model) {
  const KatSetup& setup = model.setup();
  if (setup.restitution != 1.0 || setup.work_of_adhesion_J_m2 <= 0.0) return;
  int moving_edges = 0;
  for (const auto& e : setup.effects) {
    if (!e->rate_dependent()) continue;
    ++moving_edges;
    edge_ = dynamic_cast<const physics::RateDependentAdhesion*>(e.get());
  }
  const StopPulse::Shape shape = setup.stop.shape();
  const bool instant = shape == StopPulse::Shape::instant;
  if ((!instant && shape != StopPulse::Shape::half_sine && shape != StopPulse::Shape::hertz) ||
      moving_edges > 1 || (moving_edges == 1 && edge_ == nullptr)) {
    return;
  }
  const bool gap = model.gap_forces();
  if (instant && edge_ == nullptr)
    kind_ = Kind::instant;
  else if (edge_ == nullptr && !gap)
    kind_ = Kind::slow_pulse;
  else if (instant && !gap)
    kind_ = Kind::moving_edge;
  else if (estimates)
    kind_ = Kind::estimate;
}

double CriticalSpeed::edge_factor(double diameter_m, double time_s) const {
  const double radius = 0.5 * diameter_m;
  const double a0 = model_.law(radius).equilibrium_contact_radius_m(radius);
  return moving_edge_factor(edge_->v_star_m_s() * time_s / a0, edge_->exponent());
}

double CriticalSpeed::speed_change_m_s(double diameter_m) const {
  const StopPulse& stop = model_.setup().stop;
  const bool instant = stop.shape() == StopPulse::Shape::instant;
  // The weight adds to the load of a slow stop: it is counted there, below.
  const ReducedModel::AtRest rest =
      model_.at_rest(diameter_m, instant ? model_.setup().gravity_m_s2 : 0.0);
  if (kind_ == Kind::instant || !rest.held) return rest.escape_speed_m_s;
  double contact = rest.contact_speed_m_s;
  if (edge_ != nullptr)  // a slow stop opens the edge slowly
    contact *= edge_factor(diameter_m, std::max(rest.period_s, stop.duration_s()));
  const double across = std::sqrt(
      std::max(0.0, std::pow(rest.escape_speed_m_s, 2) - std::pow(rest.contact_speed_m_s, 2)));
  if (instant) return std::hypot(contact, across);
  const double peak_of_unit_speed = stop.peak_deceleration_m_s2(1.0) / stop.speed_change_m_s(1.0);
  const double mass =
      physics::sphere_mass_kg(0.5 * diameter_m, model_.setup().particle.density_kg_m3);
  const double held_by_gap = rest.gap_force_N / (mass * peak_of_unit_speed);
  return std::max(0.0, contact * slowness_factor(stop.shape(), stop.duration_s() / rest.period_s) +
                           std::hypot(across, held_by_gap) -
                           model_.setup().gravity_m_s2 / peak_of_unit_speed);
}

}  // namespace powderlink::analysis
