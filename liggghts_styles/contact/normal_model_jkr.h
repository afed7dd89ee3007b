// SPDX-License-Identifier: GPL-3.0-or-later
/// \file normal_model_jkr.h
/// Normal model `jkr` of `pair_style gran` and `fix wall/gran`: physics of physics/contact/jkr_law.h and
/// physics/contact/normal_damping.h, made rough or rate-dependent by `fix adhesion/effect`.
///
/// Script:  pair_style gran model jkr [tangential ...] [rolling_friction ...]
///                                    [tangential_damping on|off]
/// Needs:   youngsModulus, poissonsRatio, coefficientRestitution as model hertz does, and
///          fix ID all property/global workOfAdhesion peratomtypepair N G11 G12 ...   [J/m^2]
///          (work of adhesion of the interface, not the surface energy of one solid).
/// History: one value per contact, sqrt(contact radius); 0 is "not in contact".
/// Tests: tests/liggghts_styles/contact_test.cpp, tests/liggghts_styles/bad_input_test.cpp
#pragma once

#include <memory>
#include <vector>

#include "liggghts_styles/host/liggghts_headers.h"
#include "physics/contact/friction_load.h"
#include "physics/contact/normal_damping.h"
#include "physics/effects/adhesive_contact.h"

namespace powderlink::host {

using LIGGGHTS::IContactHistorySetup;
using LIGGGHTS::ContactModels::ContactModelBase;
using LIGGGHTS::ContactModels::SurfacesIntersectData;

inline constexpr int kJkrModelId = 20;  ///< 13-63 are free among LIGGGHTS's 6-bit ids
inline constexpr const char* kRootHistory = "jkr_root_contact_radius";

/// What a pair of atom types needs in the inner loop.
struct JkrPair {
  physics::JkrLaw law;
  double normal_damping = 0.0;      ///< -2 sqrt(5/6) beta sqrt(2 E*); times s sqrt(m*) is gamma_n
  double tangential_damping = 0.0;  ///< the same with 8 G*
  double shear_stiffness = 0.0;     ///< 8 G*; times s^2 is k_t
  double modulus = 1.0;
};

class JkrNormalModel : protected LAMMPS_NS::Pointers {
 public:
  JkrNormalModel(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* model);

  void registerSettings(Settings& settings);
  void postSettings();
  void connectToProperties(PropertyRegistry& registry);

  double& root(const SurfacesIntersectData& contact) const {
    return contact.contact_history[history_offset_];
  }

  enum class State { none, live, torn };

  /// Advances the contact and sets force, stiffnesses, damping and the loads that limit friction.
  /// \return none: no force; live: all of it; torn: only Fn, the rest of the step in which the neck
  /// broke. Touch and tear-off make the force jump; weighting it with the part of the step that it
  /// acted keeps the work second order in the time step.
  State advance(SurfacesIntersectData& contact) const {
    const JkrPair& pair = pairs_[contact.itype * stride_ + contact.jtype];
    const double radius = contact.is_wall
                              ? contact.radi
                              : contact.radi * contact.radj / (contact.radi + contact.radj);
    double& memory = root(contact);
    const bool advances = contact.computeflag && contact.shearupdate;
    if (!effects_.empty()) return advance_with_effects(contact, pair, radius, memory, advances);

    const double overlap = contact.deltan;
    double root;
    double weight = 1.0;
    if (!pair.law.adhesive()) {
      if (overlap < 0.0) return end_contact(memory, advances);
      root = std::sqrt(std::sqrt(radius * overlap));
    } else if (memory > 0.0) {
      if (pair.law.torn(overlap, radius)) {
        contact.Fn = advances ? tear_off_force(contact, pair.law, radius) : 0.0;
        return end_contact(memory, advances);
      }
      root = pair.law.next_root(overlap, radius, memory);
    } else {
      if (overlap < 0.0) return State::none;
      root = pair.law.first_root(overlap, radius);
      const double travel = -contact.vn * update->dt;
      if (advances && overlap < travel) weight = 0.5 + overlap / travel;
    }
    if (advances) memory = root;
    finish(contact, pair, root, weight * pair.law.force_N(root, radius),
           pair.law.pull_off_force_N(radius));
    return State::live;
  }

  /// Fills in what pair_gran_base.h computes for overlapping pairs only.
  void complete_pair_geometry(SurfacesIntersectData& contact) const;

 private:
  static State end_contact(double& memory, bool advances) {
    if (advances) memory = 0.0;
    return State::torn;
  }

  /// The neck broke during the step: its force acted until then, and half a step is already paid.
  double tear_off_force(const SurfacesIntersectData& contact, const physics::JkrLaw& law,
                        double radius) const {
    const double travel = contact.vn * update->dt;
    if (travel <= 0.0) return 0.0;
    const double beyond = law.tear_off_overlap_m(radius) - contact.deltan;
    const double acted = std::fmax(0.0, 1.0 - beyond / travel);
    return (0.5 - acted) * kTearOffOverPullOff * law.pull_off_force_N(radius);
  }
  static constexpr double kTearOffOverPullOff = 5.0 / 9.0;

  void finish(SurfacesIntersectData& contact, const JkrPair& pair, double root, double force,
              double pull_off) const {
    const double root_mass = std::sqrt(contact.meff);
    contact.gamman = pair.normal_damping * root * root_mass;
    contact.gammat = pair.tangential_damping * root * root_mass;
    contact.kt = pair.shear_stiffness * root * root;
    contact.kn = 4.0 / 3.0 * pair.modulus * root * root;
    contact.Fn = force - contact.gamman * contact.vn;
    friction_load_ = physics::friction_load_N(contact.Fn, pull_off);
    rolling_load_ = physics::friction_load_N(force, pull_off);
  }

  State advance_with_effects(SurfacesIntersectData& contact, const JkrPair& pair, double radius,
                             double& memory, bool advances) const;
  void check_host() const;
  void check_wall(double largest_gap) const;
  void warn_of_overlaps();
  double largest_stretch() const;
  double property(PropertyRegistry& registry, const char* name, int i, int j) const;

 public:
  /// Loads of Thornton's friction limit for the contact that advance() just did [N]; as in
  /// LIGGGHTS, rolling model cdt takes the load without the dashpot.
  double friction_load() const { return friction_load_; }
  double rolling_load() const { return rolling_load_; }

 private:
  std::vector<JkrPair> pairs_;  ///< by (itype, jtype), LIGGGHTS types count from 1
  int stride_ = 0;
  int history_offset_ = -1;
  bool is_wall_;
  bool tangential_damping_ = true;
  bool limit_force_ = false;
  bool warned_ = false;
  IContactHistorySetup* parent_;
  LAMMPS_NS::PairGran* pair_ = nullptr;  ///< the parent, if it is not a wall
  mutable double friction_load_ = 0.0;
  mutable double rolling_load_ = 0.0;
  std::vector<const physics::Effect*> effects_;
  std::vector<physics::AdhesiveContact> rough_contacts_;  ///< as pairs_, only with effects
};

}  // namespace powderlink::host
