// SPDX-License-Identifier: GPL-3.0-or-later
// Critical speed of one sphere (R 23 um, 316L on UPVC, Gamma 17.16): the energy theorem
// 1/2 m v^2 = W(C->D) against LIGGGHTS, from every kind of contact. Many spheres with speeds close
// to the expected one run beside each other; the fastest that stays and the slowest that leaves
// bracket the critical speed.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "liggghts_case.h"
#include "materials.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::testing {
namespace {

using namespace powderlink::physics;

constexpr double kRadius = 23e-6;
constexpr double kGamma = 17.16;
constexpr double kFlight_s = 3e-6;  // three periods of the contact; it decides in the first
constexpr int kSpheres = 81;
constexpr double kWindow = 2e-4;          // speeds differ from the expected one by up to this
constexpr double kToleranceTenth = 5e-5;  // the requirement at 0.1 Rayleigh times

JkrLaw law() { return {effective_youngs_modulus_Pa(steel, upvc), kGamma}; }
double expected_speed() { return critical_speed_instant_m_s(law(), kRadius, steel.density_kg_m3); }
double equilibrium_overlap() {
  const double a0 = law().equilibrium_contact_radius_m(kRadius);
  return a0 * a0 / (3.0 * kRadius);
}

struct Bracket {
  double slowest_leaving = 1e9, fastest_staying = 0.0;
  double middle() const { return 0.5 * (slowest_leaving + fastest_staying); }
};

double speed_of(int n, double window) {
  return expected_speed() * (1.0 + window * (2.0 * n / (kSpheres - 1) - 1.0));
}

Bracket bracket(const std::vector<double>& gaps, double window) {
  Bracket b;
  EXPECT_EQ(gaps.size(), static_cast<std::size_t>(kSpheres));
  for (int n = 0; n < static_cast<int>(gaps.size()); ++n) {
    const bool left = gaps[n] > -law().tear_off_overlap_m(kRadius);
    if (left) b.slowest_leaving = std::min(b.slowest_leaving, speed_of(n, window));
    if (!left) b.fastest_staying = std::max(b.fastest_staying, speed_of(n, window));
  }
  EXPECT_LT(b.fastest_staying, b.slowest_leaving) << "order of the spheres";
  EXPECT_GT(b.fastest_staying, 0.0) << "window too high";
  EXPECT_LT(b.slowest_leaving, 1e8) << "window too low";
  return b;
}

struct Place {
  double x, y;
};
/// Off the mesh's vertices by more than 0.1 nm: LIGGGHTS counts a sphere that stands exactly above
/// a vertex on two of its triangles (docs/reference.md, known limits of the hosts).
Place grid(int n, double spacing) {
  const int row = n / 9;
  return {(n % 9 - 4) * spacing + 2e-9, (row - 4) * spacing + 1e-9};
}

struct WallRun {
  bool mesh = false;
  int ranks = 1;
  double sideways_m_s = 0.0;  ///< speed along the plate: across the mesh's edges
  double rayleigh = 0.1;
  double window = kWindow;
  bool restart = false;
  std::string model_options = " tangential off";
};

double critical_speed_on_wall(const std::string& name, const WallRun& run) {
  Setting setting;
  setting.time_step = run.rayleigh * rayleigh_time_s(kRadius, steel);
  setting.model_options = run.model_options;
  constexpr double spacing = 60e-6;
  std::vector<Sphere> spheres;
  for (int n = 0; n < kSpheres; ++n) {
    Sphere s;
    const Place p = grid(n, spacing);
    s.x[0] = p.x;
    s.x[1] = p.y;
    // Edges lie on multiples of the spacing; the start decides when each sphere crosses one.
    if (run.sideways_m_s > 0.0) s.x[0] -= run.sideways_m_s * 0.8e-6 * (n % 40) / 40.0;
    s.x[2] = kRadius - equilibrium_overlap();
    s.v[0] = run.sideways_m_s;
    s.v[2] = speed_of(n, run.window);
    spheres.push_back(s);
  }
  const LiggghtsCase c(name);
  c.write_spheres("spheres.data", spheres, 6 * spacing);
  c.write_plate("plate.stl", 5 * spacing, 10);
  const std::string wall = run.mesh ? mesh_plate(setting) : primitive_plate(setting);
  const long steps = std::lround(kFlight_s / setting.time_step);
  Outcome o;
  if (run.restart) {
    const long first = steps / 20;  // 0.15 us: the spheres are in the neck
    o = c.run(header(setting, "spheres.data") + wall + "fix integrate all nve/sphere\nrun " +
                  std::to_string(first) + "\nwrite_restart middle.restart\n",
              run.ranks);
    EXPECT_EQ(o.status, 0) << o.output;
    std::string again = header(setting, "");
    const auto place = again.find("neighbor");
    again.insert(place, "read_restart middle.restart\n");
    o = c.run(again + wall + run_lines(steps - first), run.ranks);
  } else {
    o = c.run(header(setting, "spheres.data") + wall + run_lines(steps), run.ranks);
  }
  EXPECT_EQ(o.status, 0) << o.output;
  std::vector<double> gaps;
  for (const Sphere& s : o.last) gaps.push_back(s.x[2] - kRadius);
  return bracket(gaps, run.window).middle();
}

/// Two spheres with R* = 23 um and the reduced mass of one such sphere obey the same equation.
double critical_speed_of_pairs(const std::string& name, int ranks) {
  Setting setting;
  setting.time_step = 0.1 * rayleigh_time_s(kRadius, steel);
  constexpr double spacing = 130e-6;
  constexpr double radius = 2.0 * kRadius;
  std::vector<Sphere> spheres;
  for (int n = 0; n < kSpheres; ++n) {
    for (const int side : {0, 1}) {
      Sphere s;
      s.type = 1 + side;
      s.diameter = 2.0 * radius;
      s.density = steel.density_kg_m3 / 4.0;
      const Place p = grid(n, spacing);
      s.x[0] = p.x;
      s.x[1] = p.y;
      s.x[2] = (side == 0 ? -1.0 : 1.0) * (radius - 0.5 * equilibrium_overlap());
      s.v[2] = (side == 0 ? -0.5 : 0.5) * speed_of(n, kWindow);
      spheres.push_back(s);
    }
  }
  const LiggghtsCase c(name);
  c.write_spheres("spheres.data", spheres, 6 * spacing);
  const Outcome o =
      c.run(header(setting, "spheres.data") + run_lines(std::lround(kFlight_s / setting.time_step)),
            ranks);
  EXPECT_EQ(o.status, 0) << o.output;
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < o.last.size(); i += 2) {
    double r2 = 0.0;
    for (int k = 0; k < 3; ++k) r2 += std::pow(o.last[i].x[k] - o.last[i + 1].x[k], 2);
    gaps.push_back(std::sqrt(r2) - 2.0 * radius);
  }
  return bracket(gaps, kWindow).middle();
}

