// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/study.h"

#include <gtest/gtest.h>

#include <map>

#include "physics/effects/effect_registry.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// A valid study whose tables a test replaces one by one.
class Text {
 public:
  Text& set(const std::string& table, const std::string& lines) {
    tables_[table] = lines;
    return *this;
  }
  std::string text() const {
    std::string all;
    for (const auto& [table, lines] : tables_) {
      all.append("[").append(table).append("]\n").append(lines).append("\n");
    }
    return all;
  }

 private:
  std::map<std::string, std::string> tables_ = {
      {"study",
       "name = \"test\"\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"drop.csv\""},
      {"particle", "material = \"316L\""},
      {"substrate", "material = \"UPVC\""},
      {"model", "effects = []"},
      {"fit", "adhesive_energy_J_m2 = [0.001, 1000.0]"}};
};

const char* kCsv =
    "impact_velocity_m_s,critical_diameter_um,contact_time_us\n1.4,46.0,80\n2.0,30.0,90\n";

Study read(const std::string& toml, const std::string& csv = kCsv) {
  const TestFolder folder;
  folder.write("drop.csv", csv);
  return read_study(folder.write("study.toml", toml));
}

void refused(const Text& text, const std::vector<std::string>& fragments) {
  expect_refusal([&] { read(text.text()); }, fragments);
}

TEST(Study, ReadsTheContract) {
  const Study s = read(
      Text()
          .set("model", "effects = [\"finite_stop_pulse\", \"surface_roughness\"]")
          .set("effect.finite_stop_pulse", "tau_s = 5e-5")
          .set("kat",
               "wall = \"mesh\"\nframe = \"moving\"\ntime_step_rayleigh = 0.2\nrestitution = 0.9\n"
               "particles = 32\nresolution = 0.01\ndiameter_range_um = [20, 80.0]")
          .text());
  EXPECT_EQ(s.name, "test");
  EXPECT_EQ(s.particle.density_kg_m3, 7980.0);
  EXPECT_EQ(s.substrate.name, "UPVC");
  ASSERT_EQ(s.effects.size(), 2U);
  EXPECT_EQ(s.effects[0].parameters[0], 5e-5);
  EXPECT_EQ(s.effects[0].parameters[1], 0.0);   // typical
  EXPECT_EQ(s.effects[1].parameters[0], 1e-6);  // typical
  EXPECT_FALSE(s.adhesive_energy.fixed());
  EXPECT_EQ(s.adhesive_energy.upper_J_m2, 1000.0);
  EXPECT_TRUE(s.kat.mesh_wall && s.kat.moving_frame);
  EXPECT_EQ(s.kat.particles, 32);
  EXPECT_EQ(s.kat.diameter_range_um->second, 80.0);
  ASSERT_EQ(s.rows.size(), 2U);
  EXPECT_EQ(s.rows[1].critical_diameter_um, 30.0);
}

TEST(Study, MeasuredContactTimeIsTheStop) {
  const Study s = read(Text().set("model", "effects = [\"finite_stop_pulse\"]").text());
  EXPECT_DOUBLE_EQ(row_effects(s.effects, s.rows[1])[0].parameters[0], 90e-6);
  EXPECT_DOUBLE_EQ(row_setup(s, s.rows[0], 0.1).effects[0]->stop()->duration_s(), 80e-6);
  ASSERT_FALSE(s.notes.empty());
  EXPECT_NE(s.notes[0].find("contact_time_us"), std::string::npos);
}

TEST(Study, InlineMaterialsVelocitiesAndFixedEnergy) {
  const Study s =
      read(Text()
               .set("study", "experiment = \"kat_critical_diameter\"")
               .set("particle",
                    "density_kg_m3 = 4430\nyoungs_modulus_Pa = 1.1e11\npoissons_ratio = 0.34")
               .set("fit", "adhesive_energy_J_m2 = 0.09")
               .set("kat", "velocities_m_s = [1, 2.5]")
               .text());
  EXPECT_EQ(s.name, "study");
  EXPECT_EQ(s.particle.youngs_modulus_Pa, 1.1e11);
  EXPECT_TRUE(s.adhesive_energy.fixed());
  ASSERT_EQ(s.rows.size(), 2U);
  EXPECT_EQ(s.rows[1].impact_velocity_m_s, 2.5);
  EXPECT_FALSE(s.rows[1].critical_diameter_um.has_value());
}

TEST(Study, ShippedStudiesAreRead) {
  for (const char* name :
       {"zafar2014", "pedrolli_316L_upvc", "pedrolli_316L_glass", "half_sine_glass"}) {
    EXPECT_EQ(read_study(std::filesystem::path(POWDERLINK_CASES) / name / "study.toml").name, name);
  }
}

TEST(Study, NotesWhatIsUnusual) {
  const Study s = read(Text().set("fit", "adhesive_energy_J_m2 = 17.175").text(),
                       "impact_velocity_m_s,critical_diameter_um,operator\n1.4,46,me\n");
  ASSERT_EQ(s.notes.size(), 2U);
  EXPECT_NE(s.notes[0].find("operator"), std::string::npos);
  EXPECT_NE(s.notes[1].find("surface energy"), std::string::npos);
}

