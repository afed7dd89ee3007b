// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/contact/fix_adhesion_effect.h"

#include <cstring>
#include <string>

#include "comm.h"
#include "error.h"
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

namespace {

/// Its range for a grain of powder tells an attraction across the gap.
bool acts_off_contact(const physics::Effect& effect) {
  constexpr double grain_radius_m = 2e-5;
  return effect.stop().has_value() || effect.range_m(grain_radius_m) > 0.0;
}

}  // namespace

std::vector<const physics::Effect*> FixAdhesionEffect::active(LAMMPS* lmp, Reader reader) {
  std::vector<const physics::Effect*> effects;
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    if (std::strcmp(lmp->modify->fix[i]->style, kStyle) != 0) continue;
    auto* fix = static_cast<FixAdhesionEffect*>(lmp->modify->fix[i]);
    if (reader == Reader::drop || !acts_off_contact(*fix->effect_)) fix->read_ = true;
    effects.push_back(fix->effect_.get());
  }
  return effects;
}

void FixAdhesionEffect::setup(int) {
  // All that reads effects has been initialised by now.
  if (read_ || comm->me != 0) return;
  const std::string message =
      std::string("fix ") + id + " adhesion/effect does nothing; given: an effect " +
      (acts_off_contact(*effect_)
           ? "across the gap or of the stop; allowed: beside fix kat/drop, which computes it; "
             "to do: add the fix kat/drop, or remove this fix"
           : "of the contact; allowed: with model jkr, which computes it; "
             "to do: use 'model jkr' in pair_style or fix wall/gran, or remove this fix");
  error->warning(FLERR, message.c_str());
}

}  // namespace powderlink::host
