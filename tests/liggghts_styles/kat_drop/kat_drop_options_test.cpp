// SPDX-License-Identifier: GPL-3.0-or-later
// The line of fix kat/drop: what it means and how a wrong one is refused.
#include "liggghts_styles/kat_drop/kat_drop_options.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "liggghts_styles/kat_drop/kat_population.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using host::KatDropOptions;
using physics::StopPulse;
using test::refuses;

constexpr double kRounding = 1e-13;
const std::string kNeeded = "wall plate_wall plate zplane 1e-3 velocity 1.4 ";

KatDropOptions parse(const std::string& line) {
  std::istringstream in("kat all kat/drop " + line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> arg;
  arg.reserve(words.size());
  for (const std::string& word : words) arg.push_back(word.c_str());
  return KatDropOptions::parse(static_cast<int>(arg.size()), arg.data());
}
auto parsing(const std::string& line) {
  return [line] { parse(line); };
}

class StopFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            ("powderlink_stop_" + std::string(info->name()) + std::to_string(::getpid()));
  }
  void TearDown() override { std::filesystem::remove(path_); }
  std::string line(const std::string& text) {
    std::ofstream(path_) << text;
    return kNeeded + "stop file " + path_.string();
  }
  std::filesystem::path path_;
};

TEST(KatDropOptions, DefaultsOfTheShortestLine) {
  const KatDropOptions o = parse(kNeeded);
  EXPECT_EQ(o.wall_id, "plate_wall");
  EXPECT_EQ(o.axis, 2);
  EXPECT_EQ(o.plate_position, 1e-3);
  EXPECT_EQ(o.direction, -1.0);
  EXPECT_EQ(o.velocity_m_s, 1.4);
  EXPECT_FALSE(o.stop_given);
  EXPECT_EQ(o.stop.shape(), StopPulse::Shape::instant);
  EXPECT_EQ(o.stop.rebound(), 0.0);
  EXPECT_FALSE(o.moving_frame);
  EXPECT_EQ(o.gravity_m_s2, 9.81);
  EXPECT_EQ(o.settle_limit_s, 0.0);
  EXPECT_EQ(o.watch_s, 0.0);
  EXPECT_TRUE(o.results_file.empty());
  EXPECT_EQ(o.populate_type, 0);
  EXPECT_TRUE(o.diameters_m.empty());
}

TEST(KatDropOptions, EveryKeyword) {
  const KatDropOptions o = parse(
      "velocity 3 plate xplane -0.5 fall +x wall w stop halfsine 1e-4 rebound 0.25 frame moving "
      "gravity 0 settle 1e-3 watch 2e-5 results out.json populate type 2 density 2510 sizes range "
      "2e-5 8e-5 9");
  EXPECT_EQ(o.axis, 0);
  EXPECT_EQ(o.plate_position, -0.5);
  EXPECT_EQ(o.direction, 1.0);
  EXPECT_EQ(o.velocity_m_s, 3.0);
  EXPECT_TRUE(o.stop_given);
  EXPECT_EQ(o.stop.shape(), StopPulse::Shape::half_sine);
  EXPECT_EQ(o.stop.duration_s(), 1e-4);
  EXPECT_EQ(o.stop.rebound(), 0.25);
  EXPECT_TRUE(o.moving_frame);
  EXPECT_EQ(o.gravity_m_s2, 0.0);
  EXPECT_EQ(o.settle_limit_s, 1e-3);
  EXPECT_EQ(o.watch_s, 2e-5);
  EXPECT_EQ(o.results_file, "out.json");
  EXPECT_EQ(o.populate_type, 2);
  EXPECT_EQ(o.density_kg_m3, 2510.0);
  EXPECT_EQ(o.diameters_m, host::graded_diameters(2e-5, 8e-5, 9));
}

