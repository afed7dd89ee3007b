// SPDX-License-Identifier: GPL-3.0-or-later
// fix couple/bridge in the real LIGGGHTS, with a gas that is known: closed forms, momentum, ranks,
// restart.
#include <cmath>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

TEST(CoupleBridge, VelocityIsTheExponentialAtAnyStiffness) {
  const double m = sphere_mass(kDiameter);
  for (const double x :
       {1e-3, 0.5, 5.0}) {  // K dt/m: the last one has dt beyond the relaxation time
    const double k = x * m / kStep;
    const double force = 0.25 * k;
    const LiggghtsCase c("couple_exponential_" + text(x));
    auto dump = run_grain(c, "", "wind=2,0,0 react=" + text(force) + " drag=" + text(k), 40);
    ASSERT_EQ(dump.size(), 41u);
    for (const long step : {1L, 7L, 10L, 11L, 40L}) {
      const double exact = -2.25 * std::expm1(-x * static_cast<double>(step));
      // 40 roundings
      EXPECT_NEAR(dump[step].at(1)[kVx], exact, 1e-13 * 2.25) << "x " << x << " step " << step;
    }
    EXPECT_NEAR(dump[1].at(1)[kForceX], k * 2.0 + force, 1e-12 * k) << "at the exchange, at rest";
  }
}

TEST(CoupleBridge, WeightOfLiggghtsGivesTheTerminalVelocityOfTheSplitStep) {
  const double m = sphere_mass(kDiameter);
  const double x = 0.02;
  const LiggghtsCase c("couple_terminal");
  auto dump = run_grain(c, "fix weight all gravity 9.81 vector 1 0 0\n",
                        "drag=" + text(x * m / kStep), 2000);
  const double split = 9.81 * kStep / -std::expm1(-x);  // header of fluid_relaxation.h
  EXPECT_NEAR(dump[2000].at(1)[kVx] / split, 1.0, 1e-12);
  EXPECT_NEAR(dump[2000].at(1)[kVx] / (9.81 * kStep / x), 1.0 + 0.5 * x, x * x);
}

TEST(CoupleBridge, ReactionImpulseIsWhatTheFluidGaveLessPressure) {
  const double m = sphere_mass(kDiameter);
  const double press = 3e-8;
  const LiggghtsCase c("couple_impulse");
  auto dump = run_grain(
      c, "fix weight all gravity 9.81 vector 1 0 0\n",
      "log=log.txt wind=5,0,0 react=1e-8 press=" + text(press) + " drag=" + text(0.3 * m / kStep),
      101);
  const auto log = read_log(c.folder() / "log.txt");
  ASSERT_EQ(log.size(), 11u);
  double sum = 0.0;
  for (const auto& row : log) {
    sum += row[3];
    const double time = row[1];
    const double v = dump[static_cast<long>(row[0])].at(1)[kVx];
    const double expected = m * v - m * 9.81 * time - press * time;
    EXPECT_NEAR(sum / (m * 5.0), expected / (m * 5.0), 1e-12) << "step " << row[0];
  }
  EXPECT_GT(sum, 0.5 * m * 5.0);
}

TEST(CoupleBridge, AddedMassSlowsEveryForce) {
  const double m = sphere_mass(kDiameter);
  const LiggghtsCase c("couple_added_mass");
  auto dump = run_grain(c, "fix weight all gravity 9.81 vector 1 0 0\n",
                        "added_mass=0.5 react=" + text(0.0) + " press=0,0," + text(m * 2.0), 100);
  const double time = 100 * kStep;
  EXPECT_NEAR(dump[100].at(1)[kVx] / (9.81 / 1.5 * time), 1.0, 1e-12);
  EXPECT_NEAR(dump[100].at(1)[kVz] / (2.0 / 1.5 * time), 1.0, 1e-12);
}

TEST(CoupleBridge, SpinRelaxesToThatOfTheFluidAndTheTorque) {
  const double m = sphere_mass(kDiameter);
  const double inertia = 0.1 * m * kDiameter * kDiameter;
  const double x = 0.05;
  const double k = x * inertia / kStep;
  const LiggghtsCase c("couple_spin");
  auto dump = run_grain(c, "", "turn=40," + text(k) + "," + text(10.0 * k), 60);
  EXPECT_NEAR(dump[60].at(1)[kSpinZ] / (-50.0 * std::expm1(-60 * x)), 1.0, 1e-12);
}

