// SPDX-License-Identifier: GPL-3.0-or-later
// Model jkr in LIGGGHTS away from the KAT: touch and go, the Hertz limit, friction and rolling of a
// glued grain.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "liggghts_case.h"
#include "materials.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::testing {
namespace {

using namespace powderlink::physics;

constexpr double kRadius = 23e-6;
constexpr double kHalf = 300e-6;

Sphere above_plate(double gap, double speed_down) {
  Sphere s;
  s.x[2] = kRadius + gap;
  s.v[2] = -speed_down;
  return s;
}

Outcome run_on_plate(const LiggghtsCase& c, const Setting& s, const std::vector<Sphere>& spheres,
                     double time_s, LiggghtsCase::Program program = LiggghtsCase::Program::launcher,
                     const std::string& more = "") {
  c.write_spheres("spheres.data", spheres, kHalf);
  return c.run(header(s, "spheres.data") + primitive_plate(s) + more +
                   run_lines(std::lround(time_s / s.time_step)),
               1, program);
}

/// Energy that a touch and go takes, over S = (Gamma^5 R^4/E*^2)^(1/3).
double lost_energy(const std::string& name, double gamma, double speed, double rayleigh) {
  Setting s;
  s.work_of_adhesion = gamma;
  s.time_step = rayleigh * rayleigh_time_s(kRadius, steel);
  const LiggghtsCase c(name);
  const Outcome o = run_on_plate(c, s, {above_plate(1e-7, speed)}, 2e-6 + 4e-6 / speed);
  EXPECT_EQ(o.status, 0) << o.output;
  if (o.last.empty()) return 0.0;
  const double out = o.last[0].v[2];
  EXPECT_GT(out, 0.0);
  const double m = sphere_mass_kg(kRadius, steel.density_kg_m3);
  const double e = effective_youngs_modulus_Pa(steel, upvc);
  const double unit = std::cbrt(std::pow(gamma, 5) * std::pow(kRadius, 4) / (e * e));
  return 0.5 * m * (speed * speed - out * out) / unit;
}

constexpr double kTouchAndGo = 7.09219597;  // W(A->D)/S, closed form: physics/kat/kat_theory.h

TEST(JkrContact, TouchAndGoLosesTheHysteresisOfTheNeck) {
  constexpr double tolerance = 1e-4;  // required as dt -> 0
  EXPECT_NEAR(lost_energy("touch_and_go", 17.16, 2.0, 0.01) / kTouchAndGo, 1.0, tolerance);
}

TEST(JkrContact, TouchAndGoIsSecondOrderInTheTimeStep) {
  // The instants of touch and tear-off scatter within a step; speeds close to each other average
  // it.
  double error[2] = {0.0, 0.0};
  constexpr int samples = 12;
  for (const int coarse : {0, 1}) {
    for (int i = 0; i < samples; ++i) {
      const double e =
          lost_energy("touch_and_go_order", 17.16, 2.0 + 0.007 * i, coarse != 0 ? 0.4 : 0.1);
      error[coarse] += std::pow(e / kTouchAndGo - 1.0, 2) / samples;
    }
  }
  const double order = 0.5 * std::log2(error[1] / error[0]) / 2.0;
  EXPECT_GT(order, 1.7) << std::sqrt(error[0]) << ' ' << std::sqrt(error[1]);
}

TEST(JkrContact, GammaZeroIsStockHertz) {
  // The same script once with LIGGGHTS's hertz and once with jkr; damped, with friction and spin.
  std::vector<Sphere> ends[2];
  for (const int jkr : {0, 1}) {
    Setting s;
    s.model = jkr != 0 ? "jkr" : "hertz";
    s.model_options = " tangential history rolling_friction cdt";
    s.work_of_adhesion = 0.0;
    s.restitution = 0.7;
    Sphere first = above_plate(1e-7, 1.0);
    first.v[0] = 0.4;
    first.omega[1] = 3e3;
    Sphere second = first;  // falls onto the first
    second.x[2] += 2.0 * kRadius + 5e-7;
    second.x[0] += 3e-6;
    second.v[2] = -2.0;
    const LiggghtsCase c(jkr != 0 ? "hertz_by_jkr" : "hertz_stock");
    const Outcome o = run_on_plate(c, s, {first, second}, 4e-6);
    ASSERT_EQ(o.status, 0) << o.output;
    ends[jkr] = o.last;
  }
  ASSERT_EQ(ends[0].size(), 2u);
  ASSERT_EQ(ends[1].size(), 2u);
  constexpr double tolerance = 1e-9;  // rounding: the two write the same law in another order
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(ends[0][i].v[k], ends[1][i].v[k], tolerance);
      EXPECT_NEAR(ends[0][i].omega[k], ends[1][i].omega[k], tolerance * 1e5);
    }
  }
}

