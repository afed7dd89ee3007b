// SPDX-License-Identifier: GPL-3.0-or-later
// Every wrong script line gets one message that names what failed, what was given, what is allowed
// and what to do; the exit status is not 0 and no result appears.
#include <gtest/gtest.h>

#include "liggghts_case.h"

namespace powderlink::testing {
namespace {

struct BadCase {
  const char* name;
  const char* find;        ///< in the good script ...
  const char* replace_by;  ///< ... gives the bad one
  const char* message;     ///< part of what must be said
};

void PrintTo(const BadCase& c, std::ostream* out) { *out << c.name; }

std::string good_script() {
  Setting s;
  s.work_of_adhesion = 1.0;
  std::string text = header(s, "");
  text.insert(text.find("neighbor"),
              "region box block -4e-4 4e-4 -4e-4 4e-4 -2e-3 2e-4 units box\ncreate_box 2 box\n");
  return text + primitive_plate(s) +
         "fix integrate all nve/sphere\n"
         "fix kat all kat/drop wall plate plate zplane 0.0 fall -z velocity 1.0 stop instant "
         "populate type 1 density 7980 sizes range 30e-6 60e-6 9 results kat.json\n"
         "thermo 100000\nkat/run kat\n";
}

class BadInput : public ::testing::TestWithParam<BadCase> {};

TEST_P(BadInput, IsRefusedWithOneClearMessage) {
  const BadCase& bad = GetParam();
  std::string text = good_script();
  const auto at = text.find(bad.find);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(bad.find).size(), bad.replace_by);
  const LiggghtsCase c(std::string("bad_") + bad.name);
  c.write("kat.json", "earlier result");
  c.write_plate("plate.stl", 3.9e-4, 4);
  const Outcome o = c.run(text);
  EXPECT_NE(o.status, 0) << o.output;
  EXPECT_LT(o.status, 124) << "neither a signal nor a time-out";
  EXPECT_NE(o.output.find(bad.message), std::string::npos) << o.output;
  for (const char* part : {"; given: ", "; allowed: ", "; to do: "}) {
    EXPECT_NE(o.output.find(part), std::string::npos) << part << '\n' << o.output;
  }
}

const BadCase cases[] = {
    {"negative_gamma", "workOfAdhesion peratomtypepair 2 0 1 1 0",
     "workOfAdhesion peratomtypepair 2 0 -1 -1 0", "workOfAdhesion"},
    {"time_step", "timestep 2.44", "timestep 244", "Rayleigh"},
    {"skin", "neighbor 5.0000000000000004e-06 bin", "neighbor 1e-10 bin", "skin"},
    {"mesh_precision",
     "fix plate all wall/gran model jkr tangential off primitive type 2 zplane 0.0",
     "fix cad all mesh/surface file plate.stl type 2\n"
     "fix plate all wall/gran model jkr tangential off mesh n_meshes 1 meshes cad",
     "precision"},
    {"zero_velocity", "velocity 1.0", "velocity 0", "velocity"},
    {"unknown_keyword", "stop instant", "stopp instant", "keyword"},
    {"unknown_stop", "stop instant", "stop slowly", "stop"},
    {"negative_size", "range 30e-6", "range -30e-6", "diameter"},
    {"no_wall", "wall plate plate", "wall nothing plate", "plate"},
    {"unknown_effect", "fix integrate", "fix e all adhesion/effect magic\nfix integrate", "effect"},
    {"effect_of_the_measurement", "fix integrate",
     "fix e all adhesion/effect psd_cutoff 60 8\nfix integrate", "belongs to the measurement"},
    {"gravity_twice", "fix integrate", "fix g all gravity 9.81 vector 0 0 -1\nfix integrate",
     "gravity"},
    {"box_too_small", "-4e-4 4e-4 -4e-4", "-5e-5 5e-5 -4e-4", "box"},
    {"frame", "stop instant", "stop instant frame moving", "mesh"},
    {"limit_force", "model jkr tangential off\n", "model jkr tangential off limitForce on\n",
     "limitForce"},
    {"cohesion", "model jkr tangential off\n", "model jkr tangential off cohesion sjkr\n", "sjkr"},
    {"rolling", "model jkr tangential off\n",
     "model jkr tangential history rolling_friction epsd\n", "epsd"},
    {"missing_gamma", "workOfAdhesion peratomtypepair", "otherName peratomtypepair",
     "workOfAdhesion"},
    {"weight", "workOfAdhesion peratomtypepair 2 0 1 1 0",
     "workOfAdhesion peratomtypepair 2 0 1e-9 1e-9 0", "fell off"},
    {"stop_file", "stop instant", "stop file nothing.txt", "stop file"},
};

INSTANTIATE_TEST_SUITE_P(Scripts, BadInput, ::testing::ValuesIn(cases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BadInputExtra, GoodScriptRuns) {
  const LiggghtsCase c("good");
  const Outcome o = c.run(good_script());
  EXPECT_EQ(o.status, 0) << o.output;
}

Outcome drop_of(const std::string& name, const std::vector<Sphere>& spheres) {
  Setting s;
  s.work_of_adhesion = 1.0;
  const LiggghtsCase c(name);
  c.write_spheres("spheres.data", spheres, 3e-4);
  return c.run(header(s, "spheres.data") + primitive_plate(s) +
               "fix integrate all nve/sphere\n"
               "fix kat all kat/drop wall plate plate zplane 0.0 velocity 1.0\nkat/run kat\n");
}

TEST(BadInputExtra, OverlappingGrainsAreNamed) {
  std::vector<Sphere> spheres(2);
  for (Sphere& sphere : spheres) sphere.x[2] = -23e-6;
  spheres[1].x[0] = 40e-6;  // diameters are 46 um
  const Outcome o = drop_of("bad_overlap", spheres);
  EXPECT_NE(o.status, 0);
  EXPECT_NE(o.output.find("grains 1 and 2 overlap"), std::string::npos) << o.output;
}

TEST(BadInputExtra, GrainDeepInThePlateIsRefused) {
  std::vector<Sphere> spheres(1);
  spheres[0].x[2] = -10e-6;
  const Outcome o = drop_of("bad_deep", spheres);
  EXPECT_NE(o.status, 0);
  EXPECT_NE(o.output.find("overlaps the plate"), std::string::npos) << o.output;
}

TEST(BadInputExtra, GrainsThatLeaveTheBoxAreCounted) {
  std::string text = good_script();
  text.replace(text.find("boundary m m m"), 14, "boundary f f f");
  text.replace(text.find("-2e-3 2e-4"), 10, "-8e-5 2e-4");
  text.replace(text.find("velocity 1.0"), 12, "velocity 10");
  const LiggghtsCase c("bad_lost");
  const Outcome o = c.run(text);
  EXPECT_NE(o.status, 0);
  EXPECT_NE(o.output.find("grains left it"), std::string::npos) << o.output;
  EXPECT_FALSE(std::filesystem::exists(c.folder() / "kat.json"));
}

TEST(BadInputExtra, MovingPlateIsNotRestarted) {
  std::string text = good_script();
  const std::string wall = "primitive type 2 zplane 0.0";
  text.replace(text.find(wall), wall.size(), "mesh n_meshes 1 meshes cad");
  text.insert(text.find("fix plate"),
              "fix cad all mesh/surface file plate.stl type 2 precision 1e-12\n");
  text.replace(text.find("stop instant"), 12, "frame moving");
  const LiggghtsCase c("bad_moving_restart");
  c.write_plate("plate.stl", 3.9e-4, 4);
  text.replace(text.find("kat/run kat"), 11, "run 3000\nwrite_restart middle.restart");
  Outcome o = c.run(text);
  ASSERT_EQ(o.status, 0) << o.output;
  const auto box = text.find("region box");
  text.replace(box, text.find("neighbor") - box, "read_restart middle.restart\n");
  o = c.run(text);
  EXPECT_NE(o.status, 0);
  EXPECT_NE(o.output.find("frame moving"), std::string::npos) << o.output;
}

TEST(BadInputExtra, SizesThatDoNotBracketAreWarnedOf) {
  std::string text = good_script();
  text.replace(text.find("velocity 1.0"), 12, "velocity 100");
  const Outcome o = LiggghtsCase("warn_bracket").run(text);
  EXPECT_NE(o.output.find("every grain left; add smaller ones"), std::string::npos) << o.output;
}

TEST(BadInputExtra, SurfaceEnergyInOtherUnitsIsWarnedOf) {
  std::string text = good_script();
  text.replace(text.find("peratomtypepair 2 0 1 1 0"), 25, "peratomtypepair 2 0 60 60 0");
  const LiggghtsCase c("warn_gamma");
  const Outcome o = c.run(text);
  EXPECT_NE(o.output.find("WARNING: model jkr: workOfAdhesion"), std::string::npos);
  EXPECT_NE(o.output.find("not a surface energy"), std::string::npos);
}

}  // namespace
}  // namespace powderlink::testing