void expect_theory(double speed) {
  EXPECT_NEAR(speed / expected_speed(), 1.0, kToleranceTenth);
  EXPECT_NEAR(speed / 1.39895, 1.0, kToleranceTenth);
}

TEST(CriticalSpeed, PrimitiveWall) { expect_theory(critical_speed_on_wall("cs_primitive", {})); }

TEST(CriticalSpeed, PrimitiveWallTwoRanks) {
  WallRun run;
  run.ranks = 2;
  expect_theory(critical_speed_on_wall("cs_primitive_2", run));
}

TEST(CriticalSpeed, MeshWall) {
  WallRun run;
  run.mesh = true;
  expect_theory(critical_speed_on_wall("cs_mesh", run));
}

TEST(CriticalSpeed, MeshWallTwoRanks) {
  WallRun run;
  run.mesh = true;
  run.ranks = 2;
  expect_theory(critical_speed_on_wall("cs_mesh_2", run));
}

TEST(CriticalSpeed, AcrossMeshEdges) {
  WallRun run;
  run.mesh = true;
  run.sideways_m_s = 2.0;
  expect_theory(critical_speed_on_wall("cs_edges", run));
}

TEST(CriticalSpeed, AfterRestartInTheNeckPrimitive) {
  WallRun run;
  run.restart = true;
  expect_theory(critical_speed_on_wall("cs_restart", run));
}

TEST(CriticalSpeed, AfterRestartInTheNeckMeshTwoRanks) {
  WallRun run;
  run.restart = run.mesh = true;
  run.ranks = 2;
  expect_theory(critical_speed_on_wall("cs_restart_mesh", run));
}

TEST(CriticalSpeed, Pairs) { expect_theory(critical_speed_of_pairs("cs_pairs", 1)); }
TEST(CriticalSpeed, PairsTwoRanks) { expect_theory(critical_speed_of_pairs("cs_pairs_2", 2)); }

TEST(CriticalSpeed, FrictionAndRollingDoNotChangeAStraightPull) {
  WallRun run;
  run.model_options = " tangential history rolling_friction epsd2";
  expect_theory(critical_speed_on_wall("cs_friction", run));
}

TEST(CriticalSpeed, SecondOrderInTheTimeStep) {
  std::vector<double> error;
  for (const double fraction : {0.4, 0.8}) {
    WallRun run;
    run.rayleigh = fraction;
    run.window = 3e-3;
    error.push_back(critical_speed_on_wall("cs_order", run) / expected_speed() - 1.0);
  }
  const double order = std::log2(std::fabs(error[1] / error[0]));
  constexpr double kOrderTolerance =
      0.35;  // the spheres resolve the smaller error to a few per cent
  EXPECT_NEAR(order, 2.0, kOrderTolerance) << error[0] << ' ' << error[1];
}

}  // namespace
}  // namespace powderlink::testing
