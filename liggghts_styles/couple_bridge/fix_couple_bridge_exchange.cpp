// SPDX-License-Identifier: GPL-3.0-or-later
/// The link of fix couple/bridge to the solver: opening, exchanges, checkpoints, ends.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include <mpi.h>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "modify.h"
#include "signal_handling.h"
#include "update.h"

#include "base/invalid_input.h"
#include "coupling/bridge/exchange/coupling_fields.h"
#include "liggghts_styles/couple_bridge/coupled_world.h"
#include "liggghts_styles/couple_bridge/fix_couple_bridge.h"

namespace powderlink::host {

using namespace LAMMPS_NS;
namespace fields = bridge::fields;

void FixCoupleBridge::say(const std::string& message) const {
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  if (rank != 0) return;
  for (std::FILE* out : {screen, logfile}) {
    if (out == nullptr) continue;
    std::fprintf(out, "couple/bridge: %s\n", message.c_str());
    std::fflush(out);
  }
}

void FixCoupleBridge::check_host() const {
  if (std::strcmp(update->unit_style, "si") != 0) {
    stop(std::string("units; given: ") + update->unit_style +
         "; allowed: si, as in the solver; to do: write units si at the top of the script");
  }
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || atom->superquadric_flag) {
    stop(
        "atom_style; given: particles that are not spheres with a radius; "
        "allowed: atom_style granular or sphere; to do: change atom_style");
  }
  for (const char* other : {"multisphere", "rigid"}) {
    if (modify->n_fixes_style(other) == 0) continue;
    stop(std::string("bodies of several spheres; given: fix ") + other +
         "; allowed: single spheres; to do: couple single spheres only");
  }
  if (modify->n_fixes_style(kStyle) > 1) {
    stop(
        "fix couple/bridge; given: two of them; "
        "allowed: one; to do: use one with a group that holds all coupled particles");
  }
  if (std::strcmp(update->integrate_style, "verlet") != 0) {
    stop(std::string("run_style; given: ") + update->integrate_style +
         "; allowed: verlet; to do: remove run_style");
  }
}

void FixCoupleBridge::open_link() {
  if (!options_.socket && has_parted()) {
    stop(
        "coupled run; given: a second one in this mpirun, "
        "as the first ended with its fix couple/bridge (unfix, clear) or by the solver; "
        "allowed: one coupled run in an mpirun, of any number of run commands; "
        "to do: keep the fix between runs; "
        "for a loop of coupled runs start each pass by an mpirun of its own, "
        "or couple by transport socket with a solver for each pass");
  }
  if (options_.socket && bridge::holds_other_program(coupled_world())) {
    stop("transport; given: socket, in one mpirun with " + coupled_world().peer_role +
         "; allowed: mpi in one mpirun, socket for two jobs; "
         "to do: set transport mpi in both programs, or start each by itself");
  }
  bridge::LinkOptions link;
  link.route =
      options_.socket ? bridge::LinkOptions::Route::socket : bridge::LinkOptions::Route::mpi;
  link.world = coupled_world();
  link.socket.address = options_.address;
  link.socket.rendezvous_file = options_.rendezvous_file;
  link.socket.token = options_.token;
  link.listens = options_.listens;
  link.timeout_s = options_.timeout_s;

  dt_s_ = update->dt;
  bridge::Hello hello;
  hello.role = "dem";
  hello.case_name = options_.case_name;
  MPI_Comm_size(world, &hello.ranks);
  hello.exchange_interval_s = options_.every * dt_s_;
  hello.clock.time_s = static_cast<double>(update->ntimestep) * dt_s_;
  hello.clock.continues = checkpoint_.step == update->ntimestep;
  hello.clock.ahead_s = checkpoint_.ahead_s;
  hello.offers = {fields::id,     fields::position, fields::velocity,         fields::spin,
                  fields::radius, fields::density,  fields::reaction_impulse, fields::held};
  hello.needs = {fields::fluid_velocity, fields::fluid_fraction, fields::drag_coefficient,
                 fields::reacting_force, fields::pressure_force};
  try {
    link_ = std::make_unique<bridge::DemLink>(world, link, hello, FluidProperties::known_fields());
  } catch (const bridge::BridgeError& problem) {
    stop(problem.what());
  }
  goes_on_ = hello.clock.continues;
  checkpoint_.ahead_s = hello.clock.time_s - link_->peer().clock.time_s;
  for (const bridge::FieldSpec& field : link_->plan().to_dem) {
    has_added_mass_ = has_added_mass_ || field == fields::added_mass;
    spins_ = spins_ || field == fields::rotational_drag || field == fields::fluid_torque;
  }
  sent_.resize(link_->plan().to_solver.size());
  got_.resize(link_->plan().to_dem.size());
  check_domains();
  say("coupled to " + link_->peer().role + " on " + std::to_string(link_->peer().ranks) +
      " rank(s), an exchange every " + std::to_string(options_.every) + " steps (" +
      number_text(options_.every * dt_s_) + " s)");
}

