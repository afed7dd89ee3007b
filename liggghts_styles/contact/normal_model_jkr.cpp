// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/contact/normal_model_jkr.h"

#include <algorithm>
#include <cstring>

#include "compute_pair_gran_local.h"

#include "base/invalid_input.h"
#include "liggghts_styles/contact/fix_adhesion_effect.h"
#include "liggghts_styles/host/private_access.h"
#include "liggghts_styles/host/stop_all.h"

POWDERLINK_PRIVATE_MEMBER(MeshPrecision, LAMMPS_NS::FixMesh, precision_, double)

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

constexpr double kStretchMargin = 1.05;  // of the contact distance over the tear-off gap
constexpr double kRateStretch = 25.0;    // longest neck of a rate-dependent edge over JKR's
constexpr double kLargestPlausibleEnergy = 10.0;  // J/m^2; dry solids have 0.01 to 1
constexpr double kMeshPrecisionOfRadius = 1e-6;   // edges must be sharp on the scale of the grains

constexpr double kDefaultMeshPrecision = 1e-8;  // of LIGGGHTS, where fix mesh/surface names none

double precision_m(FixMeshSurface* mesh) {
  const double given = mesh->*pointer_to(MeshPrecision());
  return given > 0.0 ? given : kDefaultMeshPrecision;
}

}  // namespace

JkrNormalModel::JkrNormalModel(LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* model)
    : Pointers(lmp), is_wall_(model->is_wall()), parent_(history) {
  pair_ = dynamic_cast<PairGran*>(history);
  history_offset_ = history->add_history_value(kRootHistory, "0");
  model->add_history_offset(kRootHistory, history_offset_);
}

void JkrNormalModel::registerSettings(Settings& settings) {
  settings.registerOnOff("tangential_damping", tangential_damping_, true);
  settings.registerOnOff("limitForce", limit_force_, false);
}

void JkrNormalModel::postSettings() {
  if (limit_force_) {
    stop_all(lmp, FLERR, nullptr,
             "model jkr: limitForce; given: limitForce on; "
             "allowed: off, because it would cut the attraction that the model is made for; "
             "to do: remove 'limitForce on'");
  }
}

double JkrNormalModel::property(PropertyRegistry& registry, const char* name, int i, int j) const {
  const int n = registry.max_type();
  auto* fix = static_cast<FixPropertyGlobal*>(modify->find_fix_property(
      name, "property/global", "peratomtypepair", n, n, "model jkr", false));
  if (fix == nullptr) {
    const std::string size = std::to_string(n);
    stop_all(lmp, FLERR, nullptr,
             std::string("model jkr: ") + name +
                 "; given: no fix property/global of that name; allowed: a matrix for " + size +
                 " types; to do: fix ID all property/global " + name + " peratomtypepair " + size +
                 " ...");
  }
  return fix->compute_array(i - 1, j - 1);
}

void JkrNormalModel::check_host() const {
  if (force->cg_active()) {
    stop_all(lmp, FLERR, nullptr,
             "model jkr: coarse graining; given: 'coarsegraining' in the script; allowed: none, "
             "the adhesion of a parcel is not that of its grains; to do: remove 'coarsegraining'");
  }
  if (!atom->sphere_flag || atom->shapetype_flag) {
    stop_all(lmp, FLERR, nullptr,
             "model jkr: particle shape; given: non-spherical particles; "
             "allowed: spheres; to do: use atom_style granular or sphere");
  }
}

