// SPDX-License-Identifier: GPL-3.0-or-later
/// What fix couple/bridge does in each step.
#include "liggghts_styles/couple_bridge/fix_couple_bridge.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <mpi.h>

#include "atom.h"
#include "update.h"

#include "base/invalid_input.h"
#include "liggghts_styles/couple_bridge/coupled_world.h"
#include "liggghts_styles/couple_bridge/fluid_relaxation.h"
#include "liggghts_styles/host/massflow_state.h"
#include "liggghts_styles/host/stop_all.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

/// Moment of inertia of a sphere over m r^2.
constexpr double kInertia = 0.4;

}  // namespace

FixCoupleBridge::FixCoupleBridge(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), properties_(lmp), freedom_(lmp) {
  try {
    const std::filesystem::path folder = std::filesystem::current_path();
    options_ = CoupleBridgeOptions::parse(narg, arg, folder.filename().string());
  } catch (const InvalidInput& problem) {
    stop(problem.what());
  }
  vector_flag = 1;
  restart_global = 1;
  size_vector = 8;
  global_freq = 1;
  extvector = 0;
  time_depend = 1;
  // Before those of the properties, so that copy_arrays() still finds their values.
  atom->add_callback(0);
}

FixCoupleBridge::~FixCoupleBridge() {
  atom->delete_callback(id, 0);
  if (!link_) return;
  say_where_it_ends();
  try {
    link_->finish();
    note_parted();
  } catch (const bridge::BridgeError& problem) {
    stop(problem.what());
  }
}

void FixCoupleBridge::post_create() { properties_.create(style); }

void FixCoupleBridge::pre_delete(bool unfixflag) {
  if (unfixflag) properties_.remove();
}

int FixCoupleBridge::setmask() {
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::PRE_FINAL_INTEGRATE | FixConst::POST_RUN;
}

void FixCoupleBridge::stop(const std::string& message) const {
  if (link_) link_->fail(message);
  stop_all(lmp, FLERR, this, message);
}

void FixCoupleBridge::init() {
  check_host();
  if (!link_) {
    open_link();
  } else if (std::fabs(update->dt - dt_s_) > 1e-12 * dt_s_) {
    stop("time step; given: " + number_text(update->dt) + " s after " + number_text(dt_s_) +
         " s; allowed: the one that the solver was told at the start; "
         "to do: keep timestep, or start both programs anew with another couplingInterval");
  }
}

/// Also of a run that does without init(): fixes may have come and gone.
void FixCoupleBridge::setup(int /*vflag*/) {
  forces_of_setup_ = true;
  try {
    freedom_.read_fixes(groupbit);
  } catch (const InvalidInput& problem) {
    stop(problem.what());
  }
  speaks_of_forgotten_ = true;
  // What is printed before the first step has it already.
  if (goes_on_) set_massflow_state(lmp, checkpoint_.counted);
}

void FixCoupleBridge::pre_initial_integrate() {
  // LIGGGHTS counts the step before it does it: positions and velocities are those of this one.
  const bigint step = update->ntimestep - 1;
  if (update->dt != dt_s_) init();
  if (goes_on_) go_on(step);
  if (!over_ && (next_exchange_ < 0 || step >= next_exchange_)) exchange(step);
  if (forces_of_setup_) scale_forces();
  forces_of_setup_ = false;
  relax();
}

void FixCoupleBridge::pre_final_integrate() { scale_forces(); }

/// The integrator divides by m; what accelerates is m + m_a.
void FixCoupleBridge::scale_forces() {
  if (!has_added_mass_) return;
  const double* added_mass = properties_.added_mass();
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit) || added_mass[i] == 0.0) continue;
    const double share = atom->rmass[i] / (atom->rmass[i] + added_mass[i]);
    for (int c = 0; c < 3; ++c) atom->f[i][c] *= share;
  }
}

/// What a step reads and writes of every particle, found once: the stores of one particle could change
/// the pointers for the next, as far as the compiler knows.
struct FixCoupleBridge::StepArrays {
  StepArrays(const FluidProperties& p, const Atom& atom, const double (&sum)[3])
      : step(p.step()),
        pressure(p.pressure_force()),
        reaction(p.reaction_impulse()),
        v(atom.v),
        omega(atom.omega),
        rmass(atom.rmass),
        place(p.place()),
        impulse{sum[0], sum[1], sum[2]} {}
  const double *const *step, *const *pressure;
  double *const *reaction, *const *v, *const *omega;
  const double* rmass;
  double* const* place;
  double impulse[3];  ///< sum of the reactions
};