void FixCoupleBridge::check_domains() const {
  const bridge::RankMap& map = link_->rank_map();
  double least = std::numeric_limits<double>::max(), most = 0.0;  // box over mesh
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = map.origin_m[axis];
    const double high = low + map.spacing_m[axis] * map.voxels[axis];
    const double ratio = (domain->boxhi[axis] - domain->boxlo[axis]) / (high - low);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
    if (domain->boxhi[axis] > low && domain->boxlo[axis] < high) continue;
    const std::string name(1, "xyz"[axis]);
    stop("domains along " + name + "; given: box of LIGGGHTS " + number_text(domain->boxlo[axis]) +
         " to " + number_text(domain->boxhi[axis]) + " m, mesh of the solver " + number_text(low) +
         " to " + number_text(high) +
         " m; allowed: two that overlap; to do: check units (m) and origin of region and mesh");
  }
  // A mesh in mm around a box in m holds it, in one corner.
  constexpr double suspicious = 100.0;
  if (options_.any_size || (most > 1.0 / suspicious && least < suspicious)) return;
  stop("sizes; given: a box of LIGGGHTS that is " + number_text(least) + " to " +
       number_text(most) +
       " times as long as the mesh of the solver, along each axis; "
       "allowed: both in m, or sizes any; to do: check the units of region and mesh "
       "(transformPoints scales a mesh), or add sizes any to the line of the fix");
}

/// Rows that this rank sends for particles that have vanished.
std::size_t FixCoupleBridge::gone_rows() const { return comm->me == 0 ? gone_.size() : 0; }

/// Rows of particles that have vanished have a place and an impulse, all else is zero.
void FixCoupleBridge::fill(const bridge::FieldSpec& field, std::vector<double>& values) const {
  const std::size_t all = rows_.size() + gone_rows();
  const auto scalars = [&](const double* from) {
    values.assign(all, 0.0);
    for (std::size_t r = 0; r < rows_.size(); ++r) values[r] = from[rows_[r]];
  };
  const auto vectors = [&](double* const* from) {
    values.assign(3 * all, 0.0);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      std::copy(from[rows_[r]], from[rows_[r]] + 3, &values[3 * r]);
    }
  };
  const auto of_gone = [&](auto member) {
    for (std::size_t r = rows_.size(); r < all; ++r) {
      const double* from = gone_[r - rows_.size()].*member;
      std::copy(from, from + 3, &values[3 * r]);
    }
  };
  if (field == fields::velocity) vectors(atom->v);
  if (field == fields::spin) vectors(atom->omega);
  if (field == fields::radius) scalars(atom->radius);
  if (field == fields::density) scalars(atom->density);
  if (field == fields::held) {
    values.assign(all, 0.0);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const int i = rows_[r];
      if (!freedom_.is_whole(atom->mask[i]) && freedom_.of(i).is_none()) values[r] = 1.0;
    }
  }
  if (field == fields::reaction_impulse) {
    vectors(properties_.reaction_impulse());
    of_gone(&VanishedParticle::impulse_N_s);
  }
  if (!(field == fields::position)) return;
  vectors(atom->x);
  of_gone(&VanishedParticle::place_m);
  // Between two rebuilds of the neighbour list atoms may stand a little beyond a periodic boundary.
  for (std::size_t c = 0; c < values.size(); ++c) {
    const std::size_t axis = c % 3;
    if (!domain->periodicity[axis]) continue;
    const double length = domain->boxhi[axis] - domain->boxlo[axis];
    if (values[c] < domain->boxlo[axis]) values[c] += length;
    if (values[c] >= domain->boxhi[axis]) values[c] -= length;
  }
}