void JkrNormalModel::connectToProperties(PropertyRegistry& registry) {
  check_host();
  registry.registerProperty("Yeff", &MODEL_PARAMS::createYeff);
  registry.registerProperty("Geff", &MODEL_PARAMS::createGeff);
  registry.registerProperty("betaeff", &MODEL_PARAMS::createBetaEff);
  double** modulus = nullptr;
  double** shear_modulus = nullptr;
  double** beta = nullptr;
  registry.connect("Yeff", modulus, "model jkr");
  registry.connect("Geff", shear_modulus, "model jkr");
  registry.connect("betaeff", beta, "model jkr");

  effects_.clear();
  for (const physics::Effect* e :
       FixAdhesionEffect::active(lmp, FixAdhesionEffect::Reader::contact))
    effects_.push_back(e);

  const int n = registry.max_type();
  stride_ = n + 1;
  pairs_.assign(static_cast<std::size_t>(stride_) * stride_, JkrPair());
  rough_contacts_.assign(pairs_.size(), physics::AdhesiveContact());
  for (int i = 1; i <= n; ++i) {
    for (int j = 1; j <= n; ++j) {
      const double energy = property(registry, "workOfAdhesion", i, j);
      const std::string where =
          "model jkr: workOfAdhesion of types " + std::to_string(i) + " and " + std::to_string(j);
      if (!(energy >= 0.0)) {
        const std::string message = where + "; given: " + number_text(energy) +
                                    " J/m^2; allowed: >= 0; "
                                    "to do: correct the matrix of fix property/global";
        stop_all(lmp, FLERR, nullptr, message);
      }
      if (energy > kLargestPlausibleEnergy && i <= j && !is_wall_ && comm->me == 0) {
        const std::string message =
            where + " is " + number_text(energy) +
            " J/m^2, above 10 J/m^2. "
            "It is the work of adhesion of the interface (pull-off 1.5 pi Gamma R*), "
            "not a surface energy in other units; dry solids have 0.01 to 1 J/m^2";
        error->warning(FLERR, message.c_str());
      }
      JkrPair& pair = pairs_[i * stride_ + j];
      pair.modulus = modulus[i][j];
      pair.law = physics::JkrLaw(pair.modulus, energy);
      pair.normal_damping =
          -physics::kTwoSqrtFiveSixths * beta[i][j] * std::sqrt(2.0 * pair.modulus);
      pair.shear_stiffness = 8.0 * shear_modulus[i][j];
      pair.tangential_damping = tangential_damping_ ? -physics::kTwoSqrtFiveSixths * beta[i][j] *
                                                          std::sqrt(pair.shear_stiffness)
                                                    : 0.0;
      rough_contacts_[i * stride_ + j] = physics::AdhesiveContact(pair.law, effects_);
    }
  }
  check_wall(largest_stretch());
  const bool adhesive = std::any_of(pairs_.begin(), pairs_.end(),
                                    [](const JkrPair& pair) { return pair.law.adhesive(); });
  if (adhesive && !is_wall_ && !warned_) warn_of_overlaps();
}

/// Parts of LIGGGHTS that take a contact for an overlap, without a word about the others.
void JkrNormalModel::warn_of_overlaps() {
  warned_ = true;
  if (comm->me != 0) return;
  const auto warn = [this](const std::string& who, const std::string& what) {
    error->warning(FLERR, ("model jkr: " + who + " " + what).c_str());
  };
  for (int i = 0; i < modify->ncompute; ++i) {
    Compute* compute = modify->compute[i];
    const std::string who = std::string("compute ") + compute->id;
    if (std::strcmp(compute->style, "contact/atom") == 0) {
      warn(who,
           "contact/atom does not count grains that a neck holds across a gap; "
           "compute contact/atom/gran does");
    }
    auto* local = dynamic_cast<ComputePairGranLocal*>(compute);
    if (local != nullptr && local->offset_area() >= 0) {
      warn(who,
           "contactArea is that of spheres that intersect, negative in a neck; "
           "the contact's area is pi h^4, h from keyword history (jkr_root_contact_radius)");
    }
  }
  for (int i = 0; i < modify->nfix; ++i) {
    if (std::strncmp(modify->fix[i]->style, "heat/gran", 9) != 0) continue;
    warn(std::string("fix ") + modify->fix[i]->id,
         "heat/gran conducts through overlaps only, not through a neck across a gap");
  }
}

