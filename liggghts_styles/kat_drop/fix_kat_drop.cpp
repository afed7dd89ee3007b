// SPDX-License-Identifier: GPL-3.0-or-later
/// The protocol of fix kat/drop: settle, stop, watch.
#include <algorithm>
#include <cmath>

#include "liggghts_styles/host/liggghts_headers.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"

#include "base/invalid_input.h"
#include "liggghts_styles/contact/fix_adhesion_effect.h"
#include "liggghts_styles/host/stop_all.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr double kSettledSpeed =
    1e-8;  // of the impact speed: its cross term enters the energy twice
constexpr double kSettledEnergy = 1e-12;  // of the impact energy, left in the contact spring
constexpr int kSettleCheckEvery = 20;     // steps
constexpr int kSettleChunk = 1000;        // steps between two looks of kat/run

}  // namespace

FixKatDrop::FixKatDrop(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  try {
    options_ = KatDropOptions::parse(narg, arg);
  } catch (const InvalidInput& problem) {
    stop(problem.what());
  }
  plate_position_ = options_.plate_position;

  scalar_flag = vector_flag = peratom_flag = 1;
  size_vector = 16;
  size_peratom_cols = kReported;
  global_freq = peratom_freq = 1;
  extscalar = extvector = 0;
  restart_global = restart_peratom = 1;
  create_attribute = 1;
  nevery = 1;
  time_depend = 1;

  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
}

FixKatDrop::~FixKatDrop() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(array_atom);
}

void FixKatDrop::stop(const std::string& message) const { stop_all(lmp, FLERR, this, message); }

int FixKatDrop::setmask() {
  // PRE_EXCHANGE: without it LIGGGHTS does not call setup_pre_exchange().
  return FixConst::PRE_EXCHANGE | FixConst::POST_FORCE | FixConst::END_OF_STEP;
}

physics::Material FixKatDrop::material(int type) const {
  const auto value = [&](const char* name) {
    return static_cast<FixPropertyGlobal*>(modify->find_fix_property(name, "property/global",
                                                                     "peratomtype", atom->ntypes, 0,
                                                                     style))
        ->compute_vector(type - 1);
  };
  physics::Material m;
  m.name = "type " + std::to_string(type);
  m.youngs_modulus_Pa = value("youngsModulus");
  m.poissons_ratio = value("poissonsRatio");
  m.density_kg_m3 = 1.0;  // of the grain, set where it is known
  return m;
}

double FixKatDrop::pair_property(const char* name, int i, int j) const {
  return static_cast<FixPropertyGlobal*>(modify->find_fix_property(name, "property/global",
                                                                   "peratomtypepair", atom->ntypes,
                                                                   atom->ntypes, style))
      ->compute_array(i - 1, j - 1);
}

void FixKatDrop::init() {
  contacts_ = std::make_unique<PlateContacts>(lmp, this, options_.wall_id);
  if (modify->n_fixes_style("gravity") > 0) {
    stop(
        "gravity; given: a fix gravity beside fix kat/drop; "
        "allowed: one of them, because the test must know what pulls; "
        "to do: remove fix gravity and use the keyword gravity");
  }
  const std::vector<const physics::Effect*> effects =
      FixAdhesionEffect::active(lmp, FixAdhesionEffect::Reader::drop);
  gap_forces_ = physics::GapForces(effects);
  for (const physics::Effect* effect : effects) {
    if (!effect->stop()) continue;
    if (options_.stop_given) {
      stop(
          "stop; given: the keyword and an effect that stops the plate; "
          "allowed: one of them; to do: remove the keyword 'stop' or the fix adhesion/effect");
    }
    options_.stop = *effect->stop();
  }
  const int plate = contacts_->plate_type();
  laws_.assign(atom->ntypes + 1, physics::AdhesiveContact());
  for (int t = 1; t <= atom->ntypes; ++t) {
    laws_[t] = physics::AdhesiveContact(
        physics::JkrLaw(physics::effective_youngs_modulus_Pa(material(t), material(plate)),
                        pair_property("workOfAdhesion", t, plate)),
        effects);
  }
}