void FixCoupleBridge::gather(std::vector<int>& destination,
                             std::vector<bridge::ColumnView>& columns) {
  rows_.clear();
  ids_.clear();
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    rows_.push_back(i);
    ids_.push_back(atom->tag[i]);
  }
  for (std::size_t r = 0; r < gone_rows(); ++r) {
    ids_.push_back(static_cast<std::int64_t>(gone_[r].id));
  }
  std::vector<double> position;
  fill(fields::position, position);
  destination.resize(ids_.size());
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    destination[r] = link_->rank_map().rank_of(&position[3 * r]);
  }
  const auto& plan = link_->plan().to_solver;
  for (std::size_t column = 0; column < plan.size(); ++column) {
    if (plan[column] == fields::id) {
      columns.emplace_back(ids_.data(), ids_.size());
    } else {
      fill(plan[column], sent_[column]);
      columns.emplace_back(sent_[column].data(), ids_.size());
    }
  }
}

/// A value that is not a number would spread through the contacts and be noticed much later.
void FixCoupleBridge::check_values() const {
  const auto& plan = link_->plan().to_dem;
  int wrong[2] = {-1, -1};  // column, particle
  for (std::size_t column = 0; column < plan.size(); ++column) {
    const bool not_negative = plan[column] == fields::drag_coefficient ||
                              plan[column] == fields::rotational_drag ||
                              plan[column] == fields::added_mass;
    for (std::size_t n = 0; n < got_[column].size(); ++n) {
      const double value = got_[column][n];
      if (std::isfinite(value) && !(not_negative && value < 0.0)) continue;
      wrong[0] = static_cast<int>(column);
      wrong[1] = static_cast<int>(ids_[n / plan[column].shape.components()]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, wrong, 2, MPI_INT, MPI_MAX, world);
  if (wrong[0] < 0) return;
  stop("values of the solver: " + bridge::describe(plan[static_cast<std::size_t>(wrong[0])]) +
       "; given: a negative one or not a number for particle " + std::to_string(wrong[1]) +
       "; allowed: finite numbers, coefficients of 0 or more; "
       "to do: see whether the flow has diverged; lower its time step");
}

/// The solver sends zeros to particles outside its mesh, and the fluid fraction 1.
bool FixCoupleBridge::is_in_fluid(std::size_t row) const {
  const auto& plan = link_->plan().to_dem;
  for (std::size_t column = 0; column < plan.size(); ++column) {
    if (plan[column] == fields::fluid_fraction) continue;
    const std::size_t n = plan[column].shape.components();
    for (std::size_t k = n * row; k < n * (row + 1); ++k) {
      if (got_[column][k] != 0.0) return true;
    }
  }
  return false;
}

void FixCoupleBridge::store() {
  const auto& plan = link_->plan().to_dem;
  for (std::size_t column = 0; column < plan.size(); ++column) {
    const FixPropertyAtom* property = properties_.of_field(plan[column].name);
    const std::vector<double>& values = got_[column];
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (plan[column].shape == bridge::scalar) {
        property->vector_atom[rows_[r]] = values[r];
      } else {
        std::copy(&values[3 * r], &values[3 * r] + 3, property->array_atom[rows_[r]]);
      }
    }
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const int i = rows_[r];
    properties_.step()[i][FluidProperties::kState] =
        is_in_fluid(r) ? FluidProperties::kOwn : FluidProperties::kNothing;
    remember_place(i);
    set_step(i);
  }
}

/// For new particles on a rank that has none.
void FixCoupleBridge::find_mean() {
  FluidLoan sum;
  double count[2] = {0.0, 0.0};  // in the fluid, forgotten
  for (const int i : rows_) {
    if (properties_.step()[i][FluidProperties::kState] != FluidProperties::kOwn) continue;
    sum.add(FluidLoan(properties_, i, atom->radius[i]));
    ++count[0];
    if (freedom_.is_forgotten(atom->mask[i])) ++count[1];
  }
  MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_DOUBLE, MPI_SUM, world);
  coupled_ = count[0];
  speak_of_forgotten(count[1]);
  MPI_Allreduce(MPI_IN_PLACE, sum.data(), FluidLoan::size(), MPI_DOUBLE, MPI_SUM, world);
  if (coupled_ > 0.0) sum.divide(coupled_);
  mean_ = sum;
}

