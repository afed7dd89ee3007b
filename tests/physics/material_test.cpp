// SPDX-License-Identifier: GPL-3.0-or-later
// Effective moduli against limits, symmetry and other forms of the same laws; the known materials.
#include "physics/contact/material.h"

#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using physics::effective_shear_modulus_Pa;
using physics::effective_youngs_modulus_Pa;
using physics::Material;
using physics::reduced_radius_m;
using test::refuses;

constexpr double kRounding = 1e-14;  // of a few products and quotients

const std::vector<Material>& known() {
  static const std::vector<Material> materials = {
#define POWDERLINK_MATERIAL(NAME, DENSITY, MODULUS, POISSON) {NAME, DENSITY, MODULUS, POISSON},
#include "physics/contact/materials.def"
#undef POWDERLINK_MATERIAL
  };
  return materials;
}

Material steel() { return {"steel", 7980.0, 2.11e11, 0.3}; }
Material glass() { return {"glass", 2510.0, 7.3e10, 0.2}; }

TEST(Material, LikeSolids) {
  const Material m = steel();
  const double plane_strain = m.youngs_modulus_Pa / (1 - 0.3 * 0.3);
  EXPECT_NEAR(effective_youngs_modulus_Pa(m, m), plane_strain / 2, kRounding * plane_strain);
  const double shear = 2.11e11 / 2.6;
  EXPECT_NEAR(m.shear_modulus_Pa(), shear, kRounding * shear);
  // Mindlin's form: 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2.
  EXPECT_NEAR(effective_shear_modulus_Pa(m, m), shear / 2 / 1.7, kRounding * shear);
}

TEST(Material, CompliancesOfThePairAdd) {
  const Material a = steel(), b = glass();
  const double young =
      2 / (1 / effective_youngs_modulus_Pa(a, a) + 1 / effective_youngs_modulus_Pa(b, b));
  EXPECT_NEAR(effective_youngs_modulus_Pa(a, b), young, kRounding * young);
  const double shear =
      2 / (1 / effective_shear_modulus_Pa(a, a) + 1 / effective_shear_modulus_Pa(b, b));
  EXPECT_NEAR(effective_shear_modulus_Pa(a, b), shear, kRounding * shear);
  EXPECT_EQ(effective_youngs_modulus_Pa(a, b), effective_youngs_modulus_Pa(b, a));
  EXPECT_EQ(effective_shear_modulus_Pa(a, b), effective_shear_modulus_Pa(b, a));
}

TEST(Material, RigidPartner) {
  const Material soft = glass();
  const Material rigid{"rigid", 1.0, std::numeric_limits<double>::infinity(), 0.3};
  const double plane_strain = 7.3e10 / 0.96;
  EXPECT_NEAR(effective_youngs_modulus_Pa(soft, rigid), plane_strain, kRounding * plane_strain);
  const double shear = soft.shear_modulus_Pa() / 1.8;
  EXPECT_NEAR(effective_shear_modulus_Pa(soft, rigid), shear, kRounding * shear);
}

TEST(Material, ReducedRadius) {
  EXPECT_NEAR(reduced_radius_m(2e-5, 2e-5), 1e-5, kRounding * 1e-5);
  EXPECT_NEAR(1 / reduced_radius_m(2e-5, 3e-5), 1 / 2e-5 + 1 / 3e-5, kRounding * 1e5);
  constexpr double curvature_of_plate = 1e-9;  // R/R_plate of a plate drawn as a sphere of 20 km
  EXPECT_NEAR(reduced_radius_m(2e-5, 2e4), 2e-5, 2e-5 * curvature_of_plate);
}

TEST(Material, KnownOnesAreUsable) {
  std::set<std::string> names;
  for (const Material& m : known()) {
    EXPECT_NO_THROW(m.validate()) << m.name;
    EXPECT_TRUE(names.insert(m.name).second) << m.name << " is there twice";
    EXPECT_GT(m.density_kg_m3, 500.0) << m.name << ": a solid in SI units";
    EXPECT_GT(m.youngs_modulus_Pa, 1e5) << m.name << ": a solid in SI units";
  }
  for (const char* name : {"316L", "borosilicate_glass", "UPVC"})
    EXPECT_EQ(names.count(name), 1U) << name;
}

TEST(Material, RefusesWhatIsMissingOrImpossible) {
  const auto check = [](const Material& m) { return [m] { m.validate(); }; };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Material m = steel();
  for (const double bad : {0.0, -7980.0, nan, infinity}) {
    m = steel();
    m.density_kg_m3 = bad;
    EXPECT_TRUE(refuses(check(m), "steel': density_kg_m3"));
    m = steel();
    m.youngs_modulus_Pa = bad;
    EXPECT_TRUE(refuses(check(m), "steel': youngs_modulus_Pa"));
  }
  for (const double bad : {-1.0, 0.51, nan}) {
    m = steel();
    m.poissons_ratio = bad;
    EXPECT_TRUE(refuses(check(m), "poissons_ratio"));
  }
  m = steel();
  m.youngs_modulus_Pa = -1e-9;
  EXPECT_TRUE(refuses(check(m), "youngs_modulus_Pa", "-1e-09")) << "small values must be readable";
  for (const double good : {-0.5, 0.0, 0.5}) {
    m = steel();
    m.poissons_ratio = good;
    EXPECT_NO_THROW(m.validate());
  }
}

}  // namespace
}  // namespace powderlink