/// Longest neck [m]; also asks LIGGGHTS to look for contacts out to there.
double JkrNormalModel::largest_stretch() const {
  double largest_radius = 0.0;
  double smallest_radius = 0.0;
  modify->max_min_rad(largest_radius, smallest_radius);
  if (largest_radius <= 0.0) return 0.0;
  double rate = 1.0;
  for (const physics::Effect* e : effects_) {
    if (e->rate_dependent()) rate = kRateStretch;
  }
  double ratio = 0.0;
  double gap = 0.0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    // Effects may give small spheres more Gamma than large ones: both ends count.
    for (const double radius : {smallest_radius, largest_radius}) {
      const physics::JkrLaw law = effects_.empty() ? pairs_[i].law : rough_contacts_[i].law(radius);
      ratio = std::max(ratio, -law.tear_off_overlap_m(radius) / radius);
      gap = std::max(gap, -law.tear_off_overlap_m(radius));
    }
  }
  neighbor->register_contact_dist_factor(1.0 + kStretchMargin * rate * ratio);
  return rate * gap;
}

void JkrNormalModel::check_wall(double largest_gap) const {
  auto* wall = dynamic_cast<FixWallGran*>(parent_);
  if (wall == nullptr) return;
  if (!wall->is_mesh_wall()) {
    if (neighbor->skin < kStretchMargin * largest_gap) {
      const std::string message =
          "model jkr on a primitive wall: neighbor skin; given: " + number_text(neighbor->skin) +
          " m; allowed: above the tear-off gap of the longest neck, " + number_text(largest_gap) +
          " m, or contacts would be lost; to do: neighbor " + number_text(2.0 * largest_gap) +
          " bin";
      stop_all(lmp, FLERR, wall, message);
    }
    return;
  }
  double largest_radius = 0.0;
  double smallest_radius = 0.0;
  modify->max_min_rad(largest_radius, smallest_radius);
  for (int i = 0; i < wall->n_meshes(); ++i) {
    FixMeshSurface* mesh = wall->mesh_list()[i];
    if (largest_radius > 0.0 && precision_m(mesh) > kMeshPrecisionOfRadius * smallest_radius) {
      const std::string message = std::string("model jkr on mesh '") + mesh->id +
                                  "': precision; given: " + number_text(precision_m(mesh)) +
                                  " m (LIGGGHTS's default is 1e-8); allowed: at most " +
                                  number_text(kMeshPrecisionOfRadius * smallest_radius) +
                                  " m, or grains of this size get wrong forces at triangle edges; "
                                  "to do: add 'precision 1e-12' to fix mesh/surface";
      stop_all(lmp, FLERR, wall, message);
    }
  }
}

void JkrNormalModel::complete_pair_geometry(SurfacesIntersectData& contact) const {
  const int i = contact.i;
  const int j = contact.j;
  contact.r = std::sqrt(contact.rsq);
  contact.rinv = 1.0 / contact.r;
  for (int k = 0; k < 3; ++k) contact.en[k] = contact.delta[k] * contact.rinv;
  contact.omega_i = atom->omega[i];
  contact.omega_j = atom->omega[j];
  contact.mi = atom->rmass[i];
  contact.mj = atom->rmass[j];
  if (pair_->fr_pair() != nullptr) {
    const double* body_mass = pair_->mr_pair();
    if (body_mass[i] > 0.0) contact.mi = body_mass[i];
    if (body_mass[j] > 0.0) contact.mj = body_mass[j];
  }
  contact.meff = contact.mi * contact.mj / (contact.mi + contact.mj);
  if (atom->mask[i] & pair_->freeze_group_bit()) contact.meff = contact.mj;
  if (atom->mask[j] & pair_->freeze_group_bit()) contact.meff = contact.mi;
}

JkrNormalModel::State JkrNormalModel::advance_with_effects(SurfacesIntersectData& contact,
                                                           const JkrPair& pair, double radius,
                                                           double& memory, bool advances) const {
  const physics::AdhesiveContact& rough = rough_contacts_[contact.itype * stride_ + contact.jtype];
  const physics::JkrLaw law = rough.law(radius);
  const double root =
      rough.advance(law, contact.deltan, radius, memory, advances ? update->dt : 0.0);
  if (root == 0.0) {
    if (memory == 0.0) return State::none;
    contact.Fn = advances && !rough.rate_dependent() ? tear_off_force(contact, law, radius) : 0.0;
    return end_contact(memory, advances);
  }
  if (advances) memory = root;
  finish(contact, pair, root, rough.force_N(law, contact.deltan, radius, root),
         law.pull_off_force_N(radius));
  return State::live;
}

}  // namespace powderlink::host
