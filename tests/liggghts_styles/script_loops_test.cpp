// SPDX-License-Identifier: GPL-3.0-or-later
// Loops of a script by clear, next and jump: each pass gives what a script of its own gives.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

using nlohmann::json;

json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  return in ? json::parse(in) : json();
}

/// A Kinetic Adhesion Test with every style of ours: jkr on pair and wall, an effect, the test, kat/run.
std::string kat_lines(const std::string& velocity, const std::string& results) {
  Setting s;
  s.work_of_adhesion_same = 0.5;
  std::string text = header(s, "");
  text.insert(text.find("neighbor"),
              "region box block -4e-4 4e-4 -4e-4 4e-4 -3e-3 2e-4 units box\ncreate_box 2 box\n");
  return text + primitive_plate(s) +
         "fix integrate all nve/sphere\n"
         "fix rough all adhesion/effect surface_roughness 5e-6\n"
         "fix kat all kat/drop wall plate plate zplane 0.0 fall -z velocity " +
         velocity +
         " stop instant populate type 1 density 7980 sizes range 35e-6 55e-6 9 results " + results +
         "\nkat/run kat\n";
}

TEST(ScriptLoops, TwoPassesOfAKatGiveWhatTwoScriptsGive) {
  json alone[2];
  const char* const velocities[] = {"1.3", "1.6"};
  for (const int i : {0, 1}) {
    const LiggghtsCase c("loop_alone_" + std::to_string(i));
    const Outcome o = c.run(kat_lines(velocities[i], "kat.json"));
    ASSERT_EQ(o.status, 0) << o.output;
    alone[i] = read_json(c.folder() / "kat.json");
    ASSERT_TRUE(alone[i].is_object());
  }
  EXPECT_NE(alone[0].at("particles"), alone[1].at("particles"));
  for (const auto program : {LiggghtsCase::Program::launcher, LiggghtsCase::Program::preload}) {
    const int ranks = program == LiggghtsCase::Program::launcher ? 1 : 2;
    const LiggghtsCase c("loop");
    const Outcome o =
        c.run("variable v index 1.3 1.6\nlabel again\n" + kat_lines("${v}", "kat_${v}.json") +
                  "clear\nnext v\njump in.script again\n",
              ranks, program);
    ASSERT_EQ(o.status, 0) << o.output;
    for (const int i : {0, 1}) {
      const json pass = read_json(c.folder() / ("kat_" + std::string(velocities[i]) + ".json"));
      ASSERT_TRUE(pass.is_object()) << o.output;
      EXPECT_EQ(pass.at("critical_diameter_m"), alone[i].at("critical_diameter_m"));
      if (ranks > 1) continue;  // sums in another order
      EXPECT_EQ(pass.at("particles"), alone[i].at("particles"));
    }
  }
}

std::string coupled_lines(const std::string& bridge, const std::string& speed) {
  return header(soft_spheres("jkr"), "spheres.data") + "velocity all set " + speed +
         " 0 0\nfix integrate all nve/sphere\nfix gas all couple/bridge every 10" + bridge +
         "\ndump d all custom 100 pass_" + speed +
         ".dump id x vx\ndump_modify d sort id format \"%d %.17g %.17g\"\nrun 100\n";
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

constexpr const char* kWind = "interval=1e-5 wind=1,0,0 drag=1e-6";
constexpr const char* kSocket = " transport socket rendezvous meet case loops";

/// Over a socket every pass has a solver of its own.
TEST(ScriptLoops, EveryPassOfACoupledLoopHasASolverOverASocket) {
  const std::string solver = std::string(kWind) + " case=loops";
  std::string alone[2];
  const char* const speeds[] = {"0.1", "0.3"};
  for (const int i : {0, 1}) {
    const LiggghtsCase c("couple_loop_alone");
    c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
    const Outcome o = c.couple(coupled_lines(kSocket, speeds[i]), {solver, 1, 1, true});
    ASSERT_EQ(o.status, 0) << o.output;
    alone[i] = file_text(c.folder() / ("pass_" + std::string(speeds[i]) + ".dump"));
    ASSERT_FALSE(alone[i].empty());
  }
  const LiggghtsCase c("couple_loop");
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  LiggghtsCase::Coupled how{solver, 1, 1, true};
  how.solver_runs = 2;
  const Outcome o =
      c.couple("variable v index 0.1 0.3\nlabel again\n" + coupled_lines(kSocket, "${v}") +
                   "clear\nnext v\njump in.script again\n",
               how);
  ASSERT_EQ(o.status, 0) << o.output;
  for (const int i : {0, 1}) {
    EXPECT_EQ(file_text(c.folder() / ("pass_" + std::string(speeds[i]) + ".dump")), alone[i]);
  }
}

/// In one mpirun the solver has ended with the first coupled run.
TEST(ScriptLoops, ASecondCoupledRunInOneMpirunIsRefusedAfterTheFirstHasEnded) {
  for (const char* end : {"unfix gas\n", "clear\n"}) {
    const LiggghtsCase c("couple_again");
    c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
    const bool cleared = std::string(end) == "clear\n";
    const int ranks = cleared ? 1 : 2;
    const Outcome o = c.couple(
        coupled_lines("", "0.1") + end +
            (cleared ? coupled_lines("", "0.3") : "fix gas all couple/bridge every 10\nrun 100\n"),
        {kWind, ranks, ranks});
    EXPECT_NE(o.status, 0) << end;
    EXPECT_LT(o.status, 124) << end << o.output;
    EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
    for (const char* part : {"coupled run; given: a second one in this mpirun", "allowed: one",
                             "to do: keep the fix between runs"}) {
      EXPECT_NE(o.output.find(part), std::string::npos) << part << '\n' << o.output;
    }
  }
}

TEST(ScriptLoops, ABridgeMadeAnewBeforeItsFirstRunCouples) {
  const LiggghtsCase c("couple_before_run");
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  const std::string lines = coupled_lines("", "0.1");
  const auto run = lines.find("run 100");
  const Outcome o = c.couple(
      lines.substr(0, run) + "unfix gas\n" + "fix gas all couple/bridge every 5\nclear\n" + lines,
      {kWind, 2, 1});
  EXPECT_EQ(o.status, 0) << o.output;
  EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
}

}  // namespace
}  // namespace powderlink::testing
