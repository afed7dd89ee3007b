// SPDX-License-Identifier: GPL-3.0-or-later
/// Registers `jkr` with every tangential and rolling model that it supports, `hertz` with tangential
/// model `spring_slider_dashpot`, and answers every other combination of these two with LIGGGHTS's
/// models by name instead of LIGGGHTS's "Unknown normal model".
#include "liggghts_styles/plugin/contact_models.h"

#include <string>

#include "liggghts_styles/contact/contact_model_jkr.h"
#include "liggghts_styles/host/stop_all.h"

namespace powderlink::plugin {

namespace {

using namespace LAMMPS_NS;
namespace lcm = LIGGGHTS::ContactModels;

struct Named {
  const char* name;
  int id;
};
// Ids of the models in the LIGGGHTS 3.8 package (tangential_model_*.h and so on).
constexpr Named kNormal[] = {{"hooke", 0},
                             {"hooke/stiffness", 1},
                             {"hooke/hysteresis", 2},
                             {"hertz", lcm::HERTZ},
                             {"hertz/stiffness", 4},
                             {"thornton_ning", 8},
                             {"off", lcm::NORMAL_OFF},
                             {"edinburgh", 10},
                             {"edinburgh/stiffness", 11},
                             {"luding", 12},
                             {"jkr", host::kJkrModelId}};
constexpr int kSlider = lcm::TANGENTIAL_SPRING_SLIDER_DASHPOT;
constexpr Named kTangential[] = {{"off", 0},
                                 {"no_history", 1},
                                 {"history", 2},
                                 {"tan_luding", 4},
                                 {"spring_slider_dashpot", kSlider}};
constexpr Named kRolling[] = {{"off", 0},   {"cdt", 1},   {"epsd", 2},
                              {"epsd2", 3}, {"epsd3", 4}, {"luding", 6}};
constexpr Named kCohesion[] = {{"off", 0},
                               {"sjkr", 1},
                               {"sjkr2", 2},
                               {"washino/capillary/viscous", 7},
                               {"easo/capillary/viscous", 8}};
constexpr Named kSurface[] = {{"default", 0}, {"multicontact", 2}, {"superquadric", 5}};

template <class Style>
LIGGGHTS::PairStyles::IGranularPairStyle* make_pair(LAMMPS* lmp, PairGran* parent, int64_t hash) {
  return new Style(lmp, parent, hash);
}
template <class Style>
LIGGGHTS::Walls::IGranularWall* make_wall(LAMMPS* lmp, FixWallGran* parent, int64_t hash) {
  return new Style(lmp, parent, hash);
}

template <std::size_t N>
const char* name_of(const Named (&models)[N], int64_t hash, int shift) {
  const int id = static_cast<int>((hash >> shift) & 63);
  for (const Named& m : models) {
    if (m.id == id) return m.name;
  }
  return "unknown";
}

void refuse(LAMMPS* lmp, int64_t hash) {
  const bool jkr = (hash & 63) == host::kJkrModelId;
  const std::string message =
      std::string(jkr ? "model jkr" : "tangential spring_slider_dashpot") +
      ": combination of contact models; given: model " + name_of(kNormal, hash, 0) +
      ", tangential " + name_of(kTangential, hash, 6) + ", cohesion " +
      name_of(kCohesion, hash, 12) + ", rolling_friction " + name_of(kRolling, hash, 18) +
      ", surface " + name_of(kSurface, hash, 24) + "; allowed: " +
      (jkr ? "tangential off | no_history | history, no cohesion model (jkr is one)"
           : "model hertz, no cohesion model") +
      ", rolling_friction off | cdt | epsd2, surface default; "
      "to do: change the pair_style gran or fix wall/gran line";
  host::stop_all(lmp, FLERR, nullptr, message);
}
LIGGGHTS::PairStyles::IGranularPairStyle* refuse_pair(LAMMPS* lmp, PairGran*, int64_t hash) {
  refuse(lmp, hash);
  return nullptr;
}
LIGGGHTS::Walls::IGranularWall* refuse_wall(LAMMPS* lmp, FixWallGran*, int64_t hash) {
  refuse(lmp, hash);
  return nullptr;
}

template <class Model>
void add() {
  const int variant = static_cast<int>(Model::STYLE_HASHCODE);
  LIGGGHTS::PairStyles::Factory::instance().addStyle(
      "gran", variant, &make_pair<LIGGGHTS::PairStyles::Granular<Model>>);
  LIGGGHTS::Walls::Factory::instance().addStyle("gran", variant,
                                                &make_wall<LIGGGHTS::Walls::Granular<Model>>);
}

template <int Tangential>
void add_jkr() {
  add<host::JkrContactModel<Tangential, lcm::ROLLING_OFF>>();
  add<host::JkrContactModel<Tangential, lcm::ROLLING_CDT>>();
  add<host::JkrContactModel<Tangential, lcm::ROLLING_EPSD2>>();
}

template <int Rolling>
void add_slider() {
  add<lcm::ContactModel<
      lcm::GranStyle<lcm::HERTZ, kSlider, lcm::COHESION_OFF, Rolling, lcm::SURFACE_DEFAULT>>>();
}

bool ours(int normal, int tangential) {
  return normal == host::kJkrModelId || tangential == kSlider;
}

bool supported(int normal, int tangential, int cohesion, int rolling, int surface) {
  const bool together = normal == host::kJkrModelId
                            ? tangential == lcm::TANGENTIAL_OFF ||
                                  tangential == lcm::TANGENTIAL_NO_HISTORY ||
                                  tangential == lcm::TANGENTIAL_HISTORY
                            : normal == lcm::HERTZ;
  return together && cohesion == lcm::COHESION_OFF && surface == lcm::SURFACE_DEFAULT &&
         (rolling == lcm::ROLLING_OFF || rolling == lcm::ROLLING_CDT ||
          rolling == lcm::ROLLING_EPSD2);
}

void refuse_the_others() {
  for (const Named& n : kNormal) {
    for (const Named& t : kTangential) {
      if (!ours(n.id, t.id)) continue;
      for (const Named& c : kCohesion) {
        for (const Named& r : kRolling) {
          for (const Named& s : kSurface) {
            if (supported(n.id, t.id, c.id, r.id, s.id)) continue;
            const auto variant = static_cast<int>(
                LIGGGHTS::Utils::generate_gran_hashcode(n.id, t.id, c.id, r.id, s.id));
            LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", variant, &refuse_pair);
            LIGGGHTS::Walls::Factory::instance().addStyle("gran", variant, &refuse_wall);
          }
        }
      }
    }
  }
}

}  // namespace

void register_contact_models() {
  static bool done = false;
  if (done) return;
  done = true;
  lcm::Factory::instance().addNormalModel("jkr", host::kJkrModelId);
  lcm::Factory::instance().addTangentialModel("spring_slider_dashpot", kSlider);
  add_jkr<lcm::TANGENTIAL_OFF>();
  add_jkr<lcm::TANGENTIAL_NO_HISTORY>();
  add_jkr<lcm::TANGENTIAL_HISTORY>();
  add_slider<lcm::ROLLING_OFF>();
  add_slider<lcm::ROLLING_CDT>();
  add_slider<lcm::ROLLING_EPSD2>();
  refuse_the_others();
}

}  // namespace powderlink::plugin
