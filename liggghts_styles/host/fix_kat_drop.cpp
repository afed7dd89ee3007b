// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/fix_kat_drop.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

#include "host/liggghts_headers.h"

#include "domain.h"
#include "input.h"
#include "neigh_list.h"

#include "host/fix_adhesion_effect.h"
#include "host/kat_population.h"
#include "host/kat_results.h"
#include "models/kat_theory.h"
#include "models/rayleigh_time.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr double kSettledSpeed =
    1e-8;  // of the impact speed: its cross term enters the energy twice
constexpr double kSettledEnergy = 1e-12;  // of the impact energy, left in the contact spring
constexpr int kSettleCheckEvery = 20;     // steps
constexpr int kSettleChunk = 1000;        // steps between two looks of kat/run
constexpr double kSettlePeriods = 200.0;  // default limit; critical damping needs a few
constexpr double kWatchPeriods = 6.0;     // an undamped contact decides in its first swing
constexpr double kPlaceWithin = 0.1;      // radii from the plate: moved to equilibrium
constexpr double kDeepestStart = 0.1;     // radii: a grain that overlaps the plate more is an error
constexpr double kAllowedOverlap = 0.01;  // radii, of two grains at the start

std::string text(double value) {
  std::ostringstream s;
  s << value;
  return s.str();
}

}  // namespace

struct FixKatDrop::Summary {
  double largest_attached = 0.0, smallest_detached = 0.0, critical_diameter = 0.0;
  double attached = 0, detached = 0, out_of_order = 0;
  double energy_residual = 0.0, momentum_residual = 0.0;
  double kinetic = 0.0, potential = 0.0, dissipated = 0.0, work = 0.0;
};

