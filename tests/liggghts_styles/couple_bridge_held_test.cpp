// SPDX-License-Identifier: GPL-3.0-or-later
// What a script holds of a grain's motion stays as it is, and the fluid feels the whole drag there.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "couple_bridge_case.h"

namespace powderlink::testing {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

constexpr Vector kWind = {2.0, 1.0, -1.0};
constexpr Vector kStart = {0.3, 0.2, 0.1};
constexpr Vector kReact = {2e-8, -1e-8, 3e-8};
constexpr double kRelaxed = 0.05;  // K dt/m
constexpr double kSpinRelaxed = 0.1;
constexpr double kFluidSpin = 40.0;
constexpr Matrix kAll = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kNothing = {};

/// A way to hold one grain and what it leaves free.
struct Kind {
  const char* fixes;  ///< for the group `one`
  Matrix free;        ///< projection of the velocity
  bool spins;
};

const Kind kKinds[] = {
    {"", kNothing, false},
    {"fix a# g# nve/noforce\n", kNothing, false},
    {"fix a# g# nve/sphere\n", kAll, true},
    {"fix a# g# nve\n", kAll, false},
    {"fix a# g# nve/limit absolute 1.0\n", kAll, false},
    {"fix a# g# nve/sphere\nfix b# g# setforce 0 NULL 0\n",
     {{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}},
     true},
    {"fix a# g# nve/sphere\nfix b# g# setforce v_zero v_zero v_zero\n", kNothing, true},
    {"fix a# g# nve/sphere\nfix b# g# setforce 0 0 0 region here\n", kNothing, true},
    {"fix a# g# nve/sphere\nfix b# g# setforce 0 0 0 region elsewhere\n", kAll, true},
    {"fix a# g# nve/sphere\nfix b# g# planeforce 1 1 0\n",
     {{{0.5, -0.5, 0}, {-0.5, 0.5, 0}, {0, 0, 1}}},
     true},
    {"fix a# g# nve/sphere\nfix b# g# lineforce 0 1 1\n",
     {{{0, 0, 0}, {0, 0.5, 0.5}, {0, 0.5, 0.5}}},
     true},
    {"fix a# g# move linear 0.3 NULL NULL units box\n", {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, false},
    {"fix a# g# move variable NULL NULL NULL NULL v_slow NULL units box\n",
     {{{1, 0, 0}, {0, 0, 0}, {0, 0, 1}}},
     false},
    {"fix a# g# nve/sphere\nfix b# g# freeze\n", kNothing, false},
    {"fix a# g# nve/sphere\nfix b# g# addforce 0 0 0\n", kAll, true},
};

std::string numbered(std::string text, int n) {
  for (auto at = text.find('#'); at != std::string::npos; at = text.find('#')) {
    text.replace(at, 1, std::to_string(n));
  }
  return text;
}

double drag() { return kRelaxed * sphere_mass(kDiameter) / kStep; }

std::string gas() {
  const double inertia = 0.1 * sphere_mass(kDiameter) * kDiameter * kDiameter;
  return interval() + "wind=2,1,-1 react=2e-8,-1e-8,3e-8 drag=" + text(drag()) +
         " turn=" + text(kFluidSpin) + "," + text(kSpinRelaxed * inertia / kStep) + ",0";
}

/// Columns: velocity, spin about z, reaction impulse.
std::string held_dump(int every) {
  return "dump h all custom " + std::to_string(every) +
         " held.dump id vx vy vz omegaz f_reactionImpulse[1] f_reactionImpulse[2] "
         "f_reactionImpulse[3]\ndump_modify h sort id format \"%d %.17g %.17g %.17g %.17g %.17g "
         "%.17g %.17g\"\n";
}

/// Velocity after n steps of free motion.
double relaxed(int c, int n) {
  const double limit = kWind[c] + kReact[c] / drag();
  return limit + (kStart[c] - limit) * std::exp(-kRelaxed * n);
}

void expect_motion(const Kind& kind, const std::vector<double>& row, const std::string& name) {
  const int n = kEvery;
  const double m = sphere_mass(kDiameter);
  for (int c = 0; c < 3; ++c) {
    // Free and held parts do not know of each other: drag is isotropic.
    double velocity = kStart[c];
    double impulse = n * kStep * (drag() * (kWind[c] - kStart[c]) + kReact[c]);
    for (int k = 0; k < 3; ++k) {
      const double gain = relaxed(k, n) - kStart[k];
      velocity += kind.free[c][k] * gain;
      impulse +=
          kind.free[c][k] * (m * gain - n * kStep * (drag() * (kWind[k] - kStart[k]) + kReact[k]));
    }
    // Roundings of ten steps
    EXPECT_NEAR(row[c], velocity, 1e-13) << name << ", velocity " << c;
    EXPECT_NEAR(row[4 + c] / m, impulse / m, 1e-12) << name << ", impulse " << c;
  }
  const double spin = kind.spins ? -kFluidSpin * std::expm1(-kSpinRelaxed * n) : 0.0;
  EXPECT_NEAR(row[3], spin, 1e-12 * kFluidSpin) << name << ", spin";
}

class CoupleBridgeHeld : public ::testing::TestWithParam<int> {};

TEST_P(CoupleBridgeHeld, TheGasActsOnWhatTheScriptLeavesFree) {
  const int ranks = GetParam();
  const LiggghtsCase c("couple_held_" + std::to_string(ranks));
  std::vector<Sphere> spheres;
  std::string fixes;
  for (const Kind& kind : kKinds) {
    const int n = static_cast<int>(spheres.size()) + 1;
    Sphere s = grain(-1.4e-3 + 2e-4 * n);
    std::copy(kStart.begin(), kStart.end(), s.v);
    spheres.push_back(s);
    fixes += numbered("group g# id #\n", n) + numbered(kind.fixes, n);
  }
  c.write_spheres("spheres.data", spheres, 1e-2);
  const Outcome o = c.couple(
      (ranks == 2 ? "processors 2 1 1\n" : "") + header(soft_spheres(), "spheres.data") +
          "variable zero equal 0.0\nvariable slow equal 0.2\nregion here block -1 1 -1 1 -1 1\n"
          "region elsewhere block -1 1 -1 1 1e-3 2e-3\n" +
          fixes + "fix gas all couple/bridge every 10" +
          (ranks == 2 ? " transport socket rendezvous meet" : "") + "\n" + held_dump(kEvery) +
          "run 10\n",
      {gas(), ranks, ranks, ranks == 2});
  ASSERT_EQ(o.status, 0) << o.output;
  auto dump = read_dump(c.folder() / "held.dump");
  ASSERT_EQ(dump[kEvery].size(), spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    expect_motion(kKinds[k], dump[kEvery].at(static_cast<long>(k) + 1),
                  "'" + std::string(kKinds[k].fixes) + "'");
  }
  EXPECT_NE(o.output.find("particles that do not move; given: 1 of 15 coupled"), std::string::npos)
      << o.output;
}

INSTANTIATE_TEST_SUITE_P(Ranks, CoupleBridgeHeld, ::testing::Values(1, 2));

TEST(CoupleBridgeHeldRuns, FixesComeAndGoBetweenRuns) {
  const LiggghtsCase c("couple_held_runs");
  Sphere s = grain(0.0);
  std::copy(kStart.begin(), kStart.end(), s.v);
  c.write_spheres("spheres.data", {s}, 1e-2);
  const Outcome o =
      c.couple(header(soft_spheres(), "spheres.data") +
                   "fix gas all couple/bridge every 10\nfix still all setforce 0 0 0\n"
                   "fix integrate all nve/sphere\n" +
                   held_dump(kEvery) + "run 10\nunfix still\nrun 10\nunfix integrate\nrun 10\n",
               {gas()});
  ASSERT_EQ(o.status, 0) << o.output;
  auto dump = read_dump(c.folder() / "held.dump");
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(dump[10].at(1)[k], kStart[k]);
    EXPECT_NEAR(dump[20].at(1)[k], relaxed(k, 10), 1e-13);
    EXPECT_EQ(dump[30].at(1)[k], dump[20].at(1)[k]);
  }
}

TEST(CoupleBridgeHeldRuns, AMeanOfForcesIsRefused) {
  const LiggghtsCase c("couple_held_mean");
  c.write_spheres("spheres.data", {grain(-1e-3), grain(1e-3)}, 1e-2);
  const Outcome o = c.couple(
      header(soft_spheres(), "spheres.data") + "fix mean all aveforce 0 0 0\n" + kGas + "run 10\n",
      {gas()});
  EXPECT_NE(o.status, 0);
  EXPECT_LT(o.status, 124) << o.output;
  for (const char* part : {"given: fix mean aveforce", "allowed: ", "to do: remove it"}) {
    EXPECT_NE(o.output.find(part), std::string::npos) << part << "\n" << o.output;
  }
}

}  // namespace
}  // namespace powderlink::testing
