// SPDX-License-Identifier: GPL-3.0-or-later
/// fix kat/drop before its first step: grains, their places, the moving plate, checks.
#include <algorithm>
#include <cmath>

#include "liggghts_styles/host/liggghts_headers.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"

#include "domain.h"
#include "input.h"
#include "neigh_list.h"

#include "base/invalid_input.h"
#include "liggghts_styles/kat_drop/kat_population.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr double kSettlePeriods = 200.0;  // default limit; critical damping needs a few
constexpr double kWatchPeriods = 6.0;     // an undamped contact decides in its first swing
constexpr double kPlaceWithin = 0.1;      // radii from the plate: moved to equilibrium
constexpr double kDeepestStart = 0.1;     // radii: a grain that overlaps the plate more is an error
constexpr double kAllowedOverlap = 0.01;  // radii, of two grains at the start

}  // namespace

void FixKatDrop::post_create() {
  contacts_ = std::make_unique<PlateContacts>(lmp, this, options_.wall_id);
  if (options_.moving_frame && restarted_) {
    stop(
        "frame moving; given: a restart, where LIGGGHTS puts the mesh back to its first place; "
        "allowed: frame plate in runs that are restarted; "
        "to do: use frame plate, which gives the same result");
  }
  if (options_.moving_frame) prepare_moving_plate();
  if (options_.populate_type > 0 && !restarted_) populate();
}

/// The mesh is moved by LIGGGHTS's own fix move/mesh, which asks this fix for the speed.
void FixKatDrop::prepare_moving_plate() {
  if (!contacts_->wall().is_mesh_wall()) {
    stop(
        "frame moving; given: a primitive wall; allowed: a mesh wall; "
        "to do: use fix mesh/surface and fix wall/gran ... mesh, or frame plate");
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
    stop("populate type; given: " + std::to_string(options_.populate_type) + "; allowed: 1 to " +
         std::to_string(atom->ntypes) + "; to do: correct the type or create_box");
  }
  const int k = options_.axis;
  const int u = (k + 1) % 3;
  const int v = (k + 2) % 3;
  const double half =
      0.5 * kGridSpacing * largest * std::ceil(std::sqrt(static_cast<double>(grid.size())));
  for (const int side : {u, v}) {
    if (domain->boxhi[side] - domain->boxlo[side] < 2.0 * half) {
      stop("populate; given: a box of " + number_text(domain->boxhi[side] - domain->boxlo[side]) +
           " m in direction " + "xyz"[side] + "; allowed: at least " + number_text(2.0 * half) +
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
    atom->rmass[i] = physics::sphere_mass_kg(radius, options_.density_kg_m3);
  }
  for (int m = 0; m < modify->nfix; ++m) {
    if (!modify->fix[m]->create_attribute) continue;
    modify->fix[m]->pre_set_arrays();
    for (int i = first; i < atom->nlocal; ++i) modify->fix[m]->set_arrays(i);
  }
  bigint local = atom->nlocal;
  const bigint before = atom->natoms;
  MPI_Allreduce(&local, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (atom->natoms - before != static_cast<bigint>(grid.size())) {
    stop("populate; given: " + std::to_string(grid.size()) + " grains, of which " +
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

/// Before the first neighbour list, so that grains may be moved.
void FixKatDrop::setup_pre_exchange() {
  if (placed_) return;
  placed_ = true;
  start_step_ = update->ntimestep;
  double period = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->mask[i] & groupbit) {
      period = std::max(period, contact_period_s(i));
    }
  }
  MPI_Max_Scalar(period, world);
  if (period == 0.0) {
    stop(
        "group of the fix; given: no particles; allowed: at least one grain; to do: use populate, "
        "or create the grains before the run");
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
    const physics::JkrLaw law = law_of(atom->type[i], radius);
    const double a0 = law.equilibrium_contact_radius_m(radius);
    atom->x[i][options_.axis] =
        plate_position_ + options_.direction * (radius - a0 * a0 / (3.0 * radius));
  }
  MPI_Max_Scalar(deepest, world);
  if (deepest > kDeepestStart) {
    stop("start; given: a grain that overlaps the plate by " + number_text(deepest) +
         " of its radius; allowed: up to " + number_text(kDeepestStart) +
         "; to do: put the grains beside the plate, on the side to which it falls");
  }
}

void FixKatDrop::check_before_run() {
  double fraction = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    physics::Material m = material(atom->type[i]);
    m.density_kg_m3 = atom->density[i];
    // Here and not where it is placed: LIGGGHTS clears the state of a new fix in between.
    if (std::fabs(gap_m(i)) < kPlaceWithin * atom->radius[i]) array_atom[i][kTakesPart] = 1.0;
    fraction = std::max(fraction, update->dt / physics::rayleigh_time_s(atom->radius[i], m));
  }
  MPI_Max_Scalar(fraction, world);
  if (fraction > physics::kLargestRayleighFraction) {
    stop("time step; given: " + number_text(update->dt) + " s, " + number_text(fraction) +
         " Rayleigh times of the smallest grain; allowed: up to 0.5, better 0.1; to do: timestep " +
         number_text(0.1 * update->dt / fraction));
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
    stop("start; given: grains " + number_text(worst_tags[0]) + " and " +
         number_text(worst_tags[1]) + " overlap by " + number_text(everywhere) +
         " of the smaller radius; allowed: up to " + number_text(kAllowedOverlap) +
         "; to do: create them further apart");
  }
}

}  // namespace powderlink::host