FixKatDrop::FixKatDrop(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  try {
    options_ = KatDropOptions::parse(narg, arg);
  } catch (const InvalidInput& problem) {
    stop_all(problem.what());
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

void FixKatDrop::stop_all(const std::string& message) const {
  error->fix_error(FLERR, const_cast<FixKatDrop*>(this), message.c_str());
  std::abort();  // not reached: fix_error ends all ranks
}

int FixKatDrop::setmask() {
  // PRE_EXCHANGE: without it LIGGGHTS does not call setup_pre_exchange().
  return FixConst::PRE_EXCHANGE | FixConst::POST_FORCE | FixConst::END_OF_STEP;
}

void FixKatDrop::post_create() {
  contacts_ = std::make_unique<PlateContacts>(lmp, this, options_.wall_id);
  if (options_.moving_frame) prepare_moving_plate();
  if (options_.populate_type > 0 && !restarted_) populate();
}

/// The mesh is moved by LIGGGHTS's own fix move/mesh, which asks this fix for the speed.
void FixKatDrop::prepare_moving_plate() {
  if (!contacts_->wall().is_mesh_wall()) {
    stop_all(
        "frame moving; given: a primitive wall; allowed: a mesh wall; to do: use fix mesh/surface "
        "and fix wall/gran ... mesh, or frame plate");
  }
  const std::string name(id);
  const std::string sign = options_.direction > 0 ? "" : "-";
  input->one(("variable " + name + "_plate_speed equal " + sign + "f_" + name + "[9]").c_str());
  input->one(("variable " + name + "_no_speed equal 0").c_str());
  std::string line = "fix " + name + "_plate all move/mesh mesh " +
                     contacts_->wall().mesh_list()[0]->id + " linear/variable";
  for (int k = 0; k < 3; ++k) {
    line += " v_" + name + (k == options_.axis ? "_plate_speed" : "_no_speed");
  }
  input->one(line.c_str());
}

void FixKatDrop::populate() {
  const double largest =
      *std::max_element(options_.diameters_m.begin(), options_.diameters_m.end());
  const auto grid = square_grid(options_.diameters_m.size(), kGridSpacing * largest);
  if (options_.populate_type > atom->ntypes) {
    stop_all("populate type; given: " + std::to_string(options_.populate_type) +
             "; allowed: 1 to " + std::to_string(atom->ntypes) +
             "; to do: correct the type or create_box");
  }
  const int k = options_.axis;
  const int u = (k + 1) % 3;
  const int v = (k + 2) % 3;
  const double half =
      0.5 * kGridSpacing * largest * std::ceil(std::sqrt(static_cast<double>(grid.size())));
  for (const int side : {u, v}) {
    if (domain->boxhi[side] - domain->boxlo[side] < 2.0 * half) {
      stop_all("populate; given: a box of " + text(domain->boxhi[side] - domain->boxlo[side]) +
               " m in direction " + "xyz"[side] + "; allowed: at least " + text(2.0 * half) +
               " m for " + std::to_string(grid.size()) +
               " grains; to do: enlarge the region of create_box");
    }
  }
  const int first = atom->nlocal;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const double radius = 0.5 * options_.diameters_m[n];
    double x[3];
    x[u] = 0.5 * (domain->boxlo[u] + domain->boxhi[u]) + grid[n].u;
    x[v] = 0.5 * (domain->boxlo[v] + domain->boxhi[v]) + grid[n].v;
    x[k] = plate_position_ + options_.direction * radius;
    bool mine = true;
    for (int d = 0; d < 3; ++d) mine = mine && x[d] >= domain->sublo[d] && x[d] < domain->subhi[d];
    if (!mine) continue;
    atom->avec->create_atom(options_.populate_type, x);
    const int i = atom->nlocal - 1;
    atom->mask[i] |= groupbit;
    atom->radius[i] = radius;
    atom->density[i] = options_.density_kg_m3;
    atom->rmass[i] = models::sphere_mass_kg(radius, options_.density_kg_m3);
  }
  for (int m = 0; m < modify->nfix; ++m) {
    if (!modify->fix[m]->create_attribute) continue;
    modify->fix[m]->pre_set_arrays();
    for (int i = first; i < atom->nlocal; ++i) modify->fix[m]->set_arrays(i);
  }
  // This fix is not in the list yet when it creates its grains on first use.
  for (int i = first; i < atom->nlocal; ++i) set_arrays(i);
  bigint local = atom->nlocal;
  const bigint before = atom->natoms;
  MPI_Allreduce(&local, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (atom->natoms - before != static_cast<bigint>(grid.size())) {
    stop_all("populate; given: " + std::to_string(grid.size()) + " grains, of which " +
             std::to_string(atom->natoms - before) +
             " lie in the box; allowed: all; to do: enlarge the box along the fall as well");
  }
  atom->tag_extend();
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

models::Material FixKatDrop::material(int type) const {
  const auto value = [&](const char* name) {
    return static_cast<FixPropertyGlobal*>(modify->find_fix_property(name, "property/global",
                                                                     "peratomtype", atom->ntypes, 0,
                                                                     style))
        ->compute_vector(type - 1);
  };
  models::Material m;
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
    stop_all(
        "gravity; given: a fix gravity beside fix kat/drop; allowed: one of them, because the test "
        "must know what pulls; to do: remove fix gravity and use the keyword gravity");
  }
  effects_ = FixAdhesionEffect::active(lmp);
  for (const models::Effect* effect : effects_) {
    if (!effect->stop()) continue;
    if (options_.stop_given) {
      stop_all(
          "stop; given: the keyword and an effect that stops the plate; allowed: one of them; to "
          "do: remove the keyword 'stop' or the fix adhesion/effect");
    }
    options_.stop = *effect->stop();
  }
  const int plate = contacts_->plate_type();
  laws_.assign(atom->ntypes + 1, models::AdhesiveContact());
  for (int t = 1; t <= atom->ntypes; ++t) {
    laws_[t] = models::AdhesiveContact(
        models::JkrLaw(models::effective_youngs_modulus_Pa(material(t), material(plate)),
                       pair_property("workOfAdhesion", t, plate)),
        effects_);
  }
}

models::JkrLaw FixKatDrop::law_of(int type, double radius) const { return laws_[type].law(radius); }

double FixKatDrop::gap_m(int i) const {
  return (atom->x[i][options_.axis] - plate_position_) * options_.direction - atom->radius[i];
}

double FixKatDrop::gap_force_N(int i, double gap) const {
  double force = 0.0;
  for (const models::Effect* e : effects_) {
    if (e->formed_by_touch() && array_atom[i][kBridge] == 0.0) continue;
    force += e->gap_force_N(gap, atom->radius[i]);
  }
  return force;
}

double FixKatDrop::gap_energy_J(int i, double gap) const {
  double energy = 0.0;
  for (const models::Effect* e : effects_) {
    if (e->formed_by_touch() && array_atom[i][kBridge] == 0.0) continue;
    energy += e->gap_energy_J(gap, atom->radius[i]);
  }
  return energy;
}

double FixKatDrop::contact_period_s(int type, double radius) const {
  const models::JkrLaw law = law_of(type, radius);
  const double density = options_.density_kg_m3 > 0.0 ? options_.density_kg_m3 : 1000.0;
  // Without adhesion there is no equilibrium; Hertz at 1 % overlap gives the time scale.
  const double stiffness = law.adhesive() ? law.equilibrium_stiffness_N_m(radius)
                                          : 2.0 * law.effective_modulus_Pa() * 0.1 * radius;
  return 2.0 * models::JkrLaw::kPi * std::sqrt(models::sphere_mass_kg(radius, density) / stiffness);
}

/// Before the first neighbour list, so that grains may be moved.
void FixKatDrop::setup_pre_exchange() {
  if (placed_) return;
  placed_ = true;
  start_step_ = update->ntimestep;
  double period = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->mask[i] & groupbit) {
      period = std::max(period, contact_period_s(atom->type[i], atom->radius[i]));
    }
  }
  MPI_Max_Scalar(period, world);
  if (period == 0.0) {
    stop_all(
        "group of the fix; given: no particles; allowed: at least one grain; to do: use populate, "
        "or "
        "create the grains before the run");
  }
  settle_limit_s_ =
      options_.settle_limit_s > 0.0 ? options_.settle_limit_s : kSettlePeriods * period;
  watch_s_ = options_.watch_s > 0.0 ? options_.watch_s : kWatchPeriods * period;
  place_at_equilibrium();
}

