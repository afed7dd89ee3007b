// SPDX-License-Identifier: GPL-3.0-or-later
/// What fix kat/drop reports: balances of each grain, sums, the results file.
#include <algorithm>
#include <cmath>

#include "liggghts_styles/host/liggghts_headers.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"

#include "liggghts_styles/kat_drop/kat_gather.h"
#include "liggghts_styles/kat_drop/kat_results.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

/// Adds this step to the balances. v is the half-step velocity, f holds everything but `own_force`.
/// Work of a force over the kick of half a step: h F.(v + h f/(2 m)), f the total force: exact.
void FixKatDrop::account(int i, double own_force, double gap) {
  double* state = array_atom[i];
  const int k = options_.axis;
  const double m = atom->rmass[i];
  const double h = 0.5 * update->dt;
  const double* v = atom->v[i];
  double total[3], contact[3];
  for (int d = 0; d < 3; ++d) contact[d] = total[d] = atom->f[i][d];
  total[k] += options_.direction * own_force;
  const double own = options_.direction * own_force;

  const double impact_speed = options_.stop.speed_change_m_s(options_.velocity_m_s);
  const double impact_energy = 0.5 * m * impact_speed * impact_speed;
  if (state[kKineticAtImpact] < 0.0) {  // first step after the impact
    state[kKineticAtImpact] = 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    state[kMomentumAtImpact] = m * v[k] * options_.direction;
  }
  double contact_before = 0.0, contact_after = 0.0, now2 = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double half = 0.5 * h * total[d] / m;
    contact_before += h * contact[d] * (v[d] + half);
    contact_after += h * contact[d] * (v[d] + 3.0 * half);
    now2 += std::pow(v[d] + 2.0 * half, 2);
  }
  const double half = 0.5 * h * total[k] / m;
  const double contact_work = state[kContactWork] + contact_before;
  const double own_work = state[kOwnWork] + h * own * (v[k] + half);
  const double impulse = state[kImpulse] + h * total[k] * options_.direction;
  state[kContactWork] = contact_work + contact_after;
  state[kOwnWork] = own_work + h * own * (v[k] + 3.0 * half);
  state[kImpulse] = impulse + h * total[k] * options_.direction;

  const double speed = (v[k] + 2.0 * half) * options_.direction;
  const double plate_speed =
      options_.moving_frame ? plate_half_speed_ + h * deceleration_now() : 0.0;
  const double root = contacts_->root(i);
  const double gap_energy = gap_forces_.energy_J(gap, atom->radius[i], bridged(i));
  state[kSpeed] = speed - plate_speed;
  state[kContactRadius] = root * root;
  state[kKinetic] = 0.5 * m * now2;
  const double contact_energy =
      root > 0.0 ? law_of(atom->type[i], atom->radius[i]).energy_J(root, atom->radius[i]) : 0.0;
  state[kPotential] = contact_energy + gap_energy;
  state[kWork] = own_work;
  state[kDissipated] = -contact_work - (contact_energy - state[kContactEnergyAtImpact]);
  state[kEnergyResidual] =
      (state[kKinetic] - state[kKineticAtImpact] - contact_work - own_work) / impact_energy;
  state[kMomentumResidual] = (m * speed - state[kMomentumAtImpact] - impulse) / (m * impact_speed);

  if (root > 0.0) {
    state[kAttached] = 1.0;
  } else {
    const bool left = gap_forces_.let_go(gap, atom->radius[i], m, state[kSpeed],
                                         m * options_.gravity_m_s2, bridged(i));
    state[kAttached] = left ? 0.0 : 2.0;
  }
}

