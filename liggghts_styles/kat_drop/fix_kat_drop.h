// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fix_kat_drop.h
/// `fix kat/drop`: the Kinetic Adhesion Test as one style. Syntax: liggghts_styles/kat_drop/kat_drop_options.h.
///
/// Grains hang under a plate. Phases: (0) settle to equilibrium, critically damped; (1) the plate,
/// falling with the impact speed, is stopped by physics/kat/stop_pulse.h; (2) watch until the contacts
/// have decided; (3) over. In the plate's frame the plate stands still and every grain feels the
/// deceleration A(t) along the fall; with `frame moving` the mesh itself falls and is stopped, and
/// the grains feel gravity only. The two agree to round-off without damping.
///
/// A grain is attached while its contact with the plate lives (history of model jkr), or while a
/// force across the gap (fix adhesion/effect) binds it; no height is guessed.
///
/// f_ID (scalar)  critical diameter [m], geometric mean of the bracket; 0 while there is none
/// f_ID[1..16]    phase, critical diameter, largest attached, smallest detached diameter [m],
///                number attached, detached, out of order, time since impact [s],
///                speed of the plate along the fall [m/s], its deceleration [m/s^2],
///                largest energy and momentum residual of a grain [-],
///                sums of kinetic, potential, dissipated energy and of the work of inertia and
///                gravity [J]
/// f_ID[1..9]     per atom: attached (0, 1, or 2: not in contact but bound across the gap or on its
///                way back), speed away from the plate [m/s], contact radius [m],
///                kinetic, potential, dissipated energy, work of inertia, gravity and gap forces [J],
///                energy residual over the impact energy, momentum residual over the impact
///                momentum [-]
/// Energies are counted from the impact on; rotation is left out. The residuals compare the change
/// of kinetic energy and momentum with the work and impulse of all forces in the integrator's own
/// quadrature and must stay at round-off; a force that another fix adds after this one shows up
/// there. "Dissipated" is what the contact took and its closed-form energy does not hold: damping,
/// and the neck's energy at tear-off.
/// Tests: tests/liggghts_styles/kat_drop_test.cpp, tests/liggghts_styles/critical_speed_test.cpp
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "liggghts_styles/kat_drop/kat_drop_options.h"
#include "liggghts_styles/kat_drop/plate_contacts.h"
#include "physics/contact/material.h"
#include "physics/effects/adhesive_contact.h"
#include "physics/effects/gap_forces.h"

namespace powderlink::host {

class FixKatDrop : public LAMMPS_NS::Fix {
 public:
  FixKatDrop(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixKatDrop() override;

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup(int vflag) override;
  void post_force(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;

  void grow_arrays(int nmax) override;
  void copy_arrays(int i, int j, int delflag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buf) override;
  int unpack_exchange(int nlocal, double* buf) override;
  void write_restart(FILE* file) override;
  void restart(char* buf) override;
  int pack_restart(int i, double* buf) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int nlocal) override;
  int maxsize_restart() override;
  double memory_usage() override;

  bool finished() const { return phase_ == Phase::over; }
  /// Steps that kat/run may do before it asks again.
  int next_chunk_steps() const;

 private:
  enum class Phase { settle, stop, watch, over };
  enum Column {
    kAttached,
    kSpeed,
    kContactRadius,
    kKinetic,
    kPotential,
    kDissipated,
    kWork,
    kEnergyResidual,
    kMomentumResidual,
    kReported,
    // hidden state
    kKineticAtImpact = kReported,
    kMomentumAtImpact,
    kContactEnergyAtImpact,
    kContactWork,
    kOwnWork,
    kImpulse,
    kBridge,
    kTakesPart,
    kColumns
  };
  struct Summary {
    double largest_attached = 0.0, smallest_detached = 0.0, critical_diameter = 0.0;
    double attached = 0, detached = 0, out_of_order = 0;
    double energy_residual = 0.0, momentum_residual = 0.0;
    double kinetic = 0.0, potential = 0.0, dissipated = 0.0, work = 0.0;
  };

  // --- physics of one grain on the plate
  physics::JkrLaw law_of(int type, double radius) const;
  double gap_m(int i) const;
  bool bridged(int i) const { return array_atom[i][kBridge] != 0.0; }
  double contact_period_s(int i) const;
  physics::Material material(int type) const;
  double pair_property(const char* name, int i, int j) const;

  // --- protocol
  void populate();
  void prepare_moving_plate();
  void place_at_equilibrium();
  void check_fallen() const;
  void check_complete(const Summary& summary) const;
  void check_before_run();
  void begin_impact();
  bool settled() const;
  double time_since_impact() const;
  double deceleration_now() const;
  void account(int i, double own_force, double gap);
  Summary summarize() const;
  void write_results(const Summary& summary) const;
  [[noreturn]] void stop(const std::string& message) const;

  KatDropOptions options_;
  std::unique_ptr<PlateContacts> contacts_;
  physics::GapForces gap_forces_;
  std::vector<physics::AdhesiveContact> laws_;  ///< by atom type
  Phase phase_ = Phase::settle;
  bool restarted_ = false;
  bool placed_ = false;
  LAMMPS_NS::bigint start_step_ = -1;
  LAMMPS_NS::bigint impact_step_ = -1;
  double plate_position_ = 0.0;    ///< along the axis [m]
  double plate_half_speed_ = 0.0;  ///< along the fall, of the step to come [m/s]
  double settle_limit_s_ = 0.0;
  double watch_s_ = 0.0;
  double taking_part_ = 0.0;  ///< grains in contact at the impact
};

}  // namespace powderlink::host
