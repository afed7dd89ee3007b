// SPDX-License-Identifier: GPL-3.0-or-later
/// \file reduced_model.h
/// The reduced model of the Kinetic Adhesion Test: one particle under the plate that is stopped.
///
///   m w'' = F(w) + F_gap(w) - gamma_n w' + m (A(t) + g)
///
/// Symbols: w distance of the particle away from the plate [m], w = -overlap; F force of the
/// adhesive contact with its memory (physics/effects/adhesive_contact.h); F_gap attraction of the effects
/// [N]; gamma_n damping (physics/contact/normal_damping.h); A(t) deceleration of the plate [m/s^2]
/// (physics/kat/stop_pulse.h); g gravity, away from the plate [m/s^2].
/// The particle starts at the equilibrium of contact, gravity and effects; an instant stop kicks it
/// with v (1 + e_p). Integration: velocity Verlet as in the DEM, with a step that is a fraction of
/// the contact's own period.
///
/// A particle counts as detached when its contact is lost and nothing brings it back. Runs end as
/// soon as that is certain:
///   attached  the deceleration can only fall and kinetic + stored energy is below the barrier at
///             tear-off: with y = w - w_tear, d/dt(m w'^2/2 + U - m (A + g) y) <= 0 while y < 0;
///   detached  off the plate, moving away, and no later push or attraction can turn it back.
/// Validity: stiff plate, no neighbours, no air. Errors: InvalidInput.
/// Tests: tests/analysis/kat/reduced_model_test.cpp
#pragma once

#include <memory>
#include <vector>

#include "physics/contact/material.h"
#include "physics/effects/adhesive_contact.h"
#include "physics/effects/gap_forces.h"
#include "physics/kat/stop_pulse.h"

namespace powderlink::analysis {

struct KatSetup {
  physics::Material particle{};
  physics::Material substrate{};
  double work_of_adhesion_J_m2 = 0.0;  ///< Gamma of the interface
  physics::StopPulse stop{};           ///< replaced by the stop of an effect that has one
  std::vector<std::shared_ptr<const physics::Effect>> effects{};
  double gravity_m_s2 = 9.81;
  double restitution = 1.0;       ///< of the Hertz contact; 1 is undamped
  double steps_per_period = 0.0;  ///< of the contact's own period; 0: chosen for stop and contact
  bool stop_when_certain = true;  ///< false: integrate to the end of the stop and some swings more
};

struct DropOutcome {
  bool detached = false;
  double speed_m_s = 0.0;  ///< away from the plate when the run ended
  double time_s = 0.0;     ///< since the anvil was touched
  long steps = 0;
  /// (Change of kinetic and stored energy + what was dissipated - work done by gravity and inertia)
  /// over the impact energy [-]. Not meaningful with rate dependence, whose edge dissipates unseen.
  double energy_residual = 0.0;
};

class ReducedModel {
 public:
  /// Throws InvalidInput for materials, Gamma, gravity, restitution or step that cannot be used.
  explicit ReducedModel(KatSetup setup);

  /// One particle, one stop. Throws InvalidInput unless diameter > 0 and velocity > 0.
  DropOutcome drop(double diameter_m, double impact_velocity_m_s) const;
  bool detaches(double diameter_m, double impact_velocity_m_s) const {
    return drop(diameter_m, impact_velocity_m_s).detached;
  }

  /// The particle on the plate at rest, and what takes it off by energy alone. Speeds are those of an
  /// instant stop, without damping and without rate dependence.
  struct AtRest {
    bool held = false;  ///< false: its weight takes it off, all else is 0
    double period_s = 0.0;
    double escape_speed_m_s = 0.0;
    double contact_speed_m_s = 0.0;  ///< of the contact alone, without the climb across the gap
    double gap_force_N = 0.0;        ///< attraction at rest beside the contact, >= 0
  };
  AtRest at_rest(double diameter_m) const { return at_rest(diameter_m, setup_.gravity_m_s2); }
  AtRest at_rest(double diameter_m, double gravity_m_s2) const;
  bool rate_dependent() const { return contact_.rate_dependent(); }
  bool gap_forces() const { return !gap_.none(); }
  /// Contact law of a particle of this radius, with what the effects leave of Gamma.
  physics::JkrLaw law(double radius_m) const { return contact_.law(radius_m); }

  const KatSetup& setup() const { return setup_; }
  /// Contact law of a smooth particle.
  const physics::JkrLaw& smooth_law() const { return smooth_; }

 private:
  struct Sphere;
  Sphere sphere(double diameter_m) const;
  double equilibrium_root(const Sphere& sphere, double gravity_m_s2) const;
  double steps_per_period(double period_s) const;
  template <bool kGapForces>
  DropOutcome run(const Sphere& sphere, double impact_velocity_m_s) const;

  KatSetup setup_;
  physics::JkrLaw smooth_;
  physics::AdhesiveContact contact_;
  physics::GapForces gap_;
  double damping_ratio_ = 0.0;
};

}  // namespace powderlink::analysis
