// SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_model_jkr.h
/// A LIGGGHTS contact model made of surface, `jkr`, tangential and rolling model, with a live neck.
///
/// LIGGGHTS calls surfacesIntersect() in overlap and surfacesClose() beyond it, and its own
/// tangential and rolling models drop their springs in surfacesClose(). A JKR contact lives on in
/// the gap, so a live neck takes the whole intersect path here, with the geometry that LIGGGHTS
/// leaves stale there filled in. Friction and rolling resistance are limited by the load that
/// presses the contact (physics/contact/friction_load.h), not by the net force: they read it through `Fn`
/// and `kn * deltan`.
/// Tests: tests/liggghts_styles/contact_test.cpp
#pragma once

#include "liggghts_styles/contact/normal_model_jkr.h"

namespace powderlink::host {

namespace lcm = LIGGGHTS::ContactModels;

template <int Tangential, int Rolling>
class JkrContactModel : public lcm::ContactModelBase {
  using Style =
      lcm::GranStyle<kJkrModelId, Tangential, lcm::COHESION_OFF, Rolling, lcm::SURFACE_DEFAULT>;

 public:
  static const int64_t STYLE_HASHCODE = Style::HASHCODE;

  JkrContactModel(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* history, bool is_wall,
                  int64_t /*hash*/)
      : ContactModelBase(lmp, is_wall),
        surface_(lmp, history, this),
        normal_(lmp, history, this),
        tangential_(lmp, history, this),
        rolling_(lmp, history, this) {}

  int64_t hashcode() { return STYLE_HASHCODE; }
  double stressStrainExponent() { return 1.5; }
  void tally_pp(double value, int i, int j, int index) override {
    surface_.tally_pp(value, i, j, index);
  }
  void tally_pw(double value, int i, int j, int index) override {
    surface_.tally_pw(value, i, j, index);
  }

  void registerSettings(Settings& settings) {
    surface_.registerSettings(settings);
    normal_.registerSettings(settings);
    tangential_.registerSettings(settings);
    rolling_.registerSettings(settings);
  }

  void postSettings(IContactHistorySetup* history) {
    surface_.postSettings(history, this);
    normal_.postSettings();
    tangential_.postSettings(history, this);
    rolling_.postSettings(history, this);
  }

  void connectToProperties(PropertyRegistry& registry) {
    surface_.connectToProperties(registry);
    normal_.connectToProperties(registry);
    tangential_.connectToProperties(registry);
    rolling_.connectToProperties(registry);
  }

  void beginPass(lcm::SurfacesIntersectData&, lcm::ForceData&, lcm::ForceData&) {}
  void endPass(lcm::SurfacesIntersectData&, lcm::ForceData&, lcm::ForceData&) {}
  bool checkSurfaceIntersect(lcm::SurfacesIntersectData&) { return true; }
  void endSurfacesIntersect(lcm::SurfacesIntersectData&, LAMMPS_NS::TriMesh*, lcm::ForceData&,
                            lcm::ForceData&) {}

  inline void surfacesIntersect(lcm::SurfacesIntersectData& contact, lcm::ForceData& on_i,
                                lcm::ForceData& on_j) {
    surface_.surfacesIntersect(contact, on_i, on_j);
    if (normal_.advance(contact) == JkrNormalModel::State::live) apply_all(contact, on_i, on_j);
  }

  inline void surfacesClose(lcm::SurfacesIntersectData& contact, lcm::ForceData& on_i,
                            lcm::ForceData& on_j) {
    if (contact.contact_history == nullptr) return;
    if (normal_.root(contact) == 0.0) {
      if (contact.contact_flags != nullptr) *contact.contact_flags = 0;
      return;
    }
    if (!contact.is_wall) normal_.complete_pair_geometry(contact);
    surface_.surfacesIntersect(contact, on_i, on_j);
    contact.has_force_update = true;
    if (normal_.advance(contact) == JkrNormalModel::State::live) {
      apply_all(contact, on_i, on_j);
      return;
    }
    apply_normal(contact, on_i, on_j);
    tangential_.surfacesClose(contact, on_i, on_j);
    rolling_.surfacesClose(contact, on_i, on_j);
    if (contact.contact_flags != nullptr) *contact.contact_flags = 0;
  }

  bool contact_match(const std::string& type, const std::string& model) {
    lcm::Factory& names = lcm::Factory::instance();
    if (type == "surface") return lcm::SURFACE_DEFAULT == names.getSurfaceModelId(model);
    if (type == "normal") return kJkrModelId == names.getNormalModelId(model);
    if (type == "cohesion") return lcm::COHESION_OFF == names.getCohesionModelId(model);
    if (type == "tangential") return Tangential == names.getTangentialModelId(model);
    if (type == "rolling_friction") return Rolling == names.getRollingModelId(model);
    return false;
  }

 private:
  static inline void apply_normal(const lcm::SurfacesIntersectData& contact, lcm::ForceData& on_i,
                                  lcm::ForceData& on_j) {
    const double force = contact.Fn * (contact.is_wall ? contact.area_ratio : 1.0);
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] += force * contact.en[k];
      if (!contact.is_wall) on_j.delta_F[k] -= force * contact.en[k];
    }
  }

  inline void apply_all(lcm::SurfacesIntersectData& contact, lcm::ForceData& on_i,
                        lcm::ForceData& on_j) {
    // LIGGGHTS keeps the history of a contact as long as one flag is set.
    if (contact.contact_flags != nullptr) *contact.contact_flags |= lcm::CONTACT_NORMAL_MODEL;
    apply_normal(contact, on_i, on_j);
    if (Tangential == lcm::TANGENTIAL_OFF && Rolling == lcm::ROLLING_OFF) return;
    const double overlap = contact.deltan;
    contact.Fn = normal_.friction_load();
    contact.kn = normal_.rolling_load();  // rolling model cdt takes its load as kn * deltan
    contact.deltan = 1.0;
    tangential_.surfacesIntersect(contact, on_i, on_j);
    rolling_.surfacesIntersect(contact, on_i, on_j);
    contact.deltan = overlap;
  }

  lcm::SurfaceModel<lcm::SURFACE_DEFAULT> surface_;
  JkrNormalModel normal_;
  lcm::TangentialModel<Tangential> tangential_;
  lcm::RollingModel<Rolling> rolling_;
};

}  // namespace powderlink::host