/// Held on purpose, or fix nve/sphere was left out or has another group: the user knows which.
void FixCoupleBridge::speak_of_forgotten(double particles) {
  if (!speaks_of_forgotten_ || particles == 0.0) return;
  speaks_of_forgotten_ = false;
  say("Warning: particles that do not move; given: " + number_text(particles) + " of " +
      number_text(coupled_) +
      " coupled particles in no group of a fix that integrates; "
      "allowed: yes, they keep their velocity and the gas feels their drag; "
      "to do: for particles that fly, add fix nve/sphere to their group; "
      "to hold them, nothing, or fix freeze");
}

/// What was given to all particles, less what was sent.
void FixCoupleBridge::count_lost_impulse() {
  double lost[3] = {impulse_[0], impulse_[1], impulse_[2]};
  for (const int i : rows_) {
    for (int c = 0; c < 3; ++c) lost[c] -= properties_.reaction_impulse()[i][c];
  }
  for (std::size_t r = 0; r < gone_rows(); ++r) {
    for (int c = 0; c < 3; ++c) lost[c] -= gone_[r].impulse_N_s[c];
  }
  MPI_Allreduce(MPI_IN_PLACE, lost, 3, MPI_DOUBLE, MPI_SUM, world);
  // The first exchange of a continued run sends what was collected before.
  if (next_exchange_ < 0) return;
  for (int c = 0; c < 3; ++c) lost_impulse_[c] += lost[c];
}

/// The impulses are complete, and it is known who has vanished. Collective.
void FixCoupleBridge::settle() {
  count_added_mass();
  if (!leaving_.collect(world)) return;
  const double* const* step = properties_.step();
  for (int i = 0; i < atom->nlocal; ++i) {
    const double state = step[i][FluidProperties::kState];
    if (!FluidProperties::is_acted_on(state)) continue;
    leaving_.see(atom->tag[i], state == FluidProperties::kBorrowed);
  }
  const std::vector<VanishedParticle> gone = leaving_.vanished(world);
  gone_.insert(gone_.end(), gone.begin(), gone.end());
}

void FixCoupleBridge::end_by_solver(bigint step) {
  over_ = true;
  note_parted();
  say("the solver ended the coupled run at step " + std::to_string(step) + ", time " +
      number_text(static_cast<double>(step) * dt_s_) +
      " s; this program stops after one more step");
  SignalHandler::enable_restart_writing = false;
  SignalHandler::request_quit = true;
}

/// The fluid of an interval is computed as a whole, whether the particles go through all of it or not.
void FixCoupleBridge::say_where_it_ends() const {
  if (over_ || last_step_ < 0 || last_step_ >= next_exchange_) return;
  say("WARNING: the coupling ends at step " + std::to_string(last_step_) +
      ", between the exchanges of steps " + std::to_string(next_exchange_ - options_.every) +
      " and " + std::to_string(next_exchange_) + ": the gas goes on to the latter, the particles " +
      "stand; a whole number of exchanges: run so that the last step is a multiple of every " +
      std::to_string(options_.every) + " from the first exchange on");
}

void FixCoupleBridge::exchange(bigint step) {
  const double start = MPI_Wtime();
  if (checkpoint_is_due_) go_home(step);
  settle();
  bridge::SolverWord word;
  try {
    std::vector<int> destination;
    std::vector<bridge::ColumnView> columns;
    gather(destination, columns);
    link_->send_particles(step, static_cast<double>(step) * dt_s_, destination, columns);
    std::vector<bridge::MutableColumnView> room;
    for (std::size_t column = 0; column < got_.size(); ++column) {
      got_[column].resize(ids_.size() * link_->plan().to_dem[column].shape.components());
      room.emplace_back(got_[column].data(), ids_.size());
    }
    word = link_->receive_values(room);
  } catch (const bridge::BridgeError& problem) {
    stop(problem.what());
  }
  exchange_s_ += MPI_Wtime() - start;
  checkpoint_is_due_ = word.checkpoint_next;
  if (word.command == bridge::Command::stop) {
    if (word.checkpoint) save(step);
    end_by_solver(step);
    return;
  }
  check_values();
  store();
  find_mean();
  count_lost_impulse();
  if (word.checkpoint) save(step);
  for (int i = 0; i < atom->nlocal; ++i) {
    for (int c = 0; c < 3; ++c) properties_.reaction_impulse()[i][c] = 0.0;
  }
  std::fill(impulse_, impulse_ + 3, 0.0);
  gone_.clear();
  lenders_.clear();
  next_exchange_ = step + options_.every;
}

}  // namespace powderlink::host