void FixCoupleBridge::relax() {
  newcomers_.clear();
  count_added_mass();
  StepArrays all(properties_, *atom, impulse_);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double state = all.step[i][FluidProperties::kState];
    if (state == FluidProperties::kNew) {
      newcomers_.push_back(i);
    } else if (state != FluidProperties::kNothing) {
      move(i, all);
    }
  }
  if (!newcomers_.empty()) borrow_values(newcomers_);
  for (const int i : newcomers_) {
    if (all.step[i][FluidProperties::kState] != FluidProperties::kNothing) move(i, all);
  }
  std::copy(all.impulse, all.impulse + 3, impulse_);
}

inline void FixCoupleBridge::move(int i, StepArrays& all) {
  if (!freedom_.is_whole(atom->mask[i])) {
    move_within(freedom_.of(i), i, all);
    return;
  }
  const double* step = all.step[i];
  const double* pressure = all.pressure[i];
  double* reaction = all.reaction[i];
  double* v = all.v[i];
  for (int c = 0; c < 3; ++c) {
    const double after = step[FluidProperties::kA] * v[c] + step[FluidProperties::kD + c];
    // What m_a gains stays in the fluid.
    const double impulse = all.rmass[i] * (after - v[c]) - dt_s_ * pressure[c];
    if (has_added_mass_) all.place[i][FluidProperties::kVelocity + c] += after - v[c];
    v[c] = after;
    reaction[c] += impulse;
    all.impulse[c] += impulse;
  }
  if (!spins_) return;
  double* spin = all.omega[i];
  for (int c = 0; c < 3; ++c) {
    spin[c] = step[FluidProperties::kSpinA] * spin[c] + step[FluidProperties::kSpinD + c];
  }
}

/// The velocity that contacts and weight gave to the particles since the last step took m_a with it:
/// that momentum is the fluid's.
void FixCoupleBridge::count_added_mass() {
  if (!has_added_mass_) return;
  const double* added_mass = properties_.added_mass();
  double* const* place = properties_.place();
  const double* const* step = properties_.step();
  for (int i = 0; i < atom->nlocal; ++i) {
    const double state = step[i][FluidProperties::kState];
    if (!(atom->mask[i] & groupbit) || !FluidProperties::is_acted_on(state)) {
      continue;
    }
    double* last = place[i] + FluidProperties::kVelocity;
    for (int c = 0; c < 3; ++c) {
      const double impulse = -added_mass[i] * (atom->v[i][c] - last[c]);
      properties_.reaction_impulse()[i][c] += impulse;
      impulse_[c] += impulse;
      last[c] = atom->v[i][c];
    }
  }
}

void FixCoupleBridge::remember_place(int i) {
  double* place = properties_.place()[i];
  place[FluidProperties::kId] = atom->tag[i];
  std::copy(atom->x[i], atom->x[i] + 3, place + FluidProperties::kPosition);
  std::copy(atom->v[i], atom->v[i] + 3, place + FluidProperties::kVelocity);
}

/// LIGGGHTS removes a particle from a rank by copying the last one onto it. Its position and id have
/// been overwritten at this moment, the values of the properties have not.
void FixCoupleBridge::copy_arrays(int /*from*/, int to, int removed) {
  if (removed == 0 || !link_ || over_) return;
  const double state = properties_.step()[to][FluidProperties::kState];
  if (!FluidProperties::is_acted_on(state)) return;
  const double* place = properties_.place()[to];
  VanishedParticle particle;
  particle.id = place[FluidProperties::kId];
  particle.borrowed = state == FluidProperties::kBorrowed ? 1.0 : 0.0;
  particle.step = static_cast<double>(update->ntimestep);
  for (int c = 0; c < 3; ++c) {
    particle.place_m[c] = place[FluidProperties::kPosition + c];
    particle.impulse_N_s[c] = properties_.reaction_impulse()[to][c];
  }
  leaving_.note(particle);
}

