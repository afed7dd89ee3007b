// SPDX-License-Identifier: GPL-3.0-or-later
// fix couple/bridge in the real LIGGGHTS while particles come and go: whose values they have, and that
// the fluid hears of every impulse.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

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

TEST(CoupleBridge, NewParticlesTakeTheValuesOfTheNearestInTheFluid) {
  const LiggghtsCase c("couple_newcomers_nearest");
  // The wind says whose it is; the solver tells nothing of those below z = 0.
  const Outcome o = c.couple(with_stream(c, 1e-3) + kGas + dump_lines(1) + "run 300\n",
                             {interval() + "labels=1 above=0 box=-1e-3,1e-3"});
  ASSERT_EQ(o.status, 0) << o.output;
  const auto dump = read_dump(c.folder() / "all.dump");
  int borrowed = 0, outside = 0;
  for (long step = 1; step < 300; ++step) {
    for (const auto& [id, row] : dump.at(step)) {
      outside += row[kState] == 3.0 ? 1 : 0;
      if (row[kState] != 0.0 || step % kEvery == 0 || dump.at(step + 1).count(id) == 0) continue;
      long nearest = -1;
      double least = 1.0;
      for (const auto& [other, place] : dump.at(step)) {
        if (place[kState] != 1.0) continue;
        double distance2 = 0.0;
        for (int k = kX; k <= kZ; ++k) distance2 += (row[k] - place[k]) * (row[k] - place[k]);
        if (distance2 >= least) continue;
        least = distance2;
        nearest = other;
      }
      if (nearest < 0) continue;
      ++borrowed;
      EXPECT_EQ(dump.at(step + 1).at(id)[kState], 2.0);
      EXPECT_EQ(dump.at(step + 1).at(id)[kWindX], static_cast<double>(nearest)) << "step " << step;
    }
  }
  EXPECT_GT(borrowed, 20);
  EXPECT_GT(outside, 20);
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

/// Of velocities of 8 m/s, over what a step changes them by (1e-5 m/s).
constexpr double kRoundOff = 1e-10;

/// With a constant reacting force F every particle takes F dt in each step in which it has values of its
/// own; the dump of a step has the particles that the next one moves. Only a row for each that vanished
/// can bring the sum to that.
double expect_all_impulse_sent(const LiggghtsCase& c, double force, double mass_share = 1.0) {
  const auto dump = read_dump(c.folder() / "all.dump");
  const auto log = read_log(c.folder() / "log.txt");
  double expected = 0.0;
  long step = 0;
  std::set<long> ids;
  std::vector<double> sum(3, 0.0);
  for (const auto& row : log) {
    for (; step < static_cast<long>(row[0]); ++step) {
      for (const auto& [id, atom] : dump.at(step)) {
        ids.insert(id);
        // At an exchange all get their own.
        if (step % kEvery == 0 || atom[kState] == 1.0) expected += force * kStep * mass_share;
      }
    }
    for (int k = 0; k < 3; ++k) sum[k] += row[3 + k];
    EXPECT_NEAR(sum[0], expected, kRoundOff * expected) << "exchange of step " << row[0];
    EXPECT_EQ(row[2], static_cast<double>(dump.at(static_cast<long>(row[0])).size()));
  }
  EXPECT_GT(expected, 0.0);
  EXPECT_GT(ids.size(), dump.rbegin()->second.size()) << "none left: nothing was tested";
  EXPECT_LT(std::fabs(sum[1]) + std::fabs(sum[2]), kRoundOff * expected);
  return expected;
}

class CoupleBridgeVanished : public ::testing::TestWithParam<Traffic> {};

TEST_P(CoupleBridgeVanished, TheirImpulseIsSent) {
  const auto [kind, model, reuses_tags] = GetParam();
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c(std::string("couple_vanished_") + kind + "_" + std::to_string(ranks));
    std::string script = with_stream(c, 1e-3, kind, model) + kGas + dump_lines(1) +
                         "variable lost equal f_gas[6]\nrun 601\nprint \"lost ${lost} N s\"\n";
    if (ranks == 2) script = "processors 2 1 1\n" + script;
    const Outcome o =
        c.couple(script, {interval() + "react=1e-7 box=-1e-3,1e-3 log=log.txt", ranks, ranks});
    ASSERT_EQ(o.status, 0) << o.output;
    const double sent = expect_all_impulse_sent(c, 1e-7);
    const auto at = o.output.rfind("lost ");
    ASSERT_NE(at, std::string::npos) << o.output;
    EXPECT_LT(std::fabs(std::stod(o.output.substr(at + 5))), kRoundOff * sent);
  }
}

INSTANTIATE_TEST_SUITE_P(Insertions, CoupleBridgeVanished,
                         ::testing::Values(Traffic{"pack", "hertz", true},
                                           Traffic{"stream", "hooke", false}),
                         [](const auto& info) { return std::string(info.param.kind); });

/// They cross from rank to rank and fly out of the box; with added mass the fluid keeps its share.
TEST(CoupleBridge, ImpulseOfParticlesThatLeaveTheBoxIsSent) {
  for (const double added : {0.0, 0.5}) {
    for (const int ranks : {1, 2}) {
      const LiggghtsCase c("couple_leave_" + std::to_string(ranks) + (added > 0.0 ? "_added" : ""));
      std::vector<Sphere> spheres;
      for (int i = 0; i < 10; ++i) {
        spheres.push_back(grain(-0.3e-3 + 1.3e-4 * i));
        spheres.back().v[0] = 8.0;
      }
      c.write_spheres("spheres.data", spheres, 1e-3);
      std::string script = header(soft_spheres(), "spheres.data");
      script.replace(script.find("boundary m m m"), 14, "boundary f f f");
      if (ranks == 2) script = "processors 2 1 1\n" + script;
      std::string gas = interval() + "react=1e-8 box=-1e-3,1e-3 log=log.txt";
      if (added > 0.0) gas += " added_mass=" + text(added);
      const Outcome o = c.couple(
          script + kGas + dump_lines(1) + "thermo_modify lost ignore\nrun 101\n", {gas, ranks, 1});
      ASSERT_EQ(o.status, 0) << o.output;
      expect_all_impulse_sent(c, 1e-8, 1.0 / (1.0 + added));
    }
  }
}

TEST(CoupleBridge, WhatTheAddedMassGainsStaysInTheFluid) {
  // F + weight accelerate m + m_a: the fluid gave F, and got back m_a dv/dt.
  const double m = sphere_mass(kDiameter);
  const LiggghtsCase c("couple_added_mass_impulse");
  auto dump = run_grain(c, "fix weight all gravity 9.81 vector 1 0 0\n",
                        "added_mass=0.5 react=" + text(3.0 * m) + " log=log.txt", 101);
  double sum = 0.0;
  for (const auto& row : read_log(c.folder() / "log.txt")) {
    sum += row[3];
    const double expected = m * (3.0 - 0.5 * (3.0 + 9.81) / 1.5) * row[1];
    EXPECT_NEAR(sum / m, expected / m, 1e-14) << "step " << row[0];
  }
  EXPECT_LT(sum, 0.0);
}

}  // namespace
}  // namespace powderlink::testing
