// SPDX-License-Identifier: GPL-3.0-or-later
// How a coupled job ends: in order from either side, or with one clear error that stops both.
#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

std::string good_script(const LiggghtsCase& c, const std::string& run = "run 100\n") {
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  return header(soft_spheres(), "spheres.data") + kGas + dump_lines(50) + run;
}

constexpr const char* kWind = "interval=1e-5 wind=1,0,0 drag=1e-6";

TEST(CoupleBridgeEnds, TheDemFinishesInOrder) {
  const LiggghtsCase c("couple_end_dem");
  const Outcome o = c.couple(good_script(c), {kWind, 2, 2});
  EXPECT_EQ(o.status, 0) << o.output;
  EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
}

TEST(CoupleBridgeEnds, TheSolverStopsInOrder) {
  for (const bool socket : {false, true}) {
    const LiggghtsCase c(socket ? "couple_end_solver_socket" : "couple_end_solver");
    std::string script = good_script(c, "run 100\nrun 100\n");
    if (socket)
      script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet");
    const Outcome o = c.couple(script, {std::string(kWind) + " stop=3", 2, 1, socket});
    EXPECT_EQ(o.status, 0) << o.output;
    EXPECT_NE(o.output.find("the solver ended the coupled run at step 30, time 3e-05 s"),
              std::string::npos)
        << o.output;
    EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
    EXPECT_EQ(read_dump(c.folder() / "all.dump").count(50), 0u) << "the run went on";
  }
}

/// `quit`, alone on its line or within an `if`, ends as the end of the script does.
TEST(CoupleBridgeEnds, QuitIsAnOrderlyEnd) {
  constexpr const char* kQuit = "quit\n";
  constexpr const char* kIf = "if \"1 > 0\" then \"quit 0\"\nrun 1000\n";
  for (const char* quit : {kQuit, kIf}) {
    const bool socket = quit == kQuit;
    for (const auto program : {LiggghtsCase::Program::launcher, LiggghtsCase::Program::preload}) {
      const LiggghtsCase c(socket ? "couple_quit_socket" : "couple_quit");
      std::string script = good_script(c, std::string("run 100\n") + quit);
      if (socket)
        script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet");
      const int ranks = program == LiggghtsCase::Program::launcher ? 2 : 1;
      LiggghtsCase::Coupled how{kWind, ranks, ranks, socket};
      how.program = program;
      const Outcome o = c.couple(script, how);
      EXPECT_EQ(o.status, 0) << o.output;
      EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
      EXPECT_EQ(o.output.find("ERROR"), std::string::npos) << o.output;
      EXPECT_EQ(read_dump(c.folder() / "all.dump").count(100), 1u) << "the dump is cut";
    }
  }
}

/// A status is the script's word to whoever started the job; the gas ends in order.
TEST(CoupleBridgeEnds, QuitWithAStatusEndsWithIt) {
  for (const bool socket : {false, true}) {
    const LiggghtsCase c(socket ? "couple_quit_3_socket" : "couple_quit_3");
    std::string script = good_script(c, "run 100\nquit 3\n");
    if (socket)
      script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet");
    const Outcome o = c.couple(script, {kWind, 2, 1, socket});
    EXPECT_EQ(o.status, 3) << o.output;
    EXPECT_NE(o.output.find("fake solver: orderly end"), std::string::npos) << o.output;
  }
}

TEST(CoupleBridgeEnds, QuitOfAnUncoupledScript) {
  for (const auto program : {LiggghtsCase::Program::launcher, LiggghtsCase::Program::preload}) {
    const LiggghtsCase c("quit_alone");
    EXPECT_EQ(c.run("units si\nquit\n", 1, program).status, 0);
    EXPECT_EQ(c.run("units si\nquit 3\n", 2, program).status, 3);
    const Outcome o = c.run("units si\nquit soon\n", 1, program);
    EXPECT_EQ(o.status, 1) << o.output;
    EXPECT_NE(o.output.find("command quit; given: quit soon; allowed: quit [STATUS]"),
              std::string::npos)
        << o.output;
  }
}