TEST(KatDropOptions, PlanesAndDirections) {
  const std::string planes = "xyz";
  for (int axis = 0; axis < 3; ++axis) {
    for (const char sign : {'-', '+'}) {
      const std::string way = std::string(1, sign) + planes[static_cast<std::size_t>(axis)];
      const KatDropOptions o =
          parse("wall w velocity 1 plate " + way.substr(1) + "plane 0 fall " + way);
      EXPECT_EQ(o.axis, axis);
      EXPECT_EQ(o.direction, sign == '-' ? -1.0 : 1.0);
    }
  }
}

TEST(KatDropOptions, StopsTakeTheReboundWhereverItStands) {
  for (const std::string& stop :
       std::vector<std::string>{"instant", "hertz 2e-4", "halfsine 2e-4"}) {
    for (const std::string& line :
         std::vector<std::string>{"rebound 0.5 stop " + stop, "stop " + stop + " rebound 0.5"}) {
      EXPECT_EQ(parse(kNeeded + line).stop.speed_change_m_s(2.0), 3.0) << line;
    }
  }
  EXPECT_EQ(parse(kNeeded + "stop hertz 2e-4").stop.shape(), StopPulse::Shape::hertz);
  EXPECT_TRUE(parse(kNeeded + "stop instant").stop_given);
}

TEST(KatDropOptions, Sizes) {
  const std::string populate = kNeeded + "populate type 1 density 7980 sizes ";
  EXPECT_EQ(parse(populate + "list 3 5e-5 2e-5 3e-5").diameters_m,
            (std::vector<double>{5e-5, 2e-5, 3e-5}));
  EXPECT_EQ(parse(populate + "rosinrammler 6e-5 3.5 2e-5 1e-4 40 11").diameters_m,
            host::rosin_rammler_diameters(6e-5, 3.5, 2e-5, 1e-4, 40, 11));
  EXPECT_EQ(parse(populate + "range 3e-5 3e-5 1").diameters_m, std::vector<double>{3e-5});
  EXPECT_EQ(parse(populate + "list 1 5e-5 gravity 1.6").gravity_m_s2, 1.6)
      << "the line goes on after the sizes";
}

TEST_F(StopFile, IsAMeasuredPulse) {
  const KatDropOptions o = parse(
      line("# time deceleration\n0 0\n\n 5e-5   1000 # peak\n1e-4 0 17 more\n") + " rebound 0.2");
  EXPECT_EQ(o.stop.shape(), StopPulse::Shape::measured);
  EXPECT_NEAR(o.stop.duration_s(), 1e-4, kRounding * 1e-4);
  EXPECT_NEAR(o.stop.measured_speed_change_m_s(), 0.05, kRounding);
  const double peak = 2 * 1.4 * 1.2 / 1e-4;  // of a triangle
  EXPECT_NEAR(o.stop.peak_deceleration_m_s2(1.4), peak, kRounding * peak);
}

TEST_F(StopFile, NamesTheBadLine) {
  EXPECT_TRUE(refuses(parsing(line("0 0\n1e-5 fast\n")), "line 2", "1e-5 fast"));
  EXPECT_TRUE(refuses(parsing(line("time,a\n0 0\n")), "line 1", "time,a"));
  EXPECT_TRUE(refuses(parsing(line("0 0\n# note\n1e-5\n")), "line 3", "1e-5"));
  EXPECT_TRUE(refuses(parsing(line("0 0\n-\n1 1\n")), "line 2", "-"));
  EXPECT_TRUE(refuses(parsing(line("0 0\n1e\n1 1\n")), "line 2", "1e"));
  EXPECT_TRUE(refuses(parsing(line("")), "measured stop", "0 rows"));
  EXPECT_TRUE(refuses(parsing(line("1e-5 1\n0 1\n")), "time of row 2"));
  EXPECT_TRUE(refuses(parsing(line("0 -1\n1 -1\n")), "integral of the deceleration"));
  EXPECT_TRUE(refuses(parsing(kNeeded + "stop file no/such/file"), "stop file", "no/such/file"));
}

struct BadLine {
  std::string line, what, given;
};

