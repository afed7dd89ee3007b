// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/contact/fix_adhesion_effect.h"

#include <cstring>

#include "force.h"
#include "liggghts_styles/host/stop_all.h"
#include "modify.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

FixAdhesionEffect::FixAdhesionEffect(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  if (narg < 4) {
    stop_all(lmp, FLERR, this,
             "no effect named; given: no argument; allowed: a name of 'powderlink effects'; "
             "to do: fix ID all adhesion/effect NAME [parameters]");
  }
  std::vector<double> parameters;
  for (int i = 4; i < narg; ++i) parameters.push_back(force->numeric(FLERR, arg[i]));
  try {
    effect_ = physics::make_effect(arg[3], parameters);
    if (effect_->of_measurement()) {
      throw InvalidInput("effect", std::string("'") + arg[3] + "'",
                         "an effect of the contact, of the gap or of the stop",
                         "remove this fix: the effect belongs to the measurement "
                         "and changes no grain; studies apply it to the outcome");
    }
  } catch (const InvalidInput& problem) {
    stop_all(lmp, FLERR, this, problem.what());
  }
}

std::vector<const physics::Effect*> FixAdhesionEffect::active(LAMMPS* lmp) {
  std::vector<const physics::Effect*> effects;
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    if (std::strcmp(lmp->modify->fix[i]->style, kStyle) == 0) {
      effects.push_back(&static_cast<FixAdhesionEffect*>(lmp->modify->fix[i])->effect());
    }
  }
  return effects;
}

}  // namespace powderlink::host