TEST(CoupleBridgeEnds, AnEndBetweenTwoExchangesIsSaid) {
  struct End {
    const char* run;
    bool between;
  };
  for (const End& end : {End{"run 25\n", true}, End{"run 25\nrun 5\n", false},
                         End{"run 5\nrun 30\nunfix gas\n", true}}) {
    const LiggghtsCase c("couple_end_between");
    const Outcome o = c.couple(good_script(c, end.run), {kWind, 2, 1});
    EXPECT_EQ(o.status, 0) << o.output;
    const auto said = o.output.find("between the exchanges of steps ");
    EXPECT_EQ(said != std::string::npos, end.between) << o.output;
    if (end.between) {
      EXPECT_NE(o.output.find("0: the gas goes on to the latter", said), std::string::npos);
    }
  }
}

TEST(CoupleBridgeEnds, AFullDiskIsNoticedAndEarlierCheckpointsStay) {
  const LiggghtsCase c("couple_full_disk");
  std::vector<Sphere> spheres;
  for (int i = 0; i < 400; ++i) {
    spheres.push_back(grain(-4e-3 + 2e-4 * (i % 20), -4e-3 + 2e-4 * (i / 20)));
  }
  c.write_spheres("spheres.data", spheres, 1e-2);
  std::filesystem::create_directories(c.folder() / "post");
  c.write("post/restart.0", "an earlier one");
  const std::string script = header(soft_spheres(), "spheres.data") + kGas + "run 100\n";
  // Files of more than 100 blocks of 512 bytes fail as on a full disk.
  const Outcome o = c.couple(
      script, {std::string(kWind) + " checkpoint=2", 1, 1, false, "trap '' XFSZ; ulimit -f 100"});
  EXPECT_NE(o.status, 0);
  EXPECT_LT(o.status, 124) << o.output;
  EXPECT_NE(
      o.output.find("checkpoint post/restart.20; given: the disk did not take the whole file"),
      std::string::npos)
      << o.output;
  EXPECT_TRUE(std::filesystem::exists(c.folder() / "post/restart.0"));
  EXPECT_FALSE(std::filesystem::exists(c.folder() / "post/restart.20"));
  EXPECT_FALSE(std::filesystem::exists(c.folder() / "post/restart.20.part"));
}

struct BadCase {
  const char* name;
  const char* find;        ///< in the good script ...
  const char* replace_by;  ///< ... gives the bad one
  const char* solver;      ///< more arguments of the solver
  const char* message;     ///< part of what must be said
};

void PrintTo(const BadCase& c, std::ostream* out) { *out << c.name; }

class CoupleBridgeBadInput : public ::testing::TestWithParam<BadCase> {};

TEST_P(CoupleBridgeBadInput, StopsBothProgramsWithOneClearMessage) {
  const BadCase& bad = GetParam();
  const LiggghtsCase c(std::string("couple_bad_") + bad.name);
  std::string script = good_script(c);
  const std::string find = bad.find;
  const auto at = script.find(find);
  ASSERT_NE(at, std::string::npos);
  script.replace(at, find.size(), bad.replace_by);
  const Outcome o = c.couple(script, {std::string(kWind) + " " + bad.solver, 2, 1});
  EXPECT_NE(o.status, 0) << o.output;
  EXPECT_LT(o.status, 124) << "neither a signal nor a time-out\n" << o.output;
  EXPECT_NE(o.output.find(bad.message), std::string::npos) << o.output;
}