physics::JkrLaw FixKatDrop::law_of(int type, double radius) const {
  return laws_[type].law(radius);
}

double FixKatDrop::gap_m(int i) const {
  return (atom->x[i][options_.axis] - plate_position_) * options_.direction - atom->radius[i];
}

double FixKatDrop::contact_period_s(int i) const {
  const double radius = atom->radius[i];
  const physics::JkrLaw law = law_of(atom->type[i], radius);
  // Without adhesion there is no equilibrium; Hertz at 1 % overlap gives the time scale.
  const double stiffness = law.adhesive() ? law.equilibrium_stiffness_N_m(radius)
                                          : 2.0 * law.effective_modulus_Pa() * 0.1 * radius;
  return 2.0 * physics::JkrLaw::kPi * std::sqrt(atom->rmass[i] / stiffness);
}

void FixKatDrop::setup(int /*vflag*/) {
  if (phase_ == Phase::settle) check_before_run();
  // Forces of this fix at the first step; nothing is counted or moved.
  post_force(0);
}

double FixKatDrop::time_since_impact() const {
  return phase_ == Phase::settle
             ? 0.0
             : static_cast<double>(update->ntimestep - impact_step_) * update->dt;
}

double FixKatDrop::deceleration_now() const {
  if (phase_ == Phase::settle) return 0.0;
  return options_.stop.deceleration_m_s2(time_since_impact(), options_.velocity_m_s);
}

void FixKatDrop::post_force(int /*vflag*/) {
  const int k = options_.axis;
  const double deceleration = deceleration_now();
  const bool counts = !update->setupflag && phase_ != Phase::settle;
  if (options_.moving_frame && counts) {
    plate_position_ += options_.direction * plate_half_speed_ * update->dt;
    plate_half_speed_ -= deceleration * update->dt;
  }
  const double acceleration = options_.gravity_m_s2 + (options_.moving_frame ? 0.0 : deceleration);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double gap = gap_m(i);
    double* state = array_atom[i];
    if (gap <= 0.0) {
      state[kBridge] = 1.0;
    } else if (bridged(i) && gap > gap_forces_.bridge_range_m(atom->radius[i])) {
      state[kBridge] = 0.0;
    }
    const double own =
        atom->rmass[i] * acceleration + gap_forces_.force_N(gap, atom->radius[i], bridged(i));
    if (counts) account(i, own, gap);
    atom->f[i][k] += options_.direction * own;
    if (phase_ == Phase::settle && !update->setupflag) {
      const double period = contact_period_s(i);
      const double critical = 4.0 * physics::JkrLaw::kPi * atom->rmass[i] / period;
      for (int d = 0; d < 3; ++d) atom->f[i][d] -= critical * atom->v[i][d];
    }
  }
}

bool FixKatDrop::settled() const {
  double worst = 0.0;
  const int k = options_.axis;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit) || contacts_->root(i) == 0.0) continue;
    const double m = atom->rmass[i];
    const double energy = 0.5 * m * options_.velocity_m_s * options_.velocity_m_s;
    const double stiffness =
        law_of(atom->type[i], atom->radius[i]).equilibrium_stiffness_N_m(atom->radius[i]);
    worst = std::max(worst, std::fabs(atom->v[i][k]) / (kSettledSpeed * options_.velocity_m_s));
    worst = std::max(worst,
                     0.5 * atom->f[i][k] * atom->f[i][k] / stiffness / (kSettledEnergy * energy));
  }
  MPI_Max_Scalar(worst, world);
  return worst < 1.0;
}

