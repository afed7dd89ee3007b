// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/contact/slider_settings.h"

#include <cmath>
#include <limits>
#include <string>

#include "base/invalid_input.h"
#include "liggghts_styles/host/liggghts_headers.h"
#include "liggghts_styles/host/stop_all.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {
constexpr const char* kModel = "tangential spring_slider_dashpot: ";
constexpr double kPrintedStep = 1e-6;  // of the time step: both come from a script's digits
}  // namespace

int slider_steps(LAMMPS* lmp) {
  auto* fix = static_cast<FixPropertyGlobal*>(lmp->modify->find_fix_property(
      "sliderStep", "property/global", "scalar", 0, 0, "spring_slider_dashpot", false));
  if (fix == nullptr) return 1;
  const double step_s = fix->compute_scalar();
  const double dt_s = lmp->update->dt;
  const double steps = std::round(dt_s / step_s);
  if (!(step_s > 0.0 && step_s <= dt_s * (1.0 + kPrintedStep) &&
        steps <= std::numeric_limits<int>::max())) {
    stop_all(lmp, FLERR, nullptr,
             std::string(kModel) + "sliderStep; given: " + number_text(step_s) +
                 " s; allowed: above 0, up to the time step of " + number_text(dt_s) +
                 " s; to do: correct fix property/global sliderStep, or take a longer timestep");
  }
  return static_cast<int>(steps);
}

void SliderSettings::register_in(Settings& settings) {
  settings.registerOnOff("computeElasticPotential", elastic_, false);
  settings.registerOnOff("computeDissipatedEnergy", dissipated_, false);
}

void SliderSettings::check(LAMMPS* lmp) const {
  if (!elastic_ && !dissipated_) return;
  stop_all(lmp, FLERR, nullptr,
           std::string(kModel) + "energies; given: " +
               (elastic_ ? "computeElasticPotential" : "computeDissipatedEnergy") +
               " on; allowed: off, as the slider's energy vanishes where its spring is emptied; "
               "to do: leave the keyword out, or use tangential history");
}

}  // namespace powderlink::host
