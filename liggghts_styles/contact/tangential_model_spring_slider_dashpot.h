// SPDX-License-Identifier: GPL-3.0-or-later
/// \file tangential_model_spring_slider_dashpot.h
/// Tangential model `spring_slider_dashpot` of `pair_style gran` and `fix wall/gran`: the friction
/// of OpenFOAM's colliding clouds, physics of physics/contact/spring_slider_dashpot.h.
///
/// Script:  pair_style gran model hertz tangential spring_slider_dashpot
/// Needs:   coefficientFriction beside what hertz needs; optionally
///          fix ID all property/global sliderStep scalar DT   [s]
///          the step of the clouds, on which their friction depends: the slider then does a whole
///          number of steps, as near to DT as may be, in each time step. Without it, one.
/// History: three values per contact, the spring [m]; 0 in a new contact.
///
/// The spring is turned with the contact, as LIGGGHTS does and the clouds do not. Its dashpot is the
/// normal one, whatever `tangential_damping` says.
/// Tests: tests/liggghts_styles/slider_test.cpp
#ifdef TANGENTIAL_MODEL
TANGENTIAL_MODEL(TANGENTIAL_SPRING_SLIDER_DASHPOT, spring_slider_dashpot, 20)
#else
#ifndef POWDERLINK_HOST_TANGENTIAL_MODEL_SPRING_SLIDER_DASHPOT_H
#define POWDERLINK_HOST_TANGENTIAL_MODEL_SPRING_SLIDER_DASHPOT_H

#include <cmath>

#include "tangential_model_base.h"

#include "liggghts_styles/contact/slider_settings.h"
#include "physics/contact/spring_slider_dashpot.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class TangentialModel<TANGENTIAL_SPRING_SLIDER_DASHPOT> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* model)
      : TangentialModelBase(lmp, history, model) {
    offset_ = history->add_history_value("sliderx", "1");
    history->add_history_value("slidery", "1");
    history->add_history_value("sliderz", "1");
  }

  void registerSettings(Settings& settings) override { settings_.register_in(settings); }
  void postSettings(IContactHistorySetup*, ContactModelBase*) override { settings_.check(lmp); }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

  void connectToProperties(PropertyRegistry& registry) override {
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_, "tangential_model spring_slider_dashpot");
    parts_ = powderlink::host::slider_steps(lmp);
  }

  void surfacesIntersect(const SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (contact.contact_flags != nullptr) *contact.contact_flags |= CONTACT_TANGENTIAL_MODEL;
    const bool advances = contact.computeflag && contact.shearupdate;
    double* const history = &contact.contact_history[offset_];
    double along = 0.0;
    for (int k = 0; k < 3; ++k) along += history[k] * contact.en[k];
    double spring[3];
    for (int k = 0; k < 3; ++k) spring[k] = history[k] - along * contact.en[k];

    const double slip[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    const powderlink::physics::SliderLoad load{
        contact.kt, contact.gamman,
        friction_[contact.itype][contact.jtype] * std::fabs(contact.Fn)};
    double force[3];
    powderlink::physics::advance_slider(load, slip, update->dt, parts_, spring, force);
    if (advances) {
      for (int k = 0; k < 3; ++k) history[k] = spring[k];
    }
    apply(contact, force, on_i, on_j);
  }

  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags != nullptr) *contact.contact_flags &= ~CONTACT_TANGENTIAL_MODEL;
    if (contact.contact_history == nullptr) return;
    for (int k = 0; k < 3; ++k) contact.contact_history[offset_ + k] = 0.0;
  }

 private:
  static void apply(const SurfacesIntersectData& contact, const double (&force)[3], ForceData& on_i,
                    ForceData& on_j) {
    const double* en = contact.en;
    const double turn[3] = {en[1] * force[2] - en[2] * force[1],
                            en[2] * force[0] - en[0] * force[2],
                            en[0] * force[1] - en[1] * force[0]};
    const double share = contact.is_wall ? contact.area_ratio : 1.0;
    for (int k = 0; k < 3; ++k) {
      on_i.delta_F[k] += share * force[k];
      on_i.delta_torque[k] -= share * contact.cri * turn[k];
      if (contact.is_wall) continue;
      on_j.delta_F[k] -= force[k];
      on_j.delta_torque[k] -= contact.crj * turn[k];
    }
  }

  double** friction_ = nullptr;
  powderlink::host::SliderSettings settings_;
  int parts_ = 1;
  int offset_ = -1;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