void FixKatDrop::end_of_step() {
  if (phase_ == Phase::over) return;
  if (phase_ == Phase::settle) {
    const bigint steps = update->ntimestep - start_step_;
    if (steps % kSettleCheckEvery != 0) return;
    if (settled()) {
      begin_impact();
    } else if (static_cast<double>(steps) * update->dt > settle_limit_s_) {
      stop("settling; given: " + number_text(settle_limit_s_) +
           " s; allowed: the grains must come to rest on the plate within it; "
           "to do: raise the keyword settle, or check that adhesion can carry the grains' weight");
    }
    return;
  }
  const double t = time_since_impact();
  if (phase_ == Phase::stop && t >= options_.stop.duration_s()) phase_ = Phase::watch;
  if (phase_ == Phase::watch && t >= options_.stop.duration_s() + watch_s_) {
    phase_ = Phase::over;
    const Summary summary = summarize();
    check_complete(summary);
    write_results(summary);
  }
}

/// A grain that adhesion cannot carry drops off while the others settle.
void FixKatDrop::check_fallen() const {
  double counts[2] = {0.0, 0.0};  // placed on the plate; fallen off
  double largest_held = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit) || array_atom[i][kTakesPart] == 0.0) continue;
    const bool held = contacts_->root(i) > 0.0;
    counts[0] += 1.0;
    counts[1] += held ? 0.0 : 1.0;
    if (held) largest_held = std::max(largest_held, 2.0 * atom->radius[i]);
  }
  MPI_Sum_Vector(counts, 2, world);
  MPI_Max_Scalar(largest_held, world);
  if (counts[0] == 0.0) {
    stop(
        "start; given: no grain on the plate; "
        "allowed: grains within a tenth of their radius of it; "
        "to do: use populate, or place the grains beside the plate on the side to which it falls");
  }
  if (counts[1] > 0.0) {
    stop("settling; given: " + number_text(counts[1]) + " of " + number_text(counts[0]) +
         " grains fell off under their weight; "
         "allowed: grains that adhesion carries; to do: use smaller grains" +
         (largest_held > 0.0 ? " (" + number_text(largest_held * 1e6) + " um holds)"
                             : std::string()) +
         ", a larger workOfAdhesion or gravity 0");
  }
}

void FixKatDrop::begin_impact() {
  check_fallen();
  phase_ = Phase::stop;
  impact_step_ = update->ntimestep;
  const int k = options_.axis;
  const double kick = options_.stop.kick_m_s(options_.velocity_m_s);
  // In the moving frame plate and grains arrive with the impact speed, and the plate alone is
  // kicked.
  const double grain_speed = options_.moving_frame ? options_.velocity_m_s : kick;
  if (options_.moving_frame) {
    plate_half_speed_ = options_.velocity_m_s - kick - 0.5 * update->dt * deceleration_now();
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    double* state = array_atom[i];
    const double root = contacts_->root(i);
    for (int d = 0; d < 3; ++d) atom->v[i][d] = atom->omega[i][d] = 0.0;
    atom->v[i][k] = options_.direction * grain_speed;
    state[kTakesPart] = root > 0.0 ? 1.0 : 0.0;
    taking_part_ += state[kTakesPart];
    state[kAttached] = state[kTakesPart];
    state[kBridge] = state[kTakesPart];
    state[kKineticAtImpact] = -1.0;  // taken in the first step
    state[kContactWork] = state[kOwnWork] = state[kImpulse] = 0.0;
    state[kContactEnergyAtImpact] =
        root > 0.0 ? law_of(atom->type[i], atom->radius[i]).energy_J(root, atom->radius[i]) : 0.0;
  }
  MPI_Sum_Scalar(taking_part_, world);
}

int FixKatDrop::next_chunk_steps() const {
  if (phase_ == Phase::settle) return kSettleChunk;
  const double left = options_.stop.duration_s() + watch_s_ - time_since_impact();
  return std::max(1, static_cast<int>(std::ceil(left / update->dt)));
}

}  // namespace powderlink::host