FixKatDrop::Summary FixKatDrop::summarize() const {
  constexpr double none = 1e300;
  double largest = 0.0, smallest = none;
  double sums[6] = {0, 0, 0, 0, 0, 0};
  double residual[2] = {0.0, 0.0};
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* state = array_atom[i];
    if (!(atom->mask[i] & groupbit) || state[kTakesPart] == 0.0) continue;
    const double d = 2.0 * atom->radius[i];
    const bool attached = state[kAttached] > 0.0;
    if (attached) {
      largest = std::max(largest, d);
    } else {
      smallest = std::min(smallest, d);
    }
    sums[attached ? 0 : 1] += 1.0;
    sums[2] += state[kKinetic];
    sums[3] += state[kPotential];
    sums[4] += state[kDissipated];
    sums[5] += state[kWork];
    residual[0] = std::max(residual[0], std::fabs(state[kEnergyResidual]));
    residual[1] = std::max(residual[1], std::fabs(state[kMomentumResidual]));
  }
  MPI_Max_Scalar(largest, world);
  MPI_Min_Scalar(smallest, world);
  MPI_Sum_Vector(sums, 6, world);
  MPI_Max_Vector(residual, 2, world);
  double out_of_order = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit) || array_atom[i][kTakesPart] == 0.0) continue;
    if (array_atom[i][kAttached] == 0.0 && 2.0 * atom->radius[i] < largest) out_of_order += 1.0;
  }
  MPI_Sum_Scalar(out_of_order, world);

  Summary s;
  s.largest_attached = largest;
  s.smallest_detached = smallest < none ? smallest : 0.0;
  if (s.largest_attached > 0.0 && s.smallest_detached > 0.0) {
    s.critical_diameter = std::sqrt(s.largest_attached * s.smallest_detached);
  }
  s.attached = sums[0];
  s.detached = sums[1];
  s.out_of_order = out_of_order;
  s.kinetic = sums[2];
  s.potential = sums[3];
  s.dissipated = sums[4];
  s.work = sums[5];
  s.energy_residual = residual[0];
  s.momentum_residual = residual[1];
  return s;
}

/// Grains that left the box are gone without a word from LIGGGHTS; sizes may all stay or all leave.
void FixKatDrop::check_complete(const Summary& s) const {
  const double lost = taking_part_ - s.attached - s.detached;
  if (lost > 0.5) {
    stop("box; given: " + std::to_string(std::lround(lost)) + " of " +
         std::to_string(std::lround(taking_part_)) +
         " grains left it and were deleted; allowed: all grains inside until the end; "
         "to do: 'boundary m m m', or a box that is deeper along the fall");
  }
  if (s.critical_diameter > 0.0 || comm->me != 0) return;
  const std::string message =
      std::string("fix kat/drop: the sizes do not bracket the critical diameter: ") +
      (s.attached > 0.0 ? "every grain stayed; add larger grains"
                        : "every grain left; add smaller ones");
  error->warning(FLERR, message.c_str());
}

void FixKatDrop::write_results(const Summary& s) const {
  if (options_.results_file.empty()) return;
  std::vector<KatGrainResult> grains;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* state = array_atom[i];
    if (!(atom->mask[i] & groupbit) || state[kTakesPart] == 0.0) continue;
    grains.push_back({static_cast<double>(atom->tag[i]), 2.0 * atom->radius[i], state[kAttached],
                      state[kSpeed], state[kEnergyResidual], state[kMomentumResidual]});
  }
  KatResults results;
  results.impact_velocity_m_s = options_.velocity_m_s;
  results.critical_diameter_m = s.critical_diameter;
  results.largest_attached_m = s.largest_attached;
  results.smallest_detached_m = s.smallest_detached;
  results.out_of_order = static_cast<long>(s.out_of_order);
  results.steps = static_cast<long>(update->ntimestep - start_step_);
  results.time_step_s = update->dt;
  results.impact_step = static_cast<long>(impact_step_);
  results.grains = gather(grains, world);
  if (comm->me != 0) return;
  try {
    write(results, options_.results_file);
  } catch (const InvalidInput& problem) {
    error->one(FLERR, problem.what());
  }
}

double FixKatDrop::compute_scalar() { return summarize().critical_diameter; }

double FixKatDrop::compute_vector(int n) {
  switch (n) {
    case 0:
      return static_cast<double>(phase_);
    case 7:
      return time_since_impact();
    case 8:
      return options_.moving_frame ? plate_half_speed_ : 0.0;
    case 9:
      return deceleration_now();
    default:
      break;
  }
  const Summary s = summarize();
  const double values[] = {0,
                           s.critical_diameter,
                           s.largest_attached,
                           s.smallest_detached,
                           s.attached,
                           s.detached,
                           s.out_of_order,
                           0,
                           0,
                           0,
                           s.energy_residual,
                           s.momentum_residual,
                           s.kinetic,
                           s.potential,
                           s.dissipated,
                           s.work};
  return values[n];
}

}  // namespace powderlink::host
