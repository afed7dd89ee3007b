// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/kat_output.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/csv/csv_table.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

std::vector<KatPoint> two_points() {
  KatPoint a;
  a.row = {1.4, 46.0, 1.5};
  a.adhesive_energy_J_m2 = 17.175;
  a.theory = {46.0e-6, "instant stop"};
  a.reduced.diameter_m = 45.99e-6;
  a.dem.critical_diameter_m = 46.01e-6;
  a.dem.largest_attached_m = 46.0e-6;
  a.dem.smallest_detached_m = 46.02e-6;
  a.dem.attached = 40;
  a.dem.detached = 24;
  a.dem.wall_s = 1.5;
  a.dem.particles = {{40e-6, true, 0.0, 1e-9}, {50e-6, false, 0.5, -1e-9}};
  KatPoint b = a;
  b.row = {2.0};
  b.reduced.state = CriticalDiameter::State::nothing_detaches;
  return {a, b};
}

TEST(KatOutput, JsonContract) {
  const auto j = nlohmann::json::parse(kat_json(two_points()));
  ASSERT_EQ(j.at("points").size(), 2U);
  const auto& p = j["points"][0];
  EXPECT_EQ(p.at("impact_velocity_m_s"), 1.4);
  EXPECT_NEAR(p.at("critical_diameter_um").get<double>(), 46.01, 1e-9);
  EXPECT_NEAR(p.at("theory_um").get<double>(), 46.0, 1e-9);
  EXPECT_EQ(p.at("attached"), 40);
  EXPECT_EQ(p.at("detached"), 24);
  EXPECT_EQ(p.at("wall_s"), 1.5);
  EXPECT_EQ(p.at("measured_um"), 46.0);
  EXPECT_TRUE(j["points"][1].at("measured_um").is_null());
  EXPECT_TRUE(j["points"][1].at("reduced_um").is_null());
}

TEST(KatOutput, FilesForFiguresAreTables) {
  const TestFolder folder;
  const CsvTable kat = read_csv(folder.write("kat.csv", kat_csv("test", two_points())));
  ASSERT_EQ(kat.rows.size(), 2U);
  EXPECT_DOUBLE_EQ(kat.number(kat.rows[0], *kat.find_column("critical_diameter_um")), 46.01);
  EXPECT_TRUE(kat.rows[1].cells[*kat.find_column("measured_um")].empty());
  const CsvTable particles =
      read_csv(folder.write("particles.csv", particles_csv("test", two_points())));
  ASSERT_EQ(particles.rows.size(), 4U);
  EXPECT_EQ(particles.rows[1].cells[*particles.find_column("attached")], "0");
  EXPECT_DOUBLE_EQ(particles.number(particles.rows[1], *particles.find_column("speed_m_s")), 0.5);
}

TEST(KatOutput, TableShowsDifferences) {
  const std::string t = kat_table(two_points());
  for (const char* fragment : {"46.01", "+0.02 %", "instant stop", "nothing detaches"}) {
    EXPECT_NE(t.find(fragment), std::string::npos) << t;
  }
}

}  // namespace
}  // namespace powderlink::analysis