const BadCase kBadCases[] = {
    {"every", "every 10", "every 11", "", "interval between exchanges"},
    {"keyword", "every 10", "evry 10", "", "keyword of fix couple/bridge; given: evry"},
    {"case", "every 10", "every 10 case other", "", "case name"},
    {"units", "units si", "units cgs", "", "units; given: cgs"},
    {"two_fixes", "run 100", "fix more all couple/bridge every 10\nrun 100", "",
     "fix couple/bridge; given: two of them"},
    {"time_step", "run 100", "run 15\ntimestep 2e-6\nrun 100", "", "time step; given: 2e-06 s"},
    {"unknown_field", "run 100", "run 100", "unknown=1", "fluid_temperature [K]"},
    {"not_a_number", "run 100", "run 100", "nan=2", "not a number for particle 2"},
    {"solver_fails", "run 100", "run 100", "fail=2", "its error: flow; given: diverged"},
    {"domains", "run 100", "run 100", "box=5,6", "domains along x; given: box of LIGGGHTS"},
    {"script_error", "run 100", "run 15\nno_such_command\n", "", "Unknown command"},
    // An error of one rank: LIGGGHTS aborts at once, its message must not stay in a buffer.
    {"no_data", "read_data spheres", "read_data sphere", "", "Cannot open file sphere.data"},
    {"no_run", "run 100", "", "", "a script that ends without coupling"},
    {"quit_before", "run 100", "quit", "", "a script that ends without coupling"},
    {"socket", "every 10", "every 10 transport socket", "",
     "transport; given: socket, in one mpirun with solver"},
    {"folder", "every 10", "every 10 checkpoint in.script/r.", "checkpoint=1",
     "checkpoint in.script/r.10; given: "},
};

INSTANTIATE_TEST_SUITE_P(Cases, CoupleBridgeBadInput, ::testing::ValuesIn(kBadCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// An error of LIGGGHTS itself, in the middle of a coupled run: of all ranks, and of one.
TEST(CoupleBridgeEnds, AnErrorOfLiggghtsIsToldToTheSolver) {
  constexpr const char* kAll = "run 15\nno_such_command\n";
  constexpr const char* kOne = "run 15\nread_data missing.data add\n";
  for (const bool socket : {false, true}) {
    for (const char* rest : {kAll, kOne}) {
      const LiggghtsCase c("couple_own_error");
      std::string script = good_script(c, rest);
      if (socket)
        script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet");
      const Outcome o = c.couple(script, {kWind, socket ? 1 : 2, 1, socket});
      EXPECT_NE(o.status, 0) << o.output;
      const std::string why = rest == kAll ? "Unknown command" : "Cannot open file missing.data";
      EXPECT_NE(o.output.find("its error: LIGGGHTS: " + why), std::string::npos)
          << (socket ? "socket: " : "mpi: ") << o.output;
    }
  }
}

TEST(CoupleBridgeEnds, ABoxThatIsTinyAgainstTheMeshIsRefusedUnlessItIsMeant) {
  for (const bool meant : {false, true}) {
    const LiggghtsCase c(meant ? "couple_small_box" : "couple_tiny_box");
    std::string script = good_script(c, "run 10\n");
    if (meant) script.replace(script.find("every 10"), 8, "every 10 sizes any");
    c.write_spheres("spheres.data", {grain(0.0)}, 1e-3);
    // The fake solver's mesh is 2 m long along y and z.
    const Outcome o = c.couple(script, {std::string(kWind) + " box=-1,1"});
    EXPECT_EQ(o.status == 0, meant) << o.output;
    const auto refusal =
        o.output.find("sizes; given: a box of LIGGGHTS that is 0.001 to 0.001 times");
    EXPECT_EQ(refusal == std::string::npos, meant) << o.output;
  }
}

TEST(CoupleBridgeEnds, ALiggghtsAloneIsToldHowToCouple) {
  const LiggghtsCase c("couple_alone");
  const Outcome o = c.run(good_script(c), 2);
  EXPECT_NE(o.status, 0);
  EXPECT_NE(o.output.find("coupling by mpi; given: a job that holds this program alone"),
            std::string::npos)
      << o.output;
}

TEST(CoupleBridgeEnds, ASolverThatNeverComesIsATimeout) {
  const LiggghtsCase c("couple_nobody");
  std::string script = good_script(c);
  script.replace(script.find("every 10"), 8, "every 10 transport socket rendezvous meet timeout 1");
  const Outcome o = c.run(script);
  EXPECT_NE(o.status, 0);
  EXPECT_LT(o.status, 124) << o.output;
  EXPECT_NE(o.output.find("within 1 s"), std::string::npos) << o.output;
}

}  // namespace
}  // namespace powderlink::testing