/// Two soft grains that swing about their equilibrium, across overlap and gap.
TEST(JkrContact, ComputesOfContactsKnowNecksOrAWarningSaysSo) {
  Setting s;
  s.youngs_modulus[0] = 1e8;
  s.work_of_adhesion_same = 1e-2;
  s.time_step = 2e-8;
  Sphere first = above_plate(1e-4, 0.0), second = first;
  second.x[0] = 2.0 * kRadius - 2e-8;
  second.v[0] = 8e-3;
  const LiggghtsCase c("computes_of_necks");
  c.write_spheres("spheres.data", {first, second}, kHalf);
  const Outcome o =
      c.run(header(s, "spheres.data") +
            "fix integrate all nve/sphere\ncompute overlaps all contact/atom\n"
            "compute contacts all contact/atom/gran\n"
            "compute pairs all pair/gran/local history contactArea delta\n"
            "fix k all property/global thermalConductivity peratomtype 10 10\n"
            "fix heat_capacity all property/global thermalCapacity peratomtype 500 500\n"
            "fix heat all heat/gran initial_temperature 300\n"
            "dump a all custom 1 atoms.dump id c_overlaps c_contacts\n"
            "dump p all local 1 pairs.dump c_pairs[1] c_pairs[2] c_pairs[3]\n"
            "dump_modify p format \"%.17g %.17g %.17g\"\nrun 300\nrun 300\n");
  ASSERT_EQ(o.status, 0) << o.output;
  for (const char* warning :
       {"fix heat heat/gran conducts", "compute overlaps contact/atom does not count",
        "compute pairs contactArea is"}) {
    const auto at = o.output.find(warning);
    EXPECT_NE(at, std::string::npos) << warning;
    EXPECT_EQ(o.output.find(warning, at + 1), std::string::npos) << "said again";
  }
  std::ifstream atoms(c.folder() / "atoms.dump"), pairs(c.folder() / "pairs.dump");
  const JkrLaw law(0.5 * 1e8 / (1.0 - 0.3 * 0.3), s.work_of_adhesion_same);
  int gaps = 0;
  for (std::string line; std::getline(pairs, line);) {
    if (line.rfind("ITEM: ENTRIES", 0) != 0) continue;
    double root = 0.0, area = 0.0, overlap = 0.0;
    pairs >> root >> area >> overlap;
    ASSERT_TRUE(pairs) << "a neck has no row";
    while (std::getline(atoms, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
    }
    int id = 0, overlaps = 0, contacts = 0;
    atoms >> id >> overlaps >> contacts;
    EXPECT_EQ(contacts, 1);
    EXPECT_EQ(overlaps, overlap > 0.0 ? 1 : 0);
    if (overlap > 0.0) continue;
    ++gaps;
    EXPECT_LE(area, 0.0);
    const double a = root * root, radius = 0.5 * kRadius;
    // JKR's own relation of overlap and contact radius; the history is of the step before.
    const double of_radius = a * a / radius - std::sqrt(2.0 * M_PI * s.work_of_adhesion_same * a /
                                                        law.effective_modulus_Pa());
    EXPECT_NEAR(of_radius, overlap, 0.02 * a * a / radius);
  }
  EXPECT_GT(gaps, 20);
}

TEST(JkrContact, AWallTakesTangentialDampingAtTheEndOfItsLineAsStockHertzDoes) {
  constexpr double tolerance = 1e-9;
  for (const bool mesh : {false, true}) {
    std::vector<Sphere> ends[3];  // stock without, jkr without, jkr with the damping
    for (const int kind : {0, 1, 2}) {
      Setting s;
      s.model = kind == 0 ? "hertz" : "jkr";
      s.model_options = " tangential history";
      s.work_of_adhesion = 0.0;
      s.restitution = 0.5;
      Sphere grain = above_plate(1e-7, 1.0);
      grain.x[0] = 1e-5;  // beside the edges
      grain.v[0] = 0.2;
      const LiggghtsCase c("wall_damping");
      c.write_spheres("spheres.data", {grain}, kHalf);
      c.write_plate("plate.stl", kHalf, 1);
      std::string plate = mesh ? mesh_plate(s) : primitive_plate(s);
      if (kind < 2) plate.insert(plate.size() - 1, " tangential_damping off");
      const Outcome o =
          c.run(header(s, "spheres.data") + plate + run_lines(std::lround(4e-7 / s.time_step)));
      ASSERT_EQ(o.status, 0) << o.output;
      ends[kind] = o.last;
      ASSERT_EQ(ends[kind].size(), 1u);
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ends[0][0].v[k], ends[1][0].v[k], tolerance) << mesh;
    EXPECT_GT(std::fabs(ends[2][0].v[0] - ends[1][0].v[0]), 1e3 * tolerance) << mesh;
  }
}

TEST(JkrContact, FrictionHoldsAGrainThatOnlyAdhesionPresses) {
  // Pulled sideways by a = 0.9 and 1.1 of mu (F + 2 F_po)/m at F = 0, the unloaded equilibrium.
  const JkrLaw law(effective_youngs_modulus_Pa(steel, upvc), 0.5);
  const double m = sphere_mass_kg(kRadius, steel.density_kg_m3);
  const double limit = 0.5 * 2.0 * law.pull_off_force_N(kRadius) / m;
  const double a0 = law.equilibrium_contact_radius_m(kRadius);
  constexpr double time = 2e-5;
  double speed[2];
  for (const int above : {0, 1}) {
    Setting s;
    s.work_of_adhesion = 0.5;
    s.restitution = 0.3;
    s.model_options = " tangential history";
    Sphere grain = above_plate(-a0 * a0 / (3.0 * kRadius), 0.0);
    const LiggghtsCase c("friction");
    c.write_spheres("spheres.data", {grain}, kHalf);
    const double pull = (above != 0 ? 1.1 : 0.9) * limit;
    // No rotation: nve for the centre only, so that sliding is not turned into rolling.
    const Outcome o =
        c.run(header(s, "spheres.data") + primitive_plate(s) + "fix pull all addforce " +
              std::to_string(pull * m * 1e9) + "e-9 0 0\nfix integrate all nve\n" +
              dump_line(std::lround(time / s.time_step)) + "run " +
              std::to_string(std::lround(time / s.time_step)) + "\n");
    ASSERT_EQ(o.status, 0) << o.output;
    ASSERT_EQ(o.last.size(), 1u);
    speed[above] = o.last[0].v[0];
  }
  EXPECT_LT(std::fabs(speed[0]), 0.01 * limit * time) << "sticks below the limit";
  EXPECT_NEAR(speed[1] / (0.1 * limit * time), 1.0, 0.1) << "slides with what exceeds the limit";
}

TEST(JkrContact, SpringsSurviveInTheNeck) {
  // A glued grain that swings normally enters the neck in each period; its friction spring must go
  // on holding it against a sideways pull. Dropped springs would let it creep in every swing.
  const JkrLaw law(effective_youngs_modulus_Pa(steel, upvc), 17.16);
  const double m = sphere_mass_kg(kRadius, steel.density_kg_m3);
  const double a0 = law.equilibrium_contact_radius_m(kRadius);
  Setting s;
  s.model_options = " tangential history rolling_friction epsd2";
  Sphere grain = above_plate(-a0 * a0 / (3.0 * kRadius), 0.0);
  grain.v[2] = 0.97 * critical_speed_instant_m_s(law, kRadius, steel.density_kg_m3);
  const LiggghtsCase c("neck_springs");
  c.write_spheres("spheres.data", {grain}, kHalf);
  const double pull = 0.02 * law.pull_off_force_N(kRadius);
  const long steps = 20000;
  const Outcome o =
      c.run(header(s, "spheres.data") + primitive_plate(s) + "fix pull all addforce " +
            std::to_string(pull * 1e9) + "e-9 0 0\nfix integrate all nve\n" + dump_line(steps) +
            "run " + std::to_string(steps) + "\n");
  ASSERT_EQ(o.status, 0) << o.output;
  ASSERT_EQ(o.last.size(), 1u);
  const double free_travel = 0.5 * pull / m * std::pow(steps * s.time_step, 2);
  EXPECT_LT(std::fabs(o.last[0].x[0]), 0.02 * free_travel);
}

TEST(JkrContact, DampingActsInTheNeckToo) {
  // A grain swinging in its neck (attached, e < 1) must lose energy to rest at the equilibrium.
  const JkrLaw law(effective_youngs_modulus_Pa(steel, upvc), 17.16);
  const double a0 = law.equilibrium_contact_radius_m(kRadius);
  Setting s;
  s.restitution = 0.5;
  Sphere grain = above_plate(-a0 * a0 / (3.0 * kRadius), 0.0);
  grain.v[2] = 0.5;
  const LiggghtsCase c("neck_damping");
  const Outcome o = run_on_plate(c, s, {grain}, 4e-5);
  ASSERT_EQ(o.status, 0) << o.output;
  EXPECT_NEAR((kRadius - o.last[0].x[2]) / (a0 * a0 / (3.0 * kRadius)), 1.0, 1e-4);
}

/// One run with the line of a fix adhesion/effect and a normal model.
std::string said_of_effect(const std::string& name, const std::string& effect,
                           const std::string& model) {
  Setting s;
  s.model = model;
  const Outcome o = run_on_plate(LiggghtsCase(name), s, {above_plate(1e-6, 0.1)}, 10 * s.time_step,
                                 LiggghtsCase::Program::launcher,
                                 "fix film all adhesion/effect " + effect + "\n");
  EXPECT_EQ(o.status, 0) << o.output;
  return o.output;
}

TEST(ContactEffects, AreWarnedOfWhenNothingReadsThem) {
  const std::string warning = "WARNING: fix film adhesion/effect does nothing";
  const std::string gap = said_of_effect("effect_gap", "electrostatic_image_force 1e-4", "jkr");
  EXPECT_NE(gap.find(warning), std::string::npos) << gap;
  EXPECT_NE(gap.find("beside fix kat/drop"), std::string::npos) << gap;
  const std::string contact = said_of_effect("effect_hertz", "surface_roughness", "hertz");
  EXPECT_NE(contact.find(warning), std::string::npos) << contact;
  EXPECT_NE(contact.find("with model jkr"), std::string::npos) << contact;
  const std::string read = said_of_effect("effect_read", "surface_roughness", "jkr");
  EXPECT_EQ(read.find("does nothing"), std::string::npos) << read;
}

}  // namespace
}  // namespace powderlink::testing