void FixKatDrop::place_at_equilibrium() {
  double deepest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double radius = atom->radius[i];
    const double gap = gap_m(i);
    deepest = std::max(deepest, -gap / radius);
    if (std::fabs(gap) > kPlaceWithin * radius) continue;
    const models::JkrLaw law = law_of(atom->type[i], radius);
    const double a0 = law.equilibrium_contact_radius_m(radius);
    atom->x[i][options_.axis] =
        plate_position_ + options_.direction * (radius - a0 * a0 / (3.0 * radius));
  }
  MPI_Max_Scalar(deepest, world);
  if (deepest > kDeepestStart) {
    stop_all("start; given: a grain that overlaps the plate by " + text(deepest) +
             " of its radius; allowed: up to " + text(kDeepestStart) +
             "; to do: put the grains beside the plate, on the side to which it falls");
  }
}

void FixKatDrop::check_before_run() {
  double fraction = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    models::Material m = material(atom->type[i]);
    m.density_kg_m3 = atom->density[i];
    fraction = std::max(fraction, update->dt / models::rayleigh_time_s(atom->radius[i], m));
  }
  MPI_Max_Scalar(fraction, world);
  if (fraction > models::kLargestRayleighFraction) {
    stop_all(
        "time step; given: " + text(update->dt) + " s, " + text(fraction) +
        " Rayleigh times of the smallest grain; allowed: up to 0.5, better 0.1; to do: timestep " +
        text(0.1 * update->dt / fraction));
  }

  NeighList* list = force->pair->list;
  double worst = 0.0;
  double worst_tags[2] = {0.0, 0.0};
  for (int ii = 0; ii < list->inum; ++ii) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; ++jj) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (!(atom->mask[i] & groupbit) || !(atom->mask[j] & groupbit)) continue;
      double r2 = 0.0;
      for (int k = 0; k < 3; ++k) r2 += std::pow(atom->x[i][k] - atom->x[j][k], 2);
      const double overlap = atom->radius[i] + atom->radius[j] - std::sqrt(r2);
      const double relative = overlap / std::min(atom->radius[i], atom->radius[j]);
      if (relative > worst) {
        worst = relative;
        worst_tags[0] = atom->tag[i];
        worst_tags[1] = atom->tag[j];
      }
    }
  }
  double everywhere = worst;
  MPI_Max_Scalar(everywhere, world);
  if (everywhere > kAllowedOverlap) {
    if (worst != everywhere) worst_tags[0] = worst_tags[1] = 0.0;
    MPI_Max_Vector(worst_tags, 2, world);
    stop_all("start; given: grains " + text(worst_tags[0]) + " and " + text(worst_tags[1]) +
             " overlap by " + text(everywhere) + " of the smaller radius; allowed: up to " +
             text(kAllowedOverlap) + "; to do: create them further apart");
  }
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
    if (!effects_.empty() && state[kBridge] != 0.0) {
      double range = 0.0;
      for (const models::Effect* e : effects_) {
        if (e->formed_by_touch()) range = std::max(range, e->range_m(atom->radius[i]));
      }
      if (gap > range) state[kBridge] = 0.0;
    } else if (gap <= 0.0) {
      state[kBridge] = 1.0;
    }
    const double own = atom->rmass[i] * acceleration + gap_force_N(i, gap);
    if (counts) account(i, own, gap);
    atom->f[i][k] += options_.direction * own;
    if (phase_ == Phase::settle && !update->setupflag) {
      const double period = contact_period_s(atom->type[i], atom->radius[i]);
      const double critical = 4.0 * models::JkrLaw::kPi * atom->rmass[i] / period;
      for (int d = 0; d < 3; ++d) atom->f[i][d] -= critical * atom->v[i][d];
    }
  }
}

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
  const double gap_energy = gap_energy_J(i, gap);
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
    const bool bound =
        gap_energy < 0.0 && 0.5 * m * state[kSpeed] * std::fabs(state[kSpeed]) + gap_energy < 0.0;
    state[kAttached] = bound ? 2.0 : 0.0;
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
      stop_all("settling; given: " + text(settle_limit_s_) +
               " s; allowed: the grains must come to rest on the plate within it; to do: raise the "
               "keyword "
               "settle, or check that adhesion can carry the grains' weight");
    }
    return;
  }
  const double t = time_since_impact();
  if (phase_ == Phase::stop && t >= options_.stop.duration_s()) phase_ = Phase::watch;
  if (phase_ == Phase::watch && t >= options_.stop.duration_s() + watch_s_) {
    phase_ = Phase::over;
    write_results(summarize());
  }
}