/// What holds the rest of its motion takes the gas's force there; the fluid feels that all the same, with
/// the velocity that the particle keeps.
void FixCoupleBridge::move_within(const Freedom& freedom, int i, StepArrays& all) {
  const double* step = all.step[i];
  const double* pressure = all.pressure[i];
  double* v = all.v[i];
  const double drag = properties_.drag_coefficient()[i];
  double gain[3], held[3];  // if it were free; impulse of the reacting forces if it were held
  for (int c = 0; c < 3; ++c) {
    gain[c] = (step[FluidProperties::kA] - 1.0) * v[c] + step[FluidProperties::kD + c];
    held[c] = dt_s_ * (drag * (properties_.fluid_velocity()[i][c] - v[c]) +
                       properties_.reacting_force()[i][c]);
  }
  for (int c = 0; c < 3; ++c) {
    double change = 0.0, impulse = held[c];
    for (int k = 0; k < 3; ++k) {
      const double share = freedom.velocity[c][k];
      change += share * gain[k];
      impulse += share * (all.rmass[i] * gain[k] - dt_s_ * pressure[k] - held[k]);
    }
    if (has_added_mass_) all.place[i][FluidProperties::kVelocity + c] += change;
    v[c] += change;
    all.reaction[i][c] += impulse;
    all.impulse[c] += impulse;
  }
  if (!spins_) return;
  double* spin = all.omega[i];
  for (int c = 0; c < 3; ++c) {
    spin[c] += freedom.spin[c] * ((step[FluidProperties::kSpinA] - 1.0) * spin[c] +
                                  step[FluidProperties::kSpinD + c]);
  }
}

void FixCoupleBridge::set_step(int i) {
  const double mass = atom->rmass[i] + (has_added_mass_ ? properties_.added_mass()[i] : 0.0);
  const double* reacting = properties_.reacting_force()[i];
  const double* pressure = properties_.pressure_force()[i];
  const double* fluid = properties_.fluid_velocity()[i];
  const double drag = properties_.drag_coefficient()[i];
  double* step = properties_.step()[i];
  const double force[3] = {reacting[0] + pressure[0], reacting[1] + pressure[1],
                           reacting[2] + pressure[2]};
  const FluidRelaxation relaxation = fluid_relaxation(drag, fluid, force, mass, dt_s_);
  step[FluidProperties::kA] = relaxation.a;
  for (int c = 0; c < 3; ++c) {
    step[FluidProperties::kD + c] = relaxation.d[c];
    properties_.fluid_force()[i][c] = force[c] + drag * (fluid[c] - atom->v[i][c]);
  }
  if (!spins_) return;
  const double inertia = kInertia * atom->rmass[i] * atom->radius[i] * atom->radius[i];
  const FluidRelaxation turn =
      fluid_relaxation(properties_.rotational_drag()[i], properties_.fluid_spin()[i],
                       properties_.fluid_torque()[i], inertia, dt_s_);
  step[FluidProperties::kSpinA] = turn.a;
  for (int c = 0; c < 3; ++c) step[FluidProperties::kSpinD + c] = turn.d[c];
}

/// Those that have values of their own, as they stand when the first newcomer since the last exchange
/// asks: their values hold until the next one.
void FixCoupleBridge::find_lenders() {
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit) ||
        properties_.step()[i][FluidProperties::kState] != FluidProperties::kOwn) {
      continue;
    }
    lenders_.add(atom->x[i], FluidLoan(properties_, i, atom->radius[i]));
  }
  lenders_.order();
}

void FixCoupleBridge::borrow_values(const std::vector<int>& newcomers) {
  if (!lenders_.ordered()) find_lenders();
  double* const* step = properties_.step();
  for (const int i : newcomers) {
    const FluidLoan* loan = lenders_.nearest(atom->x[i]);
    if (!loan && coupled_ == 0.0) {
      step[i][FluidProperties::kState] = FluidProperties::kNothing;
      continue;
    }
    (loan ? *loan : mean_).give(properties_, i, atom->radius[i]);
    step[i][FluidProperties::kState] = FluidProperties::kBorrowed;
    remember_place(i);
    set_step(i);
  }
}

double FixCoupleBridge::compute_vector(int n) {
  if (n == 4) return exchange_s_;
  if (n > 4) return lost_impulse_[n - 5];
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    sum += n == 3 ? 1.0 : properties_.fluid_force()[i][n];
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

}  // namespace powderlink::host
