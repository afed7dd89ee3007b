// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/reduced/reduced_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <utility>

#include "physics/contact/normal_damping.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

using physics::JkrLaw;
using physics::StopPulse;

namespace {

// A sudden stop drives the particle through the whole neck and needs many steps per period; a slow
// one only has to find the moment when the pull-off force is passed. Doubling them changes d_c by
// less than 2e-4. The edge of a rate-dependent contact is of first order in the step: d_c is within
// 5e-3. (tests: reduced_model_test.cpp)
constexpr double kStepsSudden = 200.0;
constexpr double kStepsSuddenRate = 800.0;
constexpr double kStepsSlow = 40.0;
constexpr double kPeriodsOfSuddenStop = 20.0;
constexpr double kFewestSteps = 7.0;  // Verlet is unstable below pi
constexpr double kFewestStepsOfStop = 50.0;
constexpr double kInstantBelow = 1e-3;  // periods: nothing moves during such a stop

// An attached particle that is no longer pushed must have turned this often to end the run.
constexpr int kTurnsAfterStop = 3;
constexpr double kPeriodsAfterStop = 50.0;

}  // namespace

/// What a drop needs to know of its particle.
struct ReducedModel::Sphere {
  double radius_m;
  double mass_kg;
  JkrLaw law;
  double contact_energy_J(double w, double root, bool rate_dependent) const {
    if (root == 0.0) return 0.0;
    if (!rate_dependent) return law.energy_J(root, radius_m);
    // Edge and overlap are independent: flat-punch and Hertz energy, less that of the interface.
    const double a = root * root;
    const double h = a * a / radius_m;
    return law.effective_modulus_Pa() * a * (w * w + 2.0 / 3.0 * w * h + 0.2 * h * h) -
           law.work_of_adhesion_J_m2() * JkrLaw::kPi * a * a;
  }
  /// From dF/d(delta) at the given sqrt(a).
  double period_s(double root) const {
    const double s3 = root * root * root;
    const double c = (s3 * root / radius_m - law.overlap_m(root, radius_m)) / root;
    const double stiffness = law.effective_modulus_Pa() * root * root *
                             (8.0 * s3 / radius_m - 6.0 * c) / (4.0 * s3 / radius_m - c);
    return 2.0 * JkrLaw::kPi * std::sqrt(mass_kg / stiffness);
  }
};

ReducedModel::ReducedModel(KatSetup setup) : setup_(std::move(setup)) {
  setup_.particle.validate();
  setup_.substrate.validate();
  if (!(std::isfinite(setup_.work_of_adhesion_J_m2) && setup_.work_of_adhesion_J_m2 >= 0.0)) {
    throw InvalidInput("adhesive energy",
                       fmt::format("{:g}", setup_.work_of_adhesion_J_m2) + " J/m^2", ">= 0 J/m^2",
                       "give the work of adhesion of the interface");
  }
  if (!(std::isfinite(setup_.gravity_m_s2) && setup_.gravity_m_s2 >= 0.0)) {
    throw InvalidInput("gravity", fmt::format("{:g}", setup_.gravity_m_s2) + " m/s^2", ">= 0 m/s^2",
                       "it pulls the particles off the plate; use 9.81");
  }
  if (setup_.steps_per_period != 0.0 && !(setup_.steps_per_period >= kFewestSteps)) {
    throw InvalidInput("steps per period", fmt::format("{:g}", setup_.steps_per_period),
                       "0 (automatic) or at least 7", "leave it at 0");
  }
  damping_ratio_ = physics::damping_ratio(setup_.restitution);
  smooth_ = JkrLaw(physics::effective_youngs_modulus_Pa(setup_.particle, setup_.substrate),
                   setup_.work_of_adhesion_J_m2);
  std::vector<const physics::Effect*> effects;
  for (const auto& e : setup_.effects) {
    effects.push_back(e.get());
    if (const auto stop = e->stop()) setup_.stop = *stop;
  }
  contact_ = physics::AdhesiveContact(smooth_, effects);
  gap_ = physics::GapForces(effects);
}

double ReducedModel::steps_per_period(double period_s) const {
  if (setup_.steps_per_period > 0.0) return setup_.steps_per_period;
  const double sudden = contact_.rate_dependent() ? kStepsSuddenRate : kStepsSudden;
  if (setup_.stop.shape() == StopPulse::Shape::instant) return sudden;
  const double slowness = setup_.stop.duration_s() / (kPeriodsOfSuddenStop * period_s);
  return std::clamp(sudden / slowness, kStepsSlow, sudden);
}