void FixKatDrop::begin_impact() {
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
    state[kAttached] = state[kTakesPart];
    state[kBridge] = state[kTakesPart];
    state[kKineticAtImpact] = -1.0;  // taken in the first step
    state[kContactWork] = state[kOwnWork] = state[kImpulse] = 0.0;
    state[kContactEnergyAtImpact] =
        root > 0.0 ? law_of(atom->type[i], atom->radius[i]).energy_J(root, atom->radius[i]) : 0.0;
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

int FixKatDrop::next_chunk_steps() const {
  if (phase_ == Phase::settle) return kSettleChunk;
  const double left = options_.stop.duration_s() + watch_s_ - time_since_impact();
  return std::max(1, static_cast<int>(std::ceil(left / update->dt)));
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

void FixKatDrop::grow_arrays(int nmax) {
  memory->grow(array_atom, nmax, kColumns, "kat/drop:state");
}

void FixKatDrop::copy_arrays(int i, int j, int /*delflag*/) {
  std::copy(array_atom[i], array_atom[i] + kColumns, array_atom[j]);
}

void FixKatDrop::set_arrays(int i) {
  std::fill(array_atom[i], array_atom[i] + kColumns, 0.0);
  array_atom[i][kKineticAtImpact] = -1.0;
}

int FixKatDrop::pack_exchange(int i, double* buf) {
  std::copy(array_atom[i], array_atom[i] + kColumns, buf);
  return kColumns;
}

int FixKatDrop::unpack_exchange(int nlocal, double* buf) {
  std::copy(buf, buf + kColumns, array_atom[nlocal]);
  return kColumns;
}

void FixKatDrop::write_restart(FILE* file) {
  const double list[] = {static_cast<double>(phase_),
                         static_cast<double>(start_step_),
                         static_cast<double>(impact_step_),
                         plate_position_,
                         plate_half_speed_,
                         settle_limit_s_,
                         watch_s_};
  if (comm->me != 0) return;
  const int size = sizeof(list);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(list, sizeof(list), 1, file);
}

void FixKatDrop::restart(char* buf) {
  double list[7];
  std::memcpy(list, buf, sizeof(list));
  phase_ = static_cast<Phase>(static_cast<int>(list[0]));
  start_step_ = static_cast<bigint>(list[1]);
  impact_step_ = static_cast<bigint>(list[2]);
  plate_position_ = list[3];
  plate_half_speed_ = list[4];
  settle_limit_s_ = list[5];
  watch_s_ = list[6];
  restarted_ = placed_ = true;
}

int FixKatDrop::pack_restart(int i, double* buf) {
  buf[0] = kColumns + 1;
  std::copy(array_atom[i], array_atom[i] + kColumns, buf + 1);
  return kColumns + 1;
}

void FixKatDrop::unpack_restart(int nlocal, int nth) {
  double** extra = atom->extra;
  int m = 0;
  for (int i = 0; i < nth; ++i) m += static_cast<int>(extra[nlocal][m]);
  std::copy(extra[nlocal] + m + 1, extra[nlocal] + m + 1 + kColumns, array_atom[nlocal]);
}

int FixKatDrop::size_restart(int /*nlocal*/) { return kColumns + 1; }
int FixKatDrop::maxsize_restart() { return kColumns + 1; }
double FixKatDrop::memory_usage() {
  return static_cast<double>(atom->nmax) * kColumns * sizeof(double);
}

}  // namespace powderlink::host
