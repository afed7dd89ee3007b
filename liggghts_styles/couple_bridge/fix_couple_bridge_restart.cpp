// SPDX-License-Identifier: GPL-3.0-or-later
/// Checkpoints of fix couple/bridge, and how a run goes on from one.
///
/// A checkpoint is the state between two steps: the forces of the last one are still to act. They came
/// from the half-step velocities of velocity Verlet, and the setup of a run would make them anew from
/// full-step ones; so they are kept, as are random numbers and steps of release (insertion_state.h,
/// FluidProperties::Kept). Contact histories are in the restart file, and setup does not advance them.
/// Both the run that writes and the one that goes on bring the atoms home and into one order there, so
/// all later sums are the same. It is done when the first step begins: fixes that act in setup have
/// acted then, whatever their order.
#include "liggghts_styles/couple_bridge/fix_couple_bridge.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "update.h"

#include "liggghts_styles/host/checkpoint_file.h"
#include "liggghts_styles/host/insertion_state.h"
#include "liggghts_styles/host/massflow_state.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr int kReleaseStep = 4;  ///< column of the property of release()

}  // namespace

void FixCoupleBridge::go_home(bigint step) {
  // In a run LIGGGHTS has begun to count the next step already.
  const bigint counted = update->ntimestep;
  update->ntimestep = step;
  bring_atoms_home(lmp);
  update->ntimestep = counted;
  home_step_ = step;
}

/// The property that fix insert/stream has its steps of release in; it counts them anew in a restart.
FixPropertyAtom* FixCoupleBridge::release() const {
  return dynamic_cast<FixPropertyAtom*>(modify->find_fix_id("release_fix_insert_stream"));
}

void FixCoupleBridge::save(bigint step) {
  const std::string file = options_.checkpoint_prefix + std::to_string(step);
  if (home_step_ != step) go_home(step);
  const FixPropertyAtom* releases = release();
  for (int i = 0; i < atom->nlocal; ++i) {
    double* kept = properties_.kept()[i];
    for (int c = 0; c < 3; ++c) {
      kept[FluidProperties::kForce + c] = atom->f[i][c];
      kept[FluidProperties::kTorque + c] = atom->torque[i][c];
    }
    if (releases) kept[FluidProperties::kRelease] = releases->array_atom[i][kReleaseStep];
  }
  checkpoint_.step = step;
  checkpoint_.insertion = insertion_state(lmp);
  checkpoint_.counted = massflow_state(lmp);
  checkpoint_.gone = gone_;
  const bigint counted = update->ntimestep;
  update->ntimestep = step;
  const std::string problem = write_checkpoint(lmp, file);
  update->ntimestep = counted;
  if (!problem.empty()) stop(problem);
  say("wrote " + file);
}

/// The script may end here: nobody would ask for the checkpoint that is due at this moment. Should a
/// run follow, its first exchange makes it again.
void FixCoupleBridge::post_run() {
  last_step_ = update->ntimestep;
  if (over_ || !checkpoint_is_due_ || update->ntimestep != next_exchange_) return;
  settle();
  save(next_exchange_);
}

void FixCoupleBridge::go_on(bigint step) {
  goes_on_ = false;
  gone_ = checkpoint_.gone;
  go_home(step);
  const FixPropertyAtom* releases = release();
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* kept = properties_.kept()[i];
    for (int c = 0; c < 3; ++c) {
      atom->f[i][c] = kept[FluidProperties::kForce + c];
      atom->torque[i][c] = kept[FluidProperties::kTorque + c];
    }
    if (releases) releases->array_atom[i][kReleaseStep] = kept[FluidProperties::kRelease];
  }
  forces_of_setup_ = false;
  set_massflow_state(lmp, checkpoint_.counted);
  const std::string unknown = set_insertion_state(lmp, checkpoint_.insertion);
  if (!unknown.empty()) {
    say("random numbers not in the checkpoint, or of another number of ranks: " + unknown);
  }
  say("goes on from the checkpoint of step " + std::to_string(step));
}

void FixCoupleBridge::write_restart(std::FILE* file) { checkpoint_.write(file, world); }

void FixCoupleBridge::restart(char* state) { checkpoint_ = BridgeCheckpoint::read(state, world); }

}  // namespace powderlink::host
