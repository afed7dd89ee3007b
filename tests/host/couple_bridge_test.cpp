// SPDX-License-Identifier: GPL-3.0-or-later
// fix couple/bridge in the real LIGGGHTS, with a gas that is known: closed forms, momentum, ranks,
// particles that come and go, restart.
#include <cmath>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

/// Text of a number that keeps its digits.
std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

std::map<long, Snapshot> run_grain(const LiggghtsCase& c, const std::string& more,
                                   const std::string& solver, int steps,
                                   const Sphere& sphere = grain(0.0)) {
  c.write_spheres("spheres.data", {sphere}, 1e-2);
  const Outcome o = c.couple(header(soft_spheres(), "spheres.data") + more + kGas + dump_lines(1) +
                                 "run " + std::to_string(steps) + "\n",
                             {interval() + solver});
  EXPECT_EQ(o.status, 0) << o.output;
  return read_dump(c.folder() / "all.dump");
}

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

/// Grains of two sizes come, by fix insert/KIND, and go, through a mesh or the boundary.
std::string with_stream(const LiggghtsCase& c, double half, const std::string& kind = "pack",
                        const std::string& model = "hertz") {
  std::string script = header(soft_spheres(model), "");
  script.replace(script.find("boundary m m m"), 14, "boundary f f f");
  const std::string h = text(half);
  script.insert(script.find("neighbor"), "region box block -" + h + " " + h + " -" + h + " " + h +
                                             " -" + h + " " + h + " units box\ncreate_box 2 box\n");
  script.insert(script.find("pair_style"),
                "fix speed all property/global characteristicVelocity scalar 2.0\n");
  c.write_plate("plate.stl", half, 2);
  c.write_plate("face.stl", 0.5 * half, 2);
  const std::string pack =
      "region pack block -8e-4 -4e-4 -5e-4 5e-4 2e-4 6e-4 units box volume_limit 1e-16\n"
      "fix rain all insert/pack seed 32452867 distributiontemplate sizes insert_every 34 "
      "overlapcheck yes all_in yes vel constant 2.0 0. -8.0 region pack particles_in_region 12 "
      "ntry_mc 1000\n";
  // Held by the fix until they have passed the face.
  const std::string stream =
      "fix face all mesh/surface/planar file face.stl type 2 precision 1e-12 move 0 0 3e-4\n"
      "fix rain all insert/stream seed 32452867 distributiontemplate sizes nparticles INF "
      "particlerate 3.5e5 insert_every 34 overlapcheck yes maxattempt 100 "
      "vel constant 0. 0. -8.0 insertion_face face\n";
  return script +
         "fix small all particletemplate/sphere 86028157 atom_type 1 density constant 8000 radius "
         "constant 30e-6 volume_limit 1e-20\n"
         "fix large all particletemplate/sphere 49979687 atom_type 1 density constant 8000 radius "
         "constant 50e-6 volume_limit 1e-20\n"
         "fix sizes all particledistribution/discrete 67867967 2 small 0.5 large 0.5\n" +
         (kind == "pack" ? pack : stream) +
         "fix drain_mesh all mesh/surface file plate.stl type 2 precision 1e-12\n"
         "fix drain all massflow/mesh mesh drain_mesh vec_side 0. 0. -1. count once "
         "delete_atoms yes\n"
         "thermo_modify lost ignore\n";
}

struct Traffic {
  const char* kind;
  const char* model;
  bool reuses_tags;  ///< in a stream the highest tag is always one that has just come
};

void PrintTo(const Traffic& t, std::ostream* out) { *out << t.kind << " " << t.model; }

class CoupleBridgeTraffic : public ::testing::TestWithParam<Traffic> {};

TEST_P(CoupleBridgeTraffic, ParticlesThatComeAndGoKeepTheirOwnValues) {
  const auto [kind, model, reuses_tags] = GetParam();
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c(std::string("couple_come_and_go_") + kind + "_" + std::to_string(ranks));
    std::string script = with_stream(c, 1e-3, kind, model) + kGas + dump_lines(1) + "run 600\n";
    if (ranks == 2) script = "processors 2 1 1\n" + script;
    const Outcome o =
        c.couple(script, {interval() + "labels=1 box=-1e-3,1e-3 log=log.txt", ranks, ranks});
    ASSERT_EQ(o.status, 0) << o.output;
    auto dump = read_dump(c.folder() / "all.dump");
    long own = 0, borrowed = 0, reused = 0;
    std::map<long, double> radius_of;
    for (const auto& [step, atoms] : dump) {
      for (const auto& [id, row] : atoms) {
        if (radius_of.count(id) != 0 && radius_of[id] != row[kRadius]) ++reused;
        radius_of[id] = row[kRadius];
        if (row[kState] == 1.0) {
          ++own;
          ASSERT_EQ(row[kWindX], static_cast<double>(id)) << "step " << step;
          ASSERT_EQ(row[kWindY], row[kRadius]) << "step " << step;
        } else if (row[kState] == 2.0) {
          ++borrowed;
          EXPECT_GT(row[kWindX], 0.0) << "of some particle";
        }
      }
    }
    EXPECT_GT(own, 1000);
    EXPECT_GT(borrowed, 10);
    const auto log = read_log(c.folder() / "log.txt");
    for (const auto& row : log) {
      EXPECT_EQ(row[2], static_cast<double>(dump[static_cast<long>(row[0])].size()));
    }
    EXPECT_GT(radius_of.size(), dump[600].size()) << "none left: nothing was tested";
    EXPECT_EQ(reused > 0, reuses_tags);
  }
}

