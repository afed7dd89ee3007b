// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/drop_script.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "analysis/kat/study/material_library.h"
#include "physics/contact/rayleigh_time.h"
#include "tests/analysis/kat/steel_drop.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// The script's commands as LIGGGHTS sees them: no comments, continued lines joined, single spaces.
std::string commands(const DropScript& d) {
  std::istringstream in(drop_script(d));
  std::string all;
  bool continued = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string tidy;
    for (std::string word; words >> word;) tidy += (tidy.empty() ? "" : " ") + word;
    if (tidy.empty()) continue;
    all += (continued ? " " : all.empty() ? "" : "\n") + tidy;
    continued = tidy.back() == '&';
    if (continued) all.resize(all.size() - 2);
  }
  return all + "\n";
}

void has(const std::string& script, const std::string& line) {
  EXPECT_NE(("\n" + script).find("\n" + line + "\n"), std::string::npos)
      << "'" << line << "' is not in\n"
      << script;
}

double word_after(const std::string& script, const std::string& key, int skip = 0) {
  std::istringstream words(script.substr(script.find(key) + key.size()));
  std::string word;
  for (int i = 0; i <= skip; ++i) words >> word;
  return std::stod(word);
}

TEST(DropScript, HasTheDrop) {
  const std::string s = commands(steel_drop());
  has(s, "units si");
  has(s, "hard_particles yes");
  has(s, "fix m1 all property/global youngsModulus peratomtype 2.11e+11 3e+09");
  has(s, "fix m3 all property/global coefficientRestitution peratomtypepair 2 1 1 1 1");
  has(s, "fix m4 all property/global workOfAdhesion peratomtypepair 2 0 17.175 17.175 0");
  has(s, "pair_style gran model jkr tangential off");
  has(s, "fix plate all wall/gran model jkr tangential off primitive type 2 zplane 0.0");
  has(s,
      "fix kat all kat/drop wall plate plate zplane 0.0 fall -z velocity 1.4 stop instant frame "
      "plate "
      "populate type 1 density 7980 sizes range 4e-05 6e-05 64 results kat_results.json");
  has(s, "kat/run kat");
  EXPECT_EQ(s.find("adhesion/effect"), std::string::npos);
  EXPECT_EQ(s.find("mesh"), std::string::npos);
}

TEST(DropScript, StepIsAFractionOfTheSmallestRayleighTime) {
  DropScript d = steel_drop();
  d.options.time_step_rayleigh = 0.2;
  EXPECT_NEAR(
      word_after(commands(d), "timestep") / (0.2 * physics::rayleigh_time_s(20e-6, d.particle)),
      1.0, 1e-8);
}

TEST(DropScript, BoxHoldsGridAndFlight) {
  DropScript d = steel_drop();
  d.options.particles = 100;
  d.effects = {{"finite_stop_pulse", {2e-4, 0.5}}};
  const std::string s = commands(d);
  EXPECT_GT(word_after(s, "region box block", 1), 0.5 * 10 * 1.2 * 60e-6);
  // A particle that leaves at once flies with v (1 + e_p) until the end.
  EXPECT_LT(word_after(s, "region box block", 4), -1.4 * 1.5 * 2e-4);
  EXPECT_GT(word_after(s, "region box block", 5), 60e-6);
}

TEST(DropScript, SkinHoldsEveryNeck) {
  for (const double energy : {0.01, 17.0, 1000.0}) {
    DropScript d = steel_drop();
    d.work_of_adhesion_J_m2 = energy;
    const physics::JkrLaw law(physics::effective_youngs_modulus_Pa(d.particle, d.substrate),
                              energy);
    EXPECT_GT(word_after(commands(d), "neighbor"), -2.0 * law.tear_off_overlap_m(30e-6));
    d.effects = {{"rate_dependent_adhesion", {1.0, 0.6}}};
    EXPECT_GT(word_after(commands(d), "neighbor"), -27.0 * law.tear_off_overlap_m(30e-6));
  }
  DropScript wet = steel_drop();
  wet.effects = {{"capillary_bridge", {0.07, 0.8}}};
  EXPECT_GT(word_after(commands(wet), "neighbor"), 0.8 * 30e-6);
}

TEST(DropScript, EffectsAreFixesAndTheStopAKeyword) {
  DropScript d = steel_drop();
  d.effects = {{"finite_stop_pulse", {1e-4, 0.3}},
               {"surface_roughness", {1e-6}},
               {"capillary_bridge", {0.07, 0.05}}};
  const std::string s = commands(d);
  has(s, "fix eff1 all adhesion/effect surface_roughness 1e-06");
  has(s, "fix eff2 all adhesion/effect capillary_bridge 0.07 0.05");
  EXPECT_NE(s.find(" stop halfsine 0.0001 rebound 0.3 "), std::string::npos) << s;
  EXPECT_EQ(s.find("effect finite_stop_pulse"), std::string::npos);
  EXPECT_LT(s.find("adhesion/effect"), s.find("kat/drop"));
}

TEST(DropScript, MeshWallThatMoves) {
  DropScript d = steel_drop();
  d.options.mesh_wall = d.options.moving_frame = true;
  const std::string s = commands(d);
  has(s, "fix cad all mesh/surface file plate.stl type 2 precision 1e-12");
  has(s, "fix plate all wall/gran model jkr tangential off mesh n_meshes 1 meshes cad");
  EXPECT_NE(s.find(" frame moving "), std::string::npos);
  EXPECT_NE(s.find("mesh/vtk"), std::string::npos);
  const std::string stl = plate_stl(d);
  const double half = word_after(s, "region box block", 1);
  EXPECT_NEAR(std::fabs(word_after(stl, "vertex")) / half, 1.0, 1e-8);
}

TEST(DropScript, RefusesSizesOutOfOrder) {
  DropScript d = steel_drop();
  d.largest_diameter_m = 30e-6;
  expect_refusal([&] { drop_script(d); }, {"40 to 30 um"});
}

}  // namespace
}  // namespace powderlink::analysis
