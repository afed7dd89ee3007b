// SPDX-License-Identifier: GPL-3.0-or-later
// Diameters from ImageJ's own perimeters: disks of known size, and tables that only look like its.
#include <gtest/gtest.h>

#include "analysis/kat/experiment/grain_files.h"
#include "analysis/sizes/imagej_perimeter.h"
#include "analysis/sizes/particle_table.h"
#include "tests/analysis/kat/retention_sample.h"
#include "tests/analysis/sizes/imagej_table.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// What the program printed for disks: Perim./(pi d) of ImageJ 1.53t.
TEST(ImagejTables, TheTestsOwnOutlinesAreThoseOfImagej) {
  const double pi = std::acos(-1.0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place;
  for (const auto& [d, measured] : {std::pair(5.0, 0.969), std::pair(10.0, 1.007),
                                    std::pair(20.0, 1.026), std::pair(100.0, 1.049)}) {
    double sum = 0.0;
    constexpr int disks = 400;
    for (int i = 0; i < disks; ++i)
      sum += disk_on_pixels(d, place(random), place(random)).perimeter_px / (pi * d * disks);
    EXPECT_NEAR(sum, measured, 0.003) << d;  // printed digits, and the scatter of 400 disks
  }
  EXPECT_NEAR(disk_on_pixels(16.0, 8.0, 8.0).perimeter_px, 51.698, 1e-3);
  EXPECT_NEAR(disk_on_pixels(17.0, 8.5, 8.5).perimeter_px, 55.698, 1e-3);
  EXPECT_NEAR(traced({{0, 1}}).perimeter_px, 2.828, 1e-3);  // one pixel
}

double mean_perimeter_diameter(const ParticleSet& set) {
  double sum = 0.0;
  for (const Particle& p : set.particles) sum += p.perimeter_diameter_um();
  return sum / static_cast<double>(set.particles.size());
}

TEST(ImagejTables, PerimeterDiametersAreRight) {
  const TestFolder folder;
  for (const double d : {12.0, 15.0, 20.0, 40.0, 100.0}) {
    const auto file = folder.write("Results.csv", imagej_table(std::vector<double>(300, d), 7));
    const ParticleSet set = read_particle_tables({file}, 0.5);
    const double allowed = d < 15.0 ? 0.010 : 0.003;  // validity of the correction
    EXPECT_NEAR(mean_perimeter_diameter(set), 0.5 * d, allowed * 0.5 * d);
    ASSERT_EQ(set.perimeter_notes.size(), 1U);
    EXPECT_NE(set.perimeter_notes[0].find("ImageJ's"), std::string::npos);
  }
}

/// d_c of one drop: 46 um, 0.5 um per pixel, read by both diameters.
TEST(ImagejTables, BothDiametersGiveOneCriticalDiameter) {
  const TestFolder folder;
  const RetentionSample s = draw_sample({46.0, 0.02, 2000}, 11);
  const auto pixels = [](std::vector<double> d) {
    for (double& x : d) x /= 0.5;
    return d;
  };
  folder.write("b.csv", imagej_table(pixels(s.before_um), 1));
  folder.write("a.csv", imagej_table(pixels(s.after_um), 2));
  GrainFiles files{{(folder.path() / "b.csv").string()}, {(folder.path() / "a.csv").string()}, 0.5};
  const auto largest = [&](bool by_perimeter) {
    files.by_perimeter = by_perimeter;
    const GrainDiameters d = read_grains(files);
    EXPECT_EQ(d.notes.size(), by_perimeter ? 1U : 0U);
    return *std::max_element(d.after_um.begin(), d.after_um.end());
  };
  EXPECT_NEAR(largest(true) / largest(false), 1.0, 0.01);  // 0.955 with ImageJ's bias
}

/// In um and without the size of a pixel nothing can be corrected; the reader is told.
TEST(ImagejTables, WithoutThePixelTheBiasIsNamed) {
  const TestFolder folder;
  const auto file =
      folder.write("Results.csv", imagej_table(std::vector<double>(50, 40.0), 7, 0.65));
  const ParticleSet set = read_particle_tables({file}, 1.0);
  EXPECT_NEAR(set.particles[0].area_diameter_um(), 26.0, 0.2);
  ASSERT_EQ(set.perimeter_notes.size(), 1U);
  EXPECT_NE(set.perimeter_notes[0].find("5.5 %"), std::string::npos);
  // The same with the unit in the names, and the pixel given.
  std::string named = imagej_table(std::vector<double>(300, 40.0), 7, 0.65);
  named.replace(named.find("Area,Perim."), 11, "Area (um^2),Perim. (um)");
  const ParticleSet known = read_particle_tables({folder.write("named.csv", named)}, 0.65);
  EXPECT_EQ(known.perimeter_notes.size(), 1U);
  double mean = 0.0;
  for (const Particle& p : known.particles) mean += p.perimeter_diameter_um() / 300.0;
  EXPECT_NEAR(mean / 26.0, 1.0, 0.003);  // 0.965 with ImageJ's bias
  // Ours are right as they are.
  named.replace(named.find("Area (um^2),Perim. (um)"), 23, "area_um2,perimeter_um");
  EXPECT_TRUE(read_particle_tables({folder.write("own.csv", named)}, 0.65).perimeter_notes.empty());
}

/// Other programs' perimeters under ImageJ's names: exact ones of disks, whole ones of squares.
TEST(ImagejTables, OtherPerimetersStay) {
  const TestFolder folder;
  const double pi = std::acos(-1.0);
  std::string disks = " ,Area,Perim.\n";
  for (int i = 1; i <= 40; ++i)
    disks += fmt::format("{},{:.0f},{:.3f}\n", i, 0.25 * pi * 900 * i, pi * 30 * std::sqrt(i));
  const ParticleSet round = read_particle_tables({folder.write("disks.csv", disks)}, 0.5);
  EXPECT_NEAR(round.particles[3].perimeter_diameter_um(), 30.0, 0.01);
  EXPECT_TRUE(round.perimeter_notes.empty());
  const ParticleSet squares =
      read_particle_tables({folder.write("squares.csv", "Area,Perim.\n400,80\n100,40\n")}, 0.5);
  EXPECT_DOUBLE_EQ(squares.particles[0].perimeter_diameter_um(), 10.0);
  EXPECT_TRUE(squares.perimeter_notes.empty());
}

}  // namespace
}  // namespace powderlink::analysis
