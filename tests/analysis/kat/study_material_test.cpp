// SPDX-License-Identifier: GPL-3.0-or-later
// Materials as options give them, and the list of known ones.
#include "analysis/kat/study/study_material.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/kat/study/material_library.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr const char* kTitanium =
    "density_kg_m3 = 4430\nyoungs_modulus_Pa = 1.1e11\npoissons_ratio = 0.33\n";

void expect_titanium(const physics::Material& m) {
  EXPECT_EQ(m.density_kg_m3, 4430.0);
  EXPECT_EQ(m.youngs_modulus_Pa, 1.1e11);
  EXPECT_EQ(m.poissons_ratio, 0.33);
}

TEST(StudyMaterial, ByNameByValuesByFileAndByStudy) {
  const TestFolder folder;
  EXPECT_EQ(material_option("Ti-6Al-4V", "particle").name, "Ti-6Al-4V");
  expect_titanium(material_option(
      "density_kg_m3=4430, youngs_modulus_Pa=1.1e11,poissons_ratio=0.33", "particle"));
  const std::string file = folder.write("batch_7.toml", kTitanium).string();
  expect_titanium(material_option(file, "substrate"));
  EXPECT_EQ(material_option(file, "substrate").name, "batch_7.toml");
  const std::string named = folder.write("named.toml", "material = \"H13\"\n").string();
  EXPECT_EQ(material_option(named, "substrate").name, "H13");
  const std::string study =
      folder
          .write("study.toml", std::string("[study]\nname = \"s\"\n[particle]\n") + kTitanium +
                                   "[substrate]\nmaterial = \"UPVC\"\n")
          .string();
  expect_titanium(material_option(study, "particle"));
  EXPECT_EQ(material_option(study, "substrate").name, "UPVC");
}

TEST(StudyMaterial, IsWrittenSoThatItIsReadAgain) {
  const TestFolder folder;
  physics::Material other = find_material("316L");
  other.youngs_modulus_Pa = 1.0e11 * std::acos(-1.0);  // under a known name, with digits
  for (const physics::Material& m : {find_material("316L"), other}) {
    const auto file = folder.write("m.toml", material_text("particle", m));
    EXPECT_TRUE(same_material(material_option(file.string(), "particle"), m)) << read_file(file);
  }
  EXPECT_FALSE(same_material(find_material("316L"), other));
}

TEST(StudyMaterial, RefusesWhatIsNone) {
  const TestFolder folder;
  const auto refused = [](const std::string& given, const std::vector<std::string>& parts) {
    expect_refusal([&] { material_option(given, "particle"); }, parts);
  };
  refused("steel", {"'steel'", "316L", "density_kg_m3=.."});
  refused("density_kg_m3=4430", {"--particle", "all three values"});
  refused("density=4430", {"--particle", "unknown key 'density'", "density_kg_m3"});
  refused("density_kg_m3=4 430", {"--particle, line 1", "TOML"});
  refused("density_kg_m3=-1, youngs_modulus_Pa=1e11, poissons_ratio=0.3", {"density_kg_m3", "-1"});
  refused("density_kg_m3=4430, youngs_modulus_Pa=1e11, poissons_ratio=0.6",
          {"poissons_ratio", "0.6"});
  refused((folder.path() / "none.toml").string(), {"--particle", "none.toml"});
  refused(folder.write("bad.toml", "density_kg_m3 = x\n").string(), {"bad.toml, line 1"});
  refused(folder.write("key.toml", "colour = 1\n").string(), {"key.toml", "colour"});
}

/// A slip of a unit or digit in the list: the speed of sound in a rod, sqrt(E/rho), of metals, glasses
/// and carbide is 4.5 to 6.5 km/s, that of hard plastics 1.4 to 2.5 km/s.
TEST(StudyMaterial, KnownOnesHaveTheSpeedOfSoundOfSolids) {
  ASSERT_GE(known_materials().size(), 15U);
  for (const physics::Material& m : known_materials()) {
    const double speed_m_s = std::sqrt(m.youngs_modulus_Pa / m.density_kg_m3);
    const bool plastic = m.name == "UPVC";
    EXPECT_GT(speed_m_s, plastic ? 1400.0 : 4500.0) << m.name;
    EXPECT_LT(speed_m_s, plastic ? 2500.0 : 6500.0) << m.name;
    EXPECT_GE(m.poissons_ratio, 0.17) << m.name;
    EXPECT_LE(m.poissons_ratio, 0.4) << m.name;
  }
}

TEST(StudyMaterial, KnownOnesAreInTheReference) {
  const std::string reference = read_file(POWDERLINK_REFERENCE);
  for (const physics::Material& m : known_materials()) {
    const std::string row = fmt::format("| `{}` | {:g} | {:g} | {:g} |", m.name, m.density_kg_m3,
                                        1e-9 * m.youngs_modulus_Pa, m.poissons_ratio);
    EXPECT_NE(reference.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace powderlink::analysis
