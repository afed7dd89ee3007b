// SPDX-License-Identifier: GPL-3.0-or-later
// fix kat/drop in LIGGGHTS: critical diameters against the closed forms, the two frames, ranks,
// restart, effects, and the balances of energy and momentum.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "liggghts_case.h"
#include "materials.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::testing {
namespace {

using namespace powderlink::physics;
using nlohmann::json;

constexpr double kInstantTolerance = 2e-3;  // required of the instant stop
constexpr double kPulseTolerance = 5e-3;    // required of the half-sine stop
constexpr double kBalanceTolerance = 1e-6;  // of the impact energy or momentum, per grain
constexpr double kHalfRange = 0.02;         // sizes differ from the expected one by up to this
constexpr int kGrains = 81;                 // so the bracket is 0.05 % wide

struct Drop {
  const Material* particle = &steel;
  const Material* plate = &upvc;
  double gamma = 17.175;
  double velocity = 1.40;
  double expected_m = 46e-6;
  std::string stop = "instant";
  std::string more;   ///< further keywords of fix kat/drop
  std::string fixes;  ///< lines before it
  std::string after = "kat/run kat\n";
  double rayleigh = 0.1;
  bool mesh = false;
  int ranks = 1;
  double depth = 3e-3;
};

std::string script(const LiggghtsCase& c, const Drop& d) {
  Setting s;
  s.youngs_modulus[0] = d.particle->youngs_modulus_Pa;
  s.youngs_modulus[1] = d.plate->youngs_modulus_Pa;
  s.poissons_ratio[0] = d.particle->poissons_ratio;
  s.poissons_ratio[1] = d.plate->poissons_ratio;
  s.work_of_adhesion = d.gamma;
  s.time_step = d.rayleigh * rayleigh_time_s(0.5 * d.expected_m, *d.particle);
  const double half = 8.0 * d.expected_m;
  c.write_plate("plate.stl", half, 4);
  std::string text = header(s, "");
  std::ostringstream box;
  box << "region box block " << -half << ' ' << half << ' ' << -half << ' ' << half << ' '
      << -d.depth << " 2e-4 units box\ncreate_box 2 box\n";
  text.insert(text.find("neighbor"), box.str());
  std::ostringstream kat;
  kat.precision(17);
  kat << (d.mesh ? mesh_plate(s) : primitive_plate(s)) << "fix integrate all nve/sphere\n"
      << d.fixes << "fix kat all kat/drop wall plate plate zplane 0.0 fall -z velocity "
      << d.velocity << (d.stop.empty() ? "" : " stop " + d.stop) << " populate type 1 density "
      << d.particle->density_kg_m3 << " sizes range " << d.expected_m * (1.0 - kHalfRange) << ' '
      << d.expected_m * (1.0 + kHalfRange) << ' ' << kGrains << " results kat.json " << d.more
      << "\nthermo 100000\n"
      << d.after;
  return text + kat.str();
}

json read_results(const LiggghtsCase& c) {
  std::ifstream in(c.folder() / "kat.json");
  return in ? json::parse(in) : json();
}

json drop(const std::string& name, const Drop& d) {
  const LiggghtsCase c(name);
  const Outcome o = c.run(script(c, d), d.ranks);
  EXPECT_EQ(o.status, 0) << o.output.substr(0, 4000);
  return read_results(c);
}

void expect_balanced(const json& results) {
  EXPECT_EQ(results.at("out_of_order"), 0);
  for (const json& grain : results.at("particles")) {
    EXPECT_LT(std::fabs(grain.at("balance").get<double>()), kBalanceTolerance);
    EXPECT_LT(std::fabs(grain.at("momentum_balance").get<double>()), kBalanceTolerance);
  }
}

void expect_critical(const json& results, double expected_m, double tolerance) {
  ASSERT_TRUE(results.is_object() && results.at("critical_diameter_m").is_number());
  EXPECT_NEAR(results.at("critical_diameter_m").get<double>() / expected_m, 1.0, tolerance);
  expect_balanced(results);
}

TEST(KatDrop, InstantStopOnUpvc) {
  expect_critical(drop("kat_instant", {}), 46.03e-6, kInstantTolerance);
}

TEST(KatDrop, InstantStopOnGlass) {
  Drop d;
  d.plate = &glass;
  d.gamma = 107.6;
  d.velocity = 2.21;
  d.expected_m = 52.93e-6;
  expect_critical(drop("kat_glass_1", d), d.expected_m, kInstantTolerance);
  d.gamma = 102.84;
  d.velocity = 2.96;
  d.expected_m = 35.63e-6;
  expect_critical(drop("kat_glass_2", d), d.expected_m, kInstantTolerance);
}

Drop half_sine(double velocity, double expected_m) {
  Drop d;
  d.particle = d.plate = &glass;
  d.gamma = 0.09;
  d.velocity = velocity;
  d.expected_m = expected_m;
  d.stop = "halfsine 1e-4";
  d.rayleigh = 0.2;  // the stop is slow for the contact: the step matters little
  return d;
}

TEST(KatDrop, HalfSineStopOnSilanisedGlass) {
  const double table[][2] = {{1.8, 75.5e-6},  {2.3, 66.8e-6}, {3.0, 58.5e-6}, {4.1, 50.05e-6},
                             {4.8, 46.26e-6}, {5.4, 43.6e-6}, {6.0, 41.4e-6}};
  for (const auto& row : table) {
    expect_critical(drop("kat_half_sine", half_sine(row[0], row[1])), row[1], kPulseTolerance);
  }
}

TEST(KatDrop, MeshPlateAndMovingFrameAgreeWithThePlatesFrame) {
  Drop d = half_sine(3.0, 58.5e-6);
  const json in_plate_frame = drop("kat_frame_plate", d);
  d.mesh = true;
  const json on_mesh = drop("kat_frame_mesh", d);
  d.more = "frame moving";
  const json moving = drop("kat_frame_moving", d);
  expect_balanced(moving);
  ASSERT_EQ(in_plate_frame.at("particles").size(), moving.at("particles").size());
  constexpr double speed_tolerance =
      1e-5;  // of the impact speed: coordinates are rounded differently
  for (std::size_t i = 0; i < moving.at("particles").size(); ++i) {
    const json& a = in_plate_frame.at("particles")[i];
    EXPECT_EQ(a.at("attached"), moving.at("particles")[i].at("attached"));
    if (a.at("attached").get<bool>()) continue;  // oscillates; its phase is not compared
    for (const json* other : {&on_mesh, &moving}) {
      EXPECT_NEAR(a.at("speed_m_s").get<double>(),
                  other->at("particles")[i].at("speed_m_s").get<double>(),
                  speed_tolerance * d.velocity);
    }
  }
}

TEST(KatDrop, HertzPulseAndMeasuredHalfSine) {
  // The peak of sin^(3/2) is 1.1441 times that of the half-sine; slow stop: d_c ~ a^(-1/2).
  const double ratio =
      0.5 * JkrLaw::kPi * std::tgamma(1.25) / (std::sqrt(JkrLaw::kPi) * std::tgamma(1.75));
  Drop d = half_sine(3.0, 58.52e-6 * std::sqrt(ratio));
  d.stop = "hertz 1e-4";
  expect_critical(drop("kat_hertz", d), d.expected_m, kPulseTolerance);

  const LiggghtsCase c("kat_measured");
  std::ostringstream table;
  table << "# time [s], deceleration [m/s^2]\n";
  for (int i = 0; i <= 200; ++i) {
    table << 1e-4 * i / 200 << ' ' << 47000.0 * std::sin(JkrLaw::kPi * i / 200) << '\n';
  }
  c.write("stop.txt", table.str());
  d = half_sine(3.0, 58.5e-6);
  d.stop = "file stop.txt";
  const Outcome o = c.run(script(c, d));
  EXPECT_EQ(o.status, 0) << o.output;
  expect_critical(read_results(c), d.expected_m, kPulseTolerance);
}

TEST(KatDrop, PlateReboundActsAsAFasterImpact) {
  Drop d;
  d.more = "rebound 0.25";
  d.velocity = 1.40 / 1.25;
  expect_critical(drop("kat_rebound", d), 46.03e-6, kInstantTolerance);
}

TEST(KatDrop, ResidualSpeedFollowsTheEnergyTheorem) {
  const Drop d;
  const json results = drop("kat_residual", d);
  const JkrLaw law(effective_youngs_modulus_Pa(steel, upvc), d.gamma);
  constexpr double tolerance = 1e-4;  // of v^2: twice the speed's error at 0.1 Rayleigh times
  for (const json& grain : results.at("particles")) {
    if (grain.at("attached").get<bool>()) continue;
    const double radius = 0.5 * grain.at("diameter_m").get<double>();
    const double v = grain.at("speed_m_s").get<double>();
    const double work = 2.0 * detachment_work_J(law, radius) / sphere_mass_kg(radius, 7980.0);
    EXPECT_NEAR((v * v + work) / (d.velocity * d.velocity), 1.0, tolerance);
  }
}

TEST(KatDrop, TwoRanksGiveTheSame) {
  Drop d;
  const json one = drop("kat_one_rank", d);
  d.ranks = 2;
  const json two = drop("kat_two_ranks", d);
  EXPECT_EQ(one.at("critical_diameter_m"), two.at("critical_diameter_m"));
  for (std::size_t i = 0; i < one.at("particles").size(); ++i) {
    EXPECT_NEAR(one["particles"][i]["speed_m_s"].get<double>(),
                two["particles"][i]["speed_m_s"].get<double>(), 1e-10 * d.velocity);
  }
}

TEST(KatDrop, RestartInTheMiddleContinuesTheTest) {
  Drop d = half_sine(3.0, 58.5e-6);
  const json whole = drop("kat_whole", d);
  const LiggghtsCase c("kat_restart");
  d.after = "run 8000\nwrite_restart middle.restart\n";
  Outcome o = c.run(script(c, d));
  ASSERT_EQ(o.status, 0) << o.output;
  d.after = "kat/run kat\n";
  std::string again = script(c, d);
  const auto begin = again.find("region box");
  again.replace(begin, again.find("neighbor") - begin, "read_restart middle.restart\n");
  o = c.run(again);
  ASSERT_EQ(o.status, 0) << o.output;
  const json continued = read_results(c);
  EXPECT_EQ(whole.at("critical_diameter_m"), continued.at("critical_diameter_m"));
  constexpr double tolerance = 1e-8;  // of the impact speed: forces are summed anew at the restart
  for (std::size_t i = 0; i < whole.at("particles").size(); ++i) {
    if (whole["particles"][i]["attached"].get<bool>()) continue;
    EXPECT_NEAR(whole["particles"][i]["speed_m_s"].get<double>(),
                continued["particles"][i]["speed_m_s"].get<double>(), tolerance * d.velocity);
  }
  expect_balanced(continued);
}

TEST(KatDrop, RoughnessIsASmallerGamma) {
  const double asperity = 5e-6;
  Drop d;
  d.gamma = 17.175;
  d.fixes = "fix rough all adhesion/effect surface_roughness 5e-6\n";
  // d_c of the rough interface by fixed point: Gamma falls with the radius that it gives.
  double diameter = 46e-6;
  for (int i = 0; i < 100; ++i) {
    const JkrLaw law(effective_youngs_modulus_Pa(steel, upvc),
                     d.gamma / (1.0 + 0.5 * diameter / asperity));
    diameter = critical_diameter_instant_m(law, 7980.0, d.velocity);
  }
  d.expected_m = diameter;
  expect_critical(drop("kat_rough", d), diameter, kInstantTolerance);
}

TEST(KatDrop, ImageChargeHoldsEverythingBelowItsEscapeSpeed) {
  constexpr double sigma = 1.4e-4;
  constexpr double vacuum_permittivity = 8.8541878128e-12;
  const double escape =
      std::sqrt(1.5 * sigma * sigma / (glass.density_kg_m3 * vacuum_permittivity));
  Drop d;
  d.particle = d.plate = &glass;
  d.gamma = 0.01;        // hardly any adhesion: the charge alone decides
  d.more = "gravity 0";  // the closed form is that without weight
  d.expected_m = 50e-6;
  d.fixes = "fix charge all adhesion/effect electrostatic_image_force 1.4e-4\n";
  d.velocity = 0.99 * escape;
  EXPECT_EQ(drop("kat_charge_below", d).at("detached"), 0);
  d.velocity = 1.01 * escape;
  EXPECT_EQ(drop("kat_charge_above", d).at("attached"), 0);
}

TEST(KatDrop, EffectAndKeywordGiveTheSameStop) {
  Drop d = half_sine(4.1, 50.05e-6);
  const json by_keyword = drop("kat_stop_keyword", d);
  d.stop.clear();
  d.fixes = "fix stop all adhesion/effect finite_stop_pulse 1e-4 0\n";
  EXPECT_EQ(by_keyword.at("critical_diameter_m"),
            drop("kat_stop_effect", d).at("critical_diameter_m"));
}

TEST(KatDrop, FrictionDoesNotChangeTheCriticalDiameter) {
  Drop d;
  d.mesh = true;
  const LiggghtsCase c("kat_friction");
  std::string text = script(c, d);
  const std::string plain = "jkr tangential off";
  for (auto at = text.find(plain); at != std::string::npos; at = text.find(plain, at + 1)) {
    text.replace(at, plain.size(), "jkr tangential history rolling_friction epsd2");
  }
  const Outcome o = c.run(text);
  EXPECT_EQ(o.status, 0) << o.output;
  expect_critical(read_results(c), 46.03e-6, kInstantTolerance);
}

}  // namespace
}  // namespace powderlink::testing