INSTANTIATE_TEST_SUITE_P(Insertions, CoupleBridgeTraffic,
                         ::testing::Values(Traffic{"pack", "hertz", true},
                                           Traffic{"stream", "hooke", false}),
                         [](const auto& info) { return std::string(info.param.kind); });

TEST(CoupleBridge, NewParticlesTakeTheDragOfTheirNeighbourAtOnce) {
  const LiggghtsCase c("couple_newcomers");
  const double eta = 2e-5;
  const std::string script = with_stream(c, 1e-3) + kGas + dump_lines(1) + "run 120\n";
  const Outcome o = c.couple(
      script, {interval() + "wind=1,0,0 box=-1e-3,1e-3 press=0,0,1e-10 stokes=" + text(eta)});
  ASSERT_EQ(o.status, 0) << o.output;
  const auto dump = read_dump(c.folder() / "all.dump");
  int borrowed = 0;
  for (const auto& [step, atoms] : dump) {
    for (const auto& [id, row] : atoms) {
      if (row[kState] != 2.0) continue;
      ++borrowed;
      EXPECT_EQ(row[kWindX], 1.0);
      const double stokes = 6.0 * 3.14159265358979323846 * eta * row[kRadius];
      EXPECT_NEAR(row[kDrag] / stokes, 1.0, 1e-12) << "Stokes drag goes with the diameter";
      const double ratio = row[kPressZ] / 1e-10;
      const double sizes = std::pow(50.0 / 30.0, 3);
      EXPECT_TRUE(std::fabs(ratio - 1.0) < 1e-12 || std::fabs(ratio / sizes - 1.0) < 1e-12 ||
                  std::fabs(ratio * sizes - 1.0) < 1e-12)
          << ratio;
    }
  }
  EXPECT_GT(borrowed, 10);
}

TEST(CoupleBridge, NewParticlesOnARankWithoutOthersTakeTheMeanAtOnce) {
  const LiggghtsCase c("couple_newcomers_mean");
  const double eta = 2e-5;
  std::string script = with_stream(c, 1e-3);
  // The only particle of the start is on the other rank.
  script.insert(script.find("region pack"),
                "create_atoms 1 single 5e-4 0 8e-4 units box\nset group all diameter 8e-5 density "
                "8000\n");
  script = "processors 2 1 1\n" + script + kGas + dump_lines(1) + "run 9\n";
  const Outcome o = c.couple(script, {interval() +
                                          "wind=1,0,0 box=-1e-3,1e-3 press=0,0,1e-10 "
                                          "stokes=" +
                                          text(eta),
                                      2, 1});
  ASSERT_EQ(o.status, 0) << o.output;
  const auto dump = read_dump(c.folder() / "all.dump");
  int borrowed = 0;
  for (const auto& [id, row] : dump.at(5)) {
    if (row[kX] > 0.0) continue;
    ++borrowed;
    EXPECT_EQ(row[kState], 2.0) << id;
    EXPECT_NEAR(row[kWindX], 1.0, 1e-12);
    const double r = row[kRadius];
    EXPECT_NEAR(row[kDrag] / (6.0 * 3.14159265358979323846 * eta * r), 1.0, 1e-12);
    EXPECT_NEAR(row[kPressZ] / (1e-10 * std::pow(r / 4e-5, 3)), 1.0, 1e-12);
  }
  EXPECT_GT(borrowed, 5);
}

TEST(CoupleBridge, ImpulseOfParticlesThatVanishIsCounted) {
  const LiggghtsCase c("couple_lost");
  Sphere s = grain(9.6e-4);
  s.v[0] = 8.0;
  c.write_spheres("spheres.data", {grain(-5e-4), s}, 1e-3);
  std::string script = header(soft_spheres(), "spheres.data");
  script.replace(script.find("boundary m m m"), 14, "boundary f f f");
  const Outcome o = c.couple(script + kGas +
                                 "thermo_modify lost ignore\nvariable lost equal f_gas[6]\n"
                                 "fix show all print 1 \"lost ${lost}\" file lost.txt screen no\n"
                                 "run 21\n",
                             {interval() + "react=1e-8 log=log.txt"});
  ASSERT_EQ(o.status, 0) << o.output;
  std::ifstream in(c.folder() / "lost.txt");
  double lost = 0.0;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("lost ", 0) == 0) lost = std::stod(line.substr(5));
  }
  const auto log = read_log(c.folder() / "log.txt");
  ASSERT_EQ(log.size(), 3u);
  EXPECT_EQ(log[1][2], 1.0);
  EXPECT_NEAR(log[1][3], 1e-8 * kEvery * kStep, 1e-25) << "of the one that stays";
  const double steps = lost / (1e-8 * kStep);
  EXPECT_NEAR(steps, std::round(steps), 1e-6);
  EXPECT_GE(steps, 4.5) << "the grain needs five steps to the boundary";
  EXPECT_LE(steps, 10.0);
}

}  // namespace
}  // namespace powderlink::testing
