// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fix_couple_bridge.h
/// `fix couple/bridge`: the particles of its group in the gas of a flow solver. Syntax:
/// liggghts_styles/couple_bridge/couple_bridge_options.h; for users: docs/couple_bridge.md.
///
/// At the start of the first step of a run, and then every N steps, it sends the particles' state
/// (full-step values of that time) and gets what the fluid does there. Before every step of the
/// integrator it moves each velocity (and spin) by liggghts_styles/couple_bridge/fluid_relaxation.h with what it got last.
/// It acts in pre_initial_integrate(), which LIGGGHTS calls before any time integration fix, so the
/// order of fixes in the script is free. What the script holds of a particle's motion
/// (liggghts_styles/couple_bridge/motion_freedom.h) stays as it is: the fluid feels dt (F + K (u - v)) there.
///
/// Impulse: reactionImpulse += m (v' - v) - dt pressureForce in each step, v to v' being what the fluid
/// does, and -= m_a times the change of velocity by all other forces: added mass is fluid, its
/// momentum stays there. Exact up to round-off; it is sent and set to zero at each exchange. All other
/// forces count m/(m + m_a). Of particles that have vanished it goes as a row of its own, without a radius
/// (leaving_particles.h); of what contacts did to them in their last step, m_a is not counted.
///
/// New particles between exchanges take over the values of the nearest particle of their rank that
/// has its own and is in the fluid, scaled by their sizes (fluid_loan.h). Where the rank has none,
/// the mean of all particles at the last exchange is taken; when there were none at all, nothing acts
/// until the next exchange.
///
/// f_ID[1..3]  fluid force on all particles at the last exchange [N]
/// f_ID[4]     coupled particles
/// f_ID[5]     wall time spent in exchanges, waiting for the solver included [s]
/// f_ID[6..8]  reaction impulse that was not sent [N s]: zero up to round-off
/// Tests: tests/liggghts_styles/couple_bridge_test.cpp, tests/liggghts_styles/couple_bridge_ends_test.cpp
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "fix.h"

#include "coupling/bridge/link/coupling_link.h"
#include "liggghts_styles/couple_bridge/bridge_checkpoint.h"
#include "liggghts_styles/couple_bridge/couple_bridge_options.h"
#include "liggghts_styles/couple_bridge/fluid_lenders.h"
#include "liggghts_styles/couple_bridge/fluid_loan.h"
#include "liggghts_styles/couple_bridge/fluid_properties.h"
#include "liggghts_styles/couple_bridge/leaving_particles.h"
#include "liggghts_styles/couple_bridge/motion_freedom.h"

namespace powderlink::host {

class FixCoupleBridge : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* kStyle = "couple/bridge";

  FixCoupleBridge(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixCoupleBridge() override;

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  void pre_initial_integrate() override;
  void pre_final_integrate() override;
  void post_run() override;
  double compute_vector(int n) override;
  void write_restart(std::FILE* file) override;
  void restart(char* state) override;
  void copy_arrays(int from, int to, int removed) override;

 private:
  // --- link to the solver (fix_couple_bridge_exchange.cpp)
  void check_host() const;
  void open_link();
  void check_domains() const;
  void exchange(LAMMPS_NS::bigint step);
  void gather(std::vector<int>& destination, std::vector<bridge::ColumnView>& columns);
  std::size_t gone_rows() const;
  void fill(const bridge::FieldSpec& field, std::vector<double>& values) const;
  void check_values() const;
  bool is_in_fluid(std::size_t row) const;
  void store();
  void find_mean();
  void speak_of_forgotten(double particles);
  void count_lost_impulse();
  void settle();
  void end_by_solver(LAMMPS_NS::bigint step);
  void say_where_it_ends() const;
  [[noreturn]] void stop(const std::string& message) const;
  void say(const std::string& message) const;

  // --- checkpoints (fix_couple_bridge_restart.cpp)
  void go_home(LAMMPS_NS::bigint step);
  void save(LAMMPS_NS::bigint step);
  void go_on(LAMMPS_NS::bigint step);
  LAMMPS_NS::FixPropertyAtom* release() const;

  // --- what the fluid does to a particle
  struct StepArrays;
  void relax();
  void move(int i, StepArrays& all);
  void move_within(const Freedom& freedom, int i, StepArrays& all);
  void count_added_mass();
  void remember_place(int i);
  void find_lenders();
  void borrow_values(const std::vector<int>& newcomers);
  void set_step(int i);
  void scale_forces();

  CoupleBridgeOptions options_;
  FluidProperties properties_;
  MotionFreedom freedom_;
  bool speaks_of_forgotten_ = false;  ///< at the next exchange
  std::unique_ptr<bridge::DemLink> link_;
  bool over_ = false;  ///< the solver has ended the coupled run
  bool spins_ = false, has_added_mass_ = false;
  bool forces_of_setup_ = false;
  BridgeCheckpoint checkpoint_;       ///< the last one: of this run, or of the one that goes on
  bool goes_on_ = false;              ///< and its first step is still to come
  bool checkpoint_is_due_ = false;    ///< at the next exchange
  LAMMPS_NS::bigint home_step_ = -1;  ///< when the atoms were brought home last
  double dt_s_ = 0.0;                 ///< agreed on
  LAMMPS_NS::bigint next_exchange_ = -1;
  LAMMPS_NS::bigint last_step_ = -1;  ///< of the last run
  double exchange_s_ = 0.0;
  double impulse_[3] = {0, 0, 0};       ///< of all reactions on this rank since the last exchange
  double lost_impulse_[3] = {0, 0, 0};  ///< on all ranks
  LeavingParticles leaving_;            ///< since the last exchange
  std::vector<VanishedParticle> gone_;  ///< to be sent; the same on all ranks

  std::vector<int> rows_;  ///< atoms that were sent, before those that have vanished
  std::vector<std::int64_t> ids_;
  std::vector<std::vector<double>> sent_, got_;  ///< by column
  std::vector<int> newcomers_;
  FluidLenders lenders_;  ///< since the last exchange, if there were newcomers
  double coupled_ = 0.0;  ///< particles of all ranks in the fluid at the last exchange
  FluidLoan mean_;        ///< of them
};

}  // namespace powderlink::host