TEST(Study, UnknownKeysListTheValidOnes) {
  refused(Text().set("kats", "particles = 3"),
          {"study.toml, line", "'kats'", "substrate, model, effect, fit, kat"});
  refused(Text().set("kat", "particle = 3"),
          {"line", "[kat] particle", "velocities_m_s, wall, frame"});
  refused(Text().set("model", "effect = []"), {"'effect'", "effects"});
  refused(Text()
              .set("model", "effects = [\"surface_roughness\"]")
              .set("effect.surface_roughness", "r = 1"),
          {"[effect.surface_roughness] r", "asperity_radius_m"});
}

TEST(Study, UnknownNames) {
  refused(Text().set("particle", "material = \"steel\""),
          {"[particle] material", "'steel'", "316L, borosilicate_glass, UPVC"});
  refused(Text().set("model", "effects = [\"magic\"]"),
          {"'magic'", "finite_stop_pulse", "powderlink effects"});
  refused(Text().set("effect.surface_roughness", "asperity_radius_m = 1e-6"), {"not switched on"});
  refused(Text().set("study", "experiment = \"pipe\"\nmeasurements = \"drop.csv\""),
          {"'pipe'", "kat_critical_diameter"});
}

TEST(Study, MaterialsThatCannotBe) {
  refused(Text().set("particle", ""), {"[particle] material", "neither"});
  refused(Text().set("particle", "density_kg_m3 = 1000\nyoungs_modulus_Pa = 1e9"), {"neither"});
  refused(Text().set("particle", "material = \"316L\"\ndensity_kg_m3 = 1000"),
          {"a name and values"});
  refused(
      Text().set("particle", "density_kg_m3 = -1\nyoungs_modulus_Pa = 1e9\npoissons_ratio = 0.3"),
      {"density_kg_m3", "-1"});
  refused(Text().set("particle",
                     "density_kg_m3 = \"x\"\nyoungs_modulus_Pa = 1e9\npoissons_ratio = 0.3"),
          {"[particle] density_kg_m3", "finite number"});
}

TEST(Study, ValuesThatCannotBe) {
  refused(Text().set("fit", ""), {"[fit] adhesive_energy_J_m2", "nothing"});
  refused(Text().set("fit", "adhesive_energy_J_m2 = 0"), {"0 J/m^2"});
  refused(Text().set("fit", "adhesive_energy_J_m2 = [1.0]"), {"bounds"});
  refused(Text().set("fit", "adhesive_energy_J_m2 = [2.0, 1.0]"), {"[2, 1]"});
  refused(Text().set("fit", "adhesive_energy_J_m2 = \"much\""), {"finite number"});
  refused(Text().set("kat", "time_step_rayleigh = 0.6"),
          {"[kat] time_step_rayleigh", "0.6", "0.5"});
  refused(Text().set("kat", "restitution = 0.0"), {"restitution"});
  refused(Text().set("kat", "particles = 2"), {"particles", "8"});
  refused(Text().set("kat", "particles = 64.5"), {"whole number"});
  refused(Text().set("kat", "resolution = 0"), {"resolution"});
  refused(Text().set("kat", "wall = \"sphere\""), {"'sphere'", "primitive", "mesh"});
  refused(Text().set("kat", "frame = \"moving\""), {"wall = \"mesh\""});
  refused(Text().set("kat", "diameter_range_um = [80, 20]"), {"diameter_range_um", "low < high"});
  refused(Text().set("kat", "diameter_range_um = [20e-6, 80e-6]"), {"metres"});
  refused(Text().set("kat", "velocities_m_s = [1.0]"), {"a measurement file and velocities"});
  refused(Text()
              .set("model", "effects = [\"finite_stop_pulse\"]")
              .set("effect.finite_stop_pulse", "tau_s = 1.0"),
          {"[effect.finite_stop_pulse] tau_s", "1e-07 to 0.01"});
  refused(Text().set("model", "effects = [\"surface_roughness\", \"surface_roughness\"]"),
          {"twice"});
  refused(Text().set("model", "effects = \"surface_roughness\""), {"a list of texts"});
  const std::string none = Text().set("study", "experiment = \"kat_critical_diameter\"").text();
  expect_refusal([&] { read(none); }, {"velocities_m_s"});
  const std::string zero = Text()
                               .set("study", "experiment = \"kat_critical_diameter\"")
                               .set("kat", "velocities_m_s = [0.0]")
                               .text();
  expect_refusal([&] { read(zero); }, {"[kat] velocities_m_s", "0 m/s"});
}

TEST(Study, FilesThatCannotBe) {
  expect_refusal([] { read_study("not_there.toml"); }, {"not_there.toml", "TOML"});
  expect_refusal([] { read("[study\n"); }, {"study.toml, line 1"});
  expect_refusal([] { read(Text().text(), "impact_velocity_m_s,critical_diameter_um\n1.4\n"); },
                 {"drop.csv, line 2"});
  expect_refusal(
      [] {
        read(Text().text(),
             "impact_velocity_m_s,critical_diameter_um,adhesive_energy_J_m2\n1.4,46,17\n");
      },
      {"[fit] adhesive_energy_J_m2", "column adhesive_energy_J_m2"});
}

TEST(Study, EveryEffectOfTheRegistryMayBeSwitchedOn) {
  for (const auto& entry : physics::effect_registry()) {
    const Study s = read(Text().set("model", "effects = [\"" + entry.info->name + "\"]").text());
    EXPECT_EQ(s.effects[0].parameters.size(), entry.info->parameters.size());
  }
}

}  // namespace
}  // namespace powderlink::analysis
