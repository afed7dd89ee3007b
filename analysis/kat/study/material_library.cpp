// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/material_library.h"

namespace powderlink::analysis {

const std::vector<physics::Material>& known_materials() {
  static const std::vector<physics::Material> materials = {
#define POWDERLINK_MATERIAL(NAME, DENSITY, MODULUS, POISSON) {NAME, DENSITY, MODULUS, POISSON},
#include "physics/contact/materials.def"
#undef POWDERLINK_MATERIAL
  };
  return materials;
}

std::string known_material_names() {
  std::string names;
  for (const auto& m : known_materials()) names += (names.empty() ? "" : ", ") + m.name;
  return names;
}

const physics::Material& find_material(const std::string& name) {
  for (const auto& m : known_materials()) {
    if (m.name == name) return m;
  }
  throw InvalidInput("material", "'" + name + "'", known_material_names(),
                     "use one of these names, or give density_kg_m3=.., youngs_modulus_Pa=.., "
                     "poissons_ratio=.., or a file FILE.toml with these keys");
}

}  // namespace powderlink::analysis