/// sqrt(a) where contact, gravity and gap forces balance; 0 when nothing holds the particle.
double ReducedModel::equilibrium_root(const Sphere& s, double gravity_m_s2) const {
  const double weight = s.mass_kg * gravity_m_s2;
  const auto away = [&](double root) {
    return s.law.force_N(root, s.radius_m) + weight +
           gap_.force_N(-s.law.overlap_m(root, s.radius_m), s.radius_m);
  };
  // The pull-off under load, where F is least, lies at a = 0.63 a0.
  const double a0 = s.law.equilibrium_contact_radius_m(s.radius_m);
  double low = std::sqrt(std::cbrt(0.25) * a0);
  if (away(low) >= 0.0) return 0.0;
  double high = a0 > 0.0 ? std::sqrt(a0) : std::sqrt(1e-6 * s.radius_m);
  while (away(high) < 0.0) {
    low = high;
    high *= 1.5;
  }
  constexpr int bits = 45;
  boost::uintmax_t turns = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      away, low, high, boost::math::tools::eps_tolerance<double>(bits), turns);
  return 0.5 * (bracket.first + bracket.second);
}

template <bool kGapForces>
DropOutcome ReducedModel::run(const Sphere& s, double impact_velocity) const {
  const StopPulse& stop = setup_.stop;
  const double m = s.mass_kg;
  const double inv_mass = 1.0 / m;
  const double radius = s.radius_m;
  const JkrLaw law = s.law;
  const bool rate_dependent = contact_.rate_dependent();
  DropOutcome out;

  double root = equilibrium_root(s, setup_.gravity_m_s2);
  if (root == 0.0) {  // its weight alone takes it off
    out.detached = true;
    out.speed_m_s = stop.speed_change_m_s(impact_velocity);
    return out;
  }
  double w = -law.overlap_m(root, radius);
  const double period = s.period_s(root);
  const bool instant =
      stop.shape() == StopPulse::Shape::instant || stop.duration_s() < kInstantBelow * period;
  const double stop_end = instant ? 0.0 : stop.duration_s();
  const double dt =
      std::min(period / steps_per_period(period), instant ? period : stop_end / kFewestStepsOfStop);
  double u = instant ? stop.speed_change_m_s(impact_velocity) : 0.0;
  const auto push_at = [&](double time) {
    return setup_.gravity_m_s2 + (instant ? 0.0 : stop.deceleration_m_s2(time, impact_velocity));
  };
  // gamma_n grows with sqrt(a), the memory of the contact.
  const double damping =
      physics::normal_damping_kg_s(damping_ratio_, law.effective_modulus_Pa(), 1.0, m);

  const auto stored_energy = [&](double at, double with_root) {
    double energy = s.contact_energy_J(at, with_root, rate_dependent);
    if constexpr (kGapForces) energy += gap_.energy_J(at, radius);
    return energy;
  };
  const auto spring = [&](double at, double with_root) {
    double force = with_root > 0.0 ? contact_.force_N(law, -at, radius, with_root) : 0.0;
    if constexpr (kGapForces) force += gap_.force_N(at, radius);
    return force;
  };
  const double w_tear = -law.tear_off_overlap_m(radius);
  const double root_tear = law.tear_off_root(radius);
  double barrier = law.energy_J(root_tear, radius);
  if constexpr (kGapForces) barrier += gap_.energy_J(w_tear, radius);

  // A measured pulse may do anything until its end; the others only fall in their second half.
  const bool measured = !instant && stop.shape() == StopPulse::Shape::measured;
  const double only_falls_from = measured ? stop_end : 0.5 * stop_end;
  const double settled_from = measured || !setup_.stop_when_certain ? stop_end : 0.0;
  const double last_time = stop_end + kPeriodsAfterStop * period;

  const double energy_at_start = 0.5 * m * u * u + stored_energy(w, root);
  double work = 0.0;
  double dissipated = 0.0;
  int turns = 0;
  double t = 0.0;
  double push = push_at(0.0);
  double viscous = damping * root * u;
  double acceleration = (spring(w, root) - viscous) * inv_mass + push;
  while (t < last_time) {
    const double u_half = u + 0.5 * dt * acceleration;
    const double dw = dt * u_half;
    const double old_root = root;
    w += dw;
    t = static_cast<double>(++out.steps) * dt;
    root = contact_.advance(law, -w, radius, root, dt);
    const double new_push = push_at(t);
    const double old_viscous = viscous;
    viscous = damping * root * (u_half + 0.5 * dt * acceleration);  // speed at the step's end
    acceleration = (spring(w, root) - viscous) * inv_mass + new_push;
    const double old_u = u;
    u = u_half + 0.5 * dt * acceleration;

    work += 0.5 * m * (push + new_push) * dw;
    push = new_push;
    dissipated += 0.5 * (old_viscous + viscous) * dw;
    if (old_root > 0.0 && root == 0.0 && !rate_dependent) {
      // The neck pulled for a part of the step only; half a step is already in u.
      const double acted = std::clamp(1.0 - (w - w_tear) / dw, 0.0, 1.0);
      u += (acted - 0.5) * dt * inv_mass * law.force_N(root_tear, radius);
      dissipated += law.energy_J(root_tear, radius);
    }
    if (t > stop_end && (old_u > 0.0) != (u > 0.0)) ++turns;

    if (root == 0.0) {
      const double weight = m * setup_.gravity_m_s2;
      if (t >= settled_from && u > 0.0 && (!kGapForces || gap_.let_go(w, radius, m, u, weight))) {
        out.detached = true;
        break;
      }
      if (kGapForces && t >= stop_end && !gap_.let_go(w, radius, m, std::fabs(u), weight)) break;
      continue;
    }
    const bool held = setup_.stop_when_certain && t >= only_falls_from &&
                      0.5 * m * u * u + stored_energy(w, root) - m * push * (w - w_tear) < barrier;
    if (held || turns >= kTurnsAfterStop) break;
  }

  const double impact_speed = stop.speed_change_m_s(impact_velocity);
  out.energy_residual =
      (0.5 * m * u * u + stored_energy(w, root) - energy_at_start + dissipated - work) /
      (0.5 * m * impact_speed * impact_speed);
  out.speed_m_s = u;
  out.time_s = t;
  return out;
}

