// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/gamma_method.h"

#include <algorithm>
#include <cmath>

#include "analysis/kat/experiment/gamma_methods.def"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

const std::vector<GammaMethod>& gamma_methods() {
  static const std::vector<GammaMethod> methods = {
#define POWDERLINK_GAMMA_METHOD(CLASS) {&CLASS::info(), CLASS::estimate},
#include "analysis/kat/experiment/gamma_methods.def"
#undef POWDERLINK_GAMMA_METHOD
  };
  return methods;
}

GammaEstimate propagated(const UncertainDrop& drop,
                         const std::function<double(const KatDrop&)>& gamma) {
  GammaEstimate e;
  e.value = gamma(drop.best);
  double down = 0.0, up = 0.0;
  for (const UncertainDrop::Ends& ends : drop.ends) {
    const double a = std::log(gamma(ends.low) / e.value);
    const double b = std::log(gamma(ends.high) / e.value);
    down = std::hypot(down, std::min({a, b, 0.0}));
    up = std::hypot(up, std::max({a, b, 0.0}));
  }
  e.low = e.value * std::exp(-down);
  e.high = e.value * std::exp(up);
  return e;
}

double contact_period_s(const KatDrop& d, double adhesive_energy) {
  const physics::JkrLaw law(d.modulus_Pa(), adhesive_energy);
  const double mass = physics::sphere_mass_kg(d.radius_m(), d.particle.density_kg_m3);
  return 2.0 * physics::JkrLaw::kPi * std::sqrt(mass / law.equilibrium_stiffness_N_m(d.radius_m()));
}

}  // namespace powderlink::analysis