TEST(CoupleBridge, OnlyTheGroupIsCoupled) {
  const LiggghtsCase c("couple_group");
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  const Outcome o = c.couple(
      header(soft_spheres(), "spheres.data") +
          "group wet id 2\nfix integrate all nve/sphere\nfix gas wet couple/bridge every 10\n" +
          dump_lines(20) + "run 20\n",
      {interval() + "wind=1,0,0 drag=1e-5 log=log.txt"});
  ASSERT_EQ(o.status, 0) << o.output;
  auto dump = read_dump(c.folder() / "all.dump");
  EXPECT_EQ(dump[20].at(1)[kVx], 0.0);
  EXPECT_GT(dump[20].at(2)[kVx], 0.0);
  EXPECT_EQ(read_log(c.folder() / "log.txt").front()[2], 1.0);
}

/// A cloud that collides, turns, and crosses the middle between two ranks; periodic along x.
std::string cloud(const LiggghtsCase& c, const std::string& model, const std::string& fix_options,
                  const std::string& run = "run 300\n") {
  std::vector<Sphere> spheres;
  for (int i = 0; i < 60; ++i) {
    Sphere s = grain(-0.9e-3 + 1.2e-4 * (i % 15), -1.2e-4 + 1.2e-4 * ((i / 15) % 2),
                     -1.2e-4 + 1.2e-4 * (i / 30));
    s.diameter = 60e-6 + 1e-6 * (i % 30);
    for (int k = 0; k < 3; ++k) s.v[k] = 1.5 * std::sin(1.0 + i * (k + 1));
    spheres.push_back(s);
  }
  c.write_spheres("spheres.data", spheres, 1e-3);
  std::string script = header(soft_spheres(model), "spheres.data");
  script.replace(script.find("boundary m m m"), 14, "boundary p p m");
  script.insert(script.find("pair_style"),
                "fix speed all property/global characteristicVelocity scalar 2.0\n");
  return script + "fix integrate all nve/sphere\nfix weight all gravity 9.81 vector 0 0 -1\n" +
         "fix gas all couple/bridge every 10" + fix_options + "\n" + dump_lines(100) + run;
}

constexpr const char* kCloudGas = "box=-1e-3,1e-3 wind=8,0,0 stokes=2e-5 press=1e-9";

void expect_same(const Snapshot& a, const Snapshot& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 0u);
  const double scale[] = {1e-3, 1e-3, 1e-3, 1.0, 1.0, 1.0, 1e4};  // box, speeds, spin
  for (const auto& [id, row] : a) {
    ASSERT_EQ(b.count(id), 1u) << "particle " << id;
    for (int k = kX; k <= kSpinZ; ++k) {
      EXPECT_NEAR(row[k] / scale[k], b.at(id)[k] / scale[k], tolerance) << "particle " << id;
    }
  }
}

/// Round-off of sums in another order, grown by the collisions of 300 steps.
constexpr double kOtherOrder = 1e-9;

class CoupleBridgeModel : public ::testing::TestWithParam<const char*> {};

TEST_P(CoupleBridgeModel, TwoRanksOfEachGiveTheSameAsOne) {
  std::map<long, Snapshot> dumps[2];
  for (const int two : {0, 1}) {
    const LiggghtsCase c(std::string("couple_ranks_") + GetParam() + (two != 0 ? "_2" : "_1"));
    const std::string script = (two != 0 ? "processors 2 1 1\n" : "") + cloud(c, GetParam(), "");
    const Outcome o = c.couple(script, {interval() + kCloudGas + " log=log.txt", two + 1, two + 1});
    ASSERT_EQ(o.status, 0) << o.output;
    dumps[two] = read_dump(c.folder() / "all.dump");
    EXPECT_EQ(read_log(c.folder() / "log.txt").back()[2], 60.0);
  }
  expect_same(dumps[0][300], dumps[1][300], kOtherOrder);
}

INSTANTIATE_TEST_SUITE_P(Contacts, CoupleBridgeModel, ::testing::Values("hertz", "hooke", "jkr"),
                         [](const auto& info) { return std::string(info.param); });