ReducedModel::Sphere ReducedModel::sphere(double diameter_m) const {
  if (!(diameter_m > 0.0 && std::isfinite(diameter_m))) {
    throw InvalidInput("particle diameter", fmt::format("{:g}", diameter_m) + " m", "> 0 m",
                       "give a diameter, such as 50e-6");
  }
  const double radius = 0.5 * diameter_m;
  return {radius, physics::sphere_mass_kg(radius, setup_.particle.density_kg_m3),
          contact_.law(radius)};
}

ReducedModel::AtRest ReducedModel::at_rest(double diameter_m, double gravity_m_s2) const {
  const Sphere s = sphere(diameter_m);
  const double root = equilibrium_root(s, gravity_m_s2);
  AtRest rest;
  if (root == 0.0) return rest;
  rest.held = true;
  rest.period_s = s.period_s(root);
  const double weight = s.mass_kg * gravity_m_s2;
  const double w = -s.law.overlap_m(root, s.radius_m);
  const double w_tear = -s.law.tear_off_overlap_m(s.radius_m);
  const auto speed = [&](double work) { return std::sqrt(std::max(0.0, 2.0 * work / s.mass_kg)); };
  const double contact = s.law.energy_J(s.law.tear_off_root(s.radius_m), s.radius_m) -
                         s.law.energy_J(root, s.radius_m) - weight * (w_tear - w);
  rest.contact_speed_m_s = speed(contact);
  // The neck's own energy is lost at tear-off; what pulls across the gap must still be climbed.
  rest.escape_speed_m_s =
      speed(contact + gap_.energy_J(w_tear, s.radius_m) - gap_.energy_J(w, s.radius_m) +
            gap_.climb_J(w_tear, s.radius_m, weight));
  rest.gap_force_N = -gap_.force_N(w, s.radius_m);
  return rest;
}

DropOutcome ReducedModel::drop(double diameter_m, double impact_velocity) const {
  const Sphere s = sphere(diameter_m);
  if (!(impact_velocity > 0.0 && std::isfinite(impact_velocity))) {
    throw InvalidInput("impact velocity", fmt::format("{:g}", impact_velocity) + " m/s", "> 0 m/s",
                       "give the speed at which the plate meets the anvil");
  }
  return gap_.none() ? run<false>(s, impact_velocity) : run<true>(s, impact_velocity);
}

}  // namespace powderlink::analysis
