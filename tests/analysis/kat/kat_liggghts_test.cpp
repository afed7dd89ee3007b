// SPDX-License-Identifier: GPL-3.0-or-later
// `powderlink kat run` with LIGGGHTS, against closed forms and the reduced model.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

nlohmann::json kat_run(const std::string& study, const std::string& options = "") {
  const TestFolder folder;
  const std::string json = (folder.path() / "kat.json").string();
  const CommandResult r =
      powderlink("kat run '" + study + "' --out " + (folder.path() / "out").string() + " --json " +
                 json + " " + options);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_NE(r.err.find("kat run: "), std::string::npos);  // progress
  return nlohmann::json::parse(read_file(json)).at("points");
}

constexpr double kBalance = 1e-6;  // of the impact energy, per particle

TEST(KatLiggghts, InstantStopOfThe316LDrops) {
  constexpr double asked = 2e-3;
  const auto upvc = kat_run(POWDERLINK_CASES "/pedrolli_316L_upvc/study.toml");
  EXPECT_NEAR(upvc[0].at("critical_diameter_um").get<double>() / 46.03, 1.0, asked);
  const auto glass = kat_run(POWDERLINK_CASES "/pedrolli_316L_glass/study.toml");
  EXPECT_NEAR(glass[0].at("critical_diameter_um").get<double>() / 52.93, 1.0, asked);
  EXPECT_NEAR(glass[1].at("critical_diameter_um").get<double>() / 35.63, 1.0, asked);
  EXPECT_LT(glass[1].at("energy_balance").get<double>(), kBalance);
}

TEST(KatLiggghts, HalfSineStopOf100Microseconds) {
  constexpr double asked = 5e-3;
  const double expected[] = {75.5, 66.8, 58.5, 50.05, 46.26, 43.6, 41.4};
  const auto points = kat_run(POWDERLINK_CASES "/half_sine_glass/study.toml");
  ASSERT_EQ(points.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(points[i].at("critical_diameter_um").get<double>() / expected[i], 1.0, asked);
    EXPECT_NEAR(points[i].at("critical_diameter_um").get<double>() /
                    points[i].at("reduced_um").get<double>(),
                1.0, 2e-3);
    EXPECT_LT(points[i].at("energy_balance").get<double>(), kBalance);
  }
}

struct EffectCase {
  const char* effect;
  const char* parameters;
  const char* energy;
  double velocity;
  double tolerance;  ///< LIGGGHTS against the reduced model
};

void PrintTo(const EffectCase& c, std::ostream* out) { *out << c.effect; }

class KatLiggghtsEffect : public ::testing::TestWithParam<EffectCase> {};

TEST_P(KatLiggghtsEffect, AgreesWithTheReducedModel) {
  const EffectCase& c = GetParam();
  const TestFolder folder;
  const auto study = folder.write(
      "study.toml",
      std::string("[study]\nexperiment = \"kat_critical_diameter\"\n[particle]\nmaterial = "
                  "\"borosilicate_glass\"\n"
                  "[substrate]\nmaterial = \"borosilicate_glass\"\n[model]\neffects = [\"") +
          c.effect + "\"]\n[effect." + c.effect + "]\n" + c.parameters +
          "\n[fit]\nadhesive_energy_J_m2 = " + c.energy + "\n[kat]\nvelocities_m_s = [" +
          std::to_string(c.velocity) + "]\n");
  const auto points = kat_run(study.string());
  EXPECT_NEAR(
      points[0].at("critical_diameter_um").get<double>() / points[0].at("reduced_um").get<double>(),
      1.0, c.tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    All, KatLiggghtsEffect,
    ::testing::Values(
        EffectCase{"finite_stop_pulse", "plate_restitution = 0.3", "0.09", 3.0, 2e-3},
        EffectCase{"plastic_contact", "yield_pressure_Pa = 1e9", "20.0", 3.0, 2e-3},
        EffectCase{"surface_roughness", "asperity_radius_m = 1e-5", "50.0", 2.0, 2e-3},
        EffectCase{"capillary_bridge", "", "0.001", 0.3, 2e-3},
        EffectCase{"electrostatic_image_force", "surface_charge_C_m2 = 1e-4", "40.0", 3.0, 5e-3},
        // the edge's step is of first order in both, and coarser in LIGGGHTS
        EffectCase{"rate_dependent_adhesion", "v_star_m_s = 1.0", "10.0", 2.0, 1e-2}),
    [](const auto& info) { return std::string(info.param.effect); });

TEST(KatLiggghts, TheErrorFallsWithTheEffectAdded) {
  const TestFolder folder;
  const std::string zafar = POWDERLINK_CASES "/zafar2014/study.toml";
  const std::string study = (folder.path() / "study.toml").string();
  const std::string json = (folder.path() / "compare.json").string();
  const auto error = [&](const std::string& arguments) {
    const CommandResult r = powderlink("compare " + arguments + " --json " + json);
    EXPECT_EQ(r.status, 0) << r.err;
    return nlohmann::json::parse(read_file(json)).at("rms_relative_error").get<double>();
  };
  const double before = error(zafar);
  ASSERT_EQ(powderlink("add " + zafar + " finite_stop_pulse -o " + study).status, 0);
  const std::string dem = study + " --backend dem --out " + (folder.path() / "out").string();
  const double after = error(dem);
  EXPECT_LT(after, before / 4.0);
  EXPECT_NEAR(after, error(study), 2e-3) << "LIGGGHTS and the reduced model, bracket 2e-3";
  EXPECT_EQ(error(dem), after) << "runs are reused";
}

TEST(KatLiggghts, MovingMeshAndPlateFrameAgree) {
  const TestFolder folder;
  const auto study = [&](const std::string& kat) {
    return folder
        .write("study.toml",
               "[study]\nexperiment = \"kat_critical_diameter\"\n[particle]\nmaterial = \"316L\"\n"
               "[substrate]\nmaterial = \"UPVC\"\n[fit]\nadhesive_energy_J_m2 = 17.175\n"
               "[kat]\nvelocities_m_s = [1.4]\n" +
                   kat)
        .string();
  };
  const double plate = kat_run(study(""))[0].at("critical_diameter_um");
  const double moving =
      kat_run(study("wall = \"mesh\"\nframe = \"moving\"\n"))[0].at("critical_diameter_um");
  EXPECT_NEAR(moving / plate, 1.0, 1e-4);  // width of the last bracket
}

TEST(KatLiggghts, RangeThatDoesNotBracket) {
  const TestFolder folder;
  const auto study = folder.write(
      "study.toml",
      "[study]\nexperiment = \"kat_critical_diameter\"\n[particle]\nmaterial = "
      "\"316L\"\n[substrate]\n"
      "material = \"UPVC\"\n[fit]\nadhesive_energy_J_m2 = 17.175\n[kat]\nvelocities_m_s = [1.4]\n"
      "diameter_range_um = [20, 40]\n");
  const auto json = folder.write("kat.json", "before");
  const CommandResult r = powderlink("kat run " + study.string() + " --json " + json.string());
  EXPECT_EQ(r.status, 1);
  EXPECT_NE(r.err.find("widen it upwards"), std::string::npos) << r.err;
  EXPECT_EQ(read_file(json), "before");
}

}  // namespace
}  // namespace powderlink::analysis
