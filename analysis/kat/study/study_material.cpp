// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/study_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/kat/study/material_library.h"
#include "base/toml/toml_text.h"

namespace powderlink::analysis {

namespace {

constexpr double kSame = 1e-8;  // relative: nine digits are written

bool same(double a, double b) { return std::fabs(a - b) <= kSame * std::fabs(b); }

/// Values without a name of their own are told by what they are.
physics::Material named(physics::Material m, const std::string& name) {
  const auto& known = known_materials();
  if (std::none_of(known.begin(), known.end(), [&](const auto& k) { return k.name == m.name; }))
    m.name = name;
  return m;
}

}  // namespace

const std::vector<std::string>& material_keys() {
  static const std::vector<std::string> keys = {"material", "density_kg_m3", "youngs_modulus_Pa",
                                                "poissons_ratio"};
  return keys;
}

physics::Material read_material(const StrictTable& table) {
  const auto name = table.text("material");
  const auto density = table.number("density_kg_m3");
  const auto modulus = table.number("youngs_modulus_Pa");
  const auto poisson = table.number("poissons_ratio");
  const char* allowed = "material = NAME, or density_kg_m3, youngs_modulus_Pa and poissons_ratio";
  if (name && !density && !modulus && !poisson) {
    try {
      return find_material(*name);
    } catch (const InvalidInput& e) {
      throw InvalidInput(table.place("material"), "'" + *name + "'", known_material_names(),
                         "use one of these names, "
                         "or give density_kg_m3, youngs_modulus_Pa and poissons_ratio instead");
    }
  }
  if (name) {
    throw InvalidInput(table.place("material"), "a name and values", allowed,
                       "keep one of the two");
  }
  if (!density || !modulus || !poisson) {
    throw InvalidInput(table.place("material"), "neither a name nor all three values", allowed,
                       "known names: " + known_material_names());
  }
  physics::Material m{table.place("values"), *density, *modulus, *poisson};
  m.validate();
  return m;
}

physics::Material material_option(const std::string& given, const std::string& which) {
  const std::string option = "--" + which;
  if (given.find('=') != std::string::npos) {
    const toml::table values = parse_toml("values = {" + given + "}", option);
    const StrictTable table = StrictTable(&values, option, "", {}).table("values", material_keys());
    return named(read_material(table), "material of --" + which);
  }
  const std::filesystem::path file = given;
  if (file.extension() != ".toml") return find_material(given);
  const toml::table document =
      read_toml(file, option, "check the path; without .toml it is the name of a known material");
  const StrictTable root(&document, given, "", {});
  const bool study = root.has(which);
  return named(read_material(study ? root.table(which, material_keys())
                                   : StrictTable(&document, given, "", material_keys())),
               file.filename().string());
}

std::string material_option_help() {
  return "material: " + known_material_names() +
         "; or FILE.toml, or density_kg_m3=..,youngs_modulus_Pa=..,poissons_ratio=..";
}

std::string material_text(const std::string& table, const physics::Material& m) {
  const auto& known = known_materials();
  const bool by_name = std::any_of(known.begin(), known.end(), [&](const physics::Material& k) {
    return k.name == m.name && same_material(k, m);
  });
  if (by_name) return fmt::format("\n[{}]\nmaterial = {}\n", table, quoted(m.name));
  return fmt::format(
      "\n[{}]\ndensity_kg_m3 = {:.9g}\nyoungs_modulus_Pa = {:.9g}\npoissons_ratio = {:.9g}\n",
      table, m.density_kg_m3, m.youngs_modulus_Pa, m.poissons_ratio);
}

bool same_material(const physics::Material& a, const physics::Material& b) {
  return same(a.density_kg_m3, b.density_kg_m3) && same(a.youngs_modulus_Pa, b.youngs_modulus_Pa) &&
         same(a.poissons_ratio, b.poissons_ratio);
}

std::string material_words(const physics::Material& m) {
  return fmt::format("{} ({:g} kg/m^3, {:g} Pa, {:g})", m.name, m.density_kg_m3,
                     m.youngs_modulus_Pa, m.poissons_ratio);
}

}  // namespace powderlink::analysis