TEST(KatDropOptions, RefusesLinesThatAreNotComplete) {
  for (const std::string& line : std::vector<std::string>{
           "plate zplane 0 velocity 1", "wall w velocity 1", "wall w plate zplane 0", ""}) {
    EXPECT_TRUE(refuses(parsing(line), "fix kat/drop", "without wall, plate or velocity")) << line;
  }
  for (const BadLine& bad : std::vector<BadLine>{
           {"wall", "wall", ""},
           {"plate", "plate", ""},
           {"plate zplane", "plate coordinate", ""},
           {"velocity", "velocity", ""},
           {"fall", "fall", ""},
           {"stop", "stop", ""},
           {"stop halfsine", "stop duration", ""},
           {"stop file", "stop file", ""},
           {"frame", "frame", ""},
           {"results", "results", ""},
           {"populate", "populate", ""},
           {"populate type 1 density 1 sizes", "populate sizes", ""},
           {"populate type 1 density 1 sizes list 2 1e-5", "populate sizes list", ""}}) {
    EXPECT_TRUE(refuses(parsing(kNeeded + bad.line), bad.what, "nothing (end of the line)"))
        << bad.line;
  }
}

TEST(KatDropOptions, RefusesBadValues) {
  const std::string populate = "populate type 1 density 7980 sizes ";
  for (const BadLine& bad : std::vector<BadLine>{
           {"speed 3", "keyword of fix kat/drop", "speed"},
           {"velocity 0", "velocity", "0"},
           {"velocity -1.4", "velocity", "-1.4"},
           {"velocity nan", "velocity", "nan"},
           {"velocity inf", "velocity", "inf"},
           {"velocity 1001", "velocity", "1001"},
           {"velocity 1.4m", "velocity", "1.4m"},
           {"plate diagonal 0", "plate", "diagonal"},
           {"plate zplane here", "plate coordinate", "here"},
           {"fall z", "fall", "z"},
           {"fall -w", "fall", "-w"},
           {"fall -x", "fall", "-x"},
           {"stop softly", "stop", "softly"},
           {"stop halfsine 0", "stop duration", "0"},
           {"stop hertz -1e-4", "stop duration", "-1e-4"},
           {"rebound 1.1", "rebound", "1.1"},
           {"rebound -0.1", "rebound", "-0.1"},
           {"frame inertial", "frame", "inertial"},
           {"gravity -9.81", "gravity", "-9.81"},
           {"settle 0", "settle time", "0"},
           {"watch -1", "watch time", "-1"},
           {"populate type 1.5 density 1 sizes", "populate type", "1.5"},
           {"populate species 1", "populate", "no keyword 'type'"},
           {"populate type 0 density 1 sizes", "populate type", "0"},
           {"populate type 1 rho 1 sizes", "populate", "no keyword 'density'"},
           {"populate type 1 density -1 sizes", "populate density", "-1"},
           {"populate type 1 density 1 range 1 2 3", "populate", "no keyword 'sizes'"},
           {populate + "normal 5e-5 1e-5", "populate sizes", "normal"},
           {populate + "range 8e-5 2e-5 5", "populate sizes", "8e-05 .. 2e-05"},
           {populate + "range 0 2e-5 5", "smallest diameter", "0"},
           {populate + "range 1e-5 2e-5 0", "number", "0"},
           {populate + "list 0", "number", "0"},
           {populate + "list 2 1e-5 -1e-5", "diameter", "-1e-5"},
           {populate + "rosinrammler 0 3 1e-5 1e-4 10 1", "x0", "0"},
           {populate + "rosinrammler 6e-5 -3 1e-5 1e-4 10 1", "exponent", "-3"},
           {populate + "rosinrammler 6e-5 3 1e-4 1e-5 10 1", "populate sizes", ""},
           {populate + "rosinrammler 6e-5 3 1e-5 1e-4 10 -1", "seed", "-1"}}) {
    EXPECT_TRUE(refuses(parsing(kNeeded + bad.line), bad.what, bad.given)) << bad.line;
  }
}

}  // namespace
}  // namespace powderlink