TEST(CoupleBridge, SocketAndMpiAreIdentical) {
  std::map<long, Snapshot> dumps[2];
  for (const int socket : {0, 1}) {
    const LiggghtsCase c(socket != 0 ? "couple_socket" : "couple_mpi");
    const std::string script =
        cloud(c, "hertz", socket != 0 ? " transport socket rendezvous meet" : "");
    const Outcome o = c.couple(script, {interval() + kCloudGas, 2, 2, socket != 0});
    ASSERT_EQ(o.status, 0) << o.output;
    dumps[socket] = read_dump(c.folder() / "all.dump");
  }
  EXPECT_EQ(dumps[0], dumps[1]);
}

/// Grains that never touch: LIGGGHTS itself evaluates contacts anew at the start of each run.
std::string row_of_grains(const LiggghtsCase& c, const std::string& run) {
  std::vector<Sphere> spheres;
  for (int i = 0; i < 12; ++i) {
    spheres.push_back(grain(-0.9e-3 + 1.5e-4 * i));
    spheres.back().diameter = 40e-6 + 4e-6 * i;
    spheres.back().v[0] = 2.0;
    spheres.back().omega[2] = 100.0 * i;
  }
  c.write_spheres("spheres.data", spheres, 1e-3);
  std::string script = header(soft_spheres(), "spheres.data");
  script.replace(script.find("boundary m m m"), 14, "boundary f p p");
  return script + "fix weight all gravity 9.81 vector 0 0 -1\n" + kGas + dump_lines(10) +
         "thermo_modify lost ignore\n" + run;
}

TEST(CoupleBridge, SeveralRunsAreOne) {
  std::map<long, Snapshot> dumps[2];
  for (const int parts : {0, 1}) {
    const LiggghtsCase c(parts != 0 ? "couple_runs_3" : "couple_runs_1");
    const Outcome o =
        c.couple(row_of_grains(c, parts != 0 ? "run 55\nrun 4\nrun 41\n" : "run 100\n"),
                 {interval() + kCloudGas + " log=log.txt"});
    ASSERT_EQ(o.status, 0) << o.output;
    dumps[parts] = read_dump(c.folder() / "all.dump");
    EXPECT_EQ(read_log(c.folder() / "log.txt").size(), 10u);
  }
  expect_same(dumps[0][100], dumps[1][100], 1e-12);
}

/// Some grains leave the box before, around and after the checkpoint.
TEST(CoupleBridge, ARestartContinuesTheRun) {
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c("couple_restart_" + std::to_string(ranks));
    const std::string first = ranks == 2 ? "processors 2 1 1\n" : "";
    std::string script = first + row_of_grains(c, "run 200\n");
    Outcome o = c.couple(script, {interval() + kCloudGas + " checkpoint=12 log=log.txt", ranks, 1});
    ASSERT_EQ(o.status, 0) << o.output;
    ASSERT_TRUE(std::filesystem::exists(c.folder() / "post/restart.120")) << o.output;
    const Snapshot whole = read_dump(c.folder() / "all.dump")[200];
    ASSERT_GT(whole.size(), 3u);
    ASSERT_LT(whole.size(), 12u) << "some should have left";
    const auto log = read_log(c.folder() / "log.txt");
    std::filesystem::remove(c.folder() / "log.txt");

    script.replace(script.find("read_data spheres.data"), 22, "read_restart post/restart.120");
    script.replace(script.find("run 200"), 7, "run 80");
    o = c.couple(script, {interval() + kCloudGas + " time=1.2e-4 ahead=0 log=log.txt", ranks, 1});
    ASSERT_EQ(o.status, 0) << o.output;
    expect_same(whole, read_dump(c.folder() / "all.dump")[200], 1e-10);
    const auto again = read_log(c.folder() / "log.txt");
    ASSERT_EQ(again.size(), 8u);
    for (std::size_t i = 0; i < again.size(); ++i) {
      const auto& before = log[12 + i];
      EXPECT_EQ(again[i][0], before[0]) << "step";
      EXPECT_NEAR(again[i][3] / before[3], 1.0, 1e-9) << "reaction impulse of step " << before[0];
    }
  }
}

}  // namespace
}  // namespace powderlink::testing
