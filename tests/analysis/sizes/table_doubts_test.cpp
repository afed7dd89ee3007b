// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of grains that cannot be, and those that are doubtful.
#include "analysis/sizes/table_doubts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/kat/experiment/grain_files.h"
#include "analysis/sizes/particle_table.h"
#include "tests/analysis/sizes/imagej_table.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

const double kPi = std::acos(-1.0);
const std::vector<double> kDiameters_px = {31.2, 38.5, 42.0, 43.7, 47.1, 52.6, 36.4, 41.1};

/// Table of disks on pixels with a cell for each.
template <class Line>
std::string table(const std::string& header, const Line& line) {
  std::string text = header + "\n";
  for (const double d : kDiameters_px) text += line(disk_on_pixels(d, 0.3, 0.6)) + "\n";
  return text;
}

ParticleSet read(const std::string& text, std::optional<double> pixel_um = 1.0) {
  const TestFolder folder;
  return read_particle_tables({folder.write("t.csv", text)}, pixel_um);
}

void refused(const std::string& text, const std::vector<std::string>& fragments,
             std::optional<double> pixel_um = 1.0) {
  expect_refusal([&] { read(text, pixel_um); }, fragments);
}

bool any_note(const ParticleSet& set, const std::string& part) {
  return std::any_of(set.notes.begin(), set.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(TableDoubts, OtherDefinitionsOfCircularityAreRefused) {
  const auto with = [](const auto& circ) {
    return table("Area,Circ.", [&](const PixelShape& s) {
      return fmt::format("{:.0f},{:.3f}", s.area_px, circ(s.circularity()));
    });
  };
  EXPECT_TRUE(any_note(read(with([](double c) { return c; })), "no Perim."));
  refused(with([](double c) { return 4.0 * kPi / c; }),
          {"line 2, column 'Circ.'", "P^2/A", "8 of 8"});
  refused(with([](double c) { return 1.0 / c; }), {"column 'Circ.'", "inverse"});
  refused(with([](double c) { return 100.0 * c; }), {"column 'Circ.'", "per cent"});
}

TEST(TableDoubts, AreasAndPerimetersInDifferentUnitsAreRefused) {
  const auto with = [](double area, double edge) {
    return table("Area,Perim.", [&](const PixelShape& s) {
      return fmt::format("{:.6g},{:.6g}", area * s.area_px, edge * s.perimeter_px);
    });
  };
  refused(with(1.0, 0.5), {"line 2, column 'Perim.'", "no edge is shorter", "same unit"}, 0.5);
  refused(with(1e-3, 1.0), {"column 'Area'", "line 2"});
  refused(with(1e-6, 1.0), {"column 'Area'", "line 2"});
  // A single damaged row is named, and the others are used.
  const ParticleSet set = read("Area,Perim.\n1385,132.5\n1420,134.1\n1450,13.52\n1399,133.2\n");
  EXPECT_TRUE(any_note(set, "line 4, column 'Perim.'"));
  EXPECT_EQ(set.particles.size(), 4U);
}

/// Whole numbers of pixels from a spreadsheet that writes 1399 as 1.399 and leaves 872 alone.
TEST(TableDoubts, ThousandsThatWereGroupedAreRefused) {
  const auto grouped = [](double area) {
    const auto n = static_cast<long>(area);
    return n < 1000 ? fmt::format("{}", n) : fmt::format("{}.{:03}", n / 1000, n % 1000);
  };
  const std::string text = table("Area,Perim.,Circ.", [&](const PixelShape& s) {
    return fmt::format("{},{:.3f},{:.3f}", grouped(s.area_px), s.perimeter_px, s.circularity());
  });
  refused(text, {"line 3, column 'Area'", "thousands", "plain numbers"});
  // One row of many is enough where whole numbers stand beside it.
  refused("Area,Perim.\n872,110.2\n905,112.4\n1.012,118.5\n640,94.6\n", {"line 4, column 'Area'"});
  // Without perimeters only the form tells.
  refused("Area,Circ.\n872,0.91\n1.399,0.92\n905,0.9\n1.012,0.9\n640,0.93\n2.115,0.92\n",
          {"line 3, column 'Area'", "thousands"});
  // The same from a country of decimal commas says it all, and is read.
  const std::string sure = table("Area;Perim.;Circ.", [&](const PixelShape& s) {
    std::string row = fmt::format("{:.3f};{:.3f}", s.perimeter_px, s.circularity());
    for (char& c : row) c = c == '.' ? ',' : c;
    return grouped(s.area_px) + ";" + row;
  });
  EXPECT_NEAR(read(sure).particles[2].area_diameter_um(), 42.0, 0.2);
}

/// Whole areas beside others with three decimals, of an image with a scale, are right as they stand.
TEST(TableDoubts, SmallAreasBesideWholeOnesAreRead) {
  const ParticleSet set = read("Area,Perim.\n78.250,31.971\n120,39.8\n79,32.114\n");
  EXPECT_EQ(set.particles[0].area_um2, 78.25);
  EXPECT_TRUE(set.notes.empty());
}

TEST(TableDoubts, DigitsBoundWhatIsKnown) {
  const std::vector<double> powder(60, 92.0);  // 46 um, 0.5 um per pixel
  const std::string cure = "Analyze > Set Measurements";
  refused(imagej_table(powder, 1, 0.5e-3), {"column 'Area'", "0.001", cure, "um"}, 1000.0);
  refused(imagej_table(powder, 1, 0.5e-3), {"column 'Area'", "0.001", cure, "um"}, std::nullopt);
  refused(imagej_table(powder, 1, 0.5e-3), {"column 'Area'", "0.001", cure, "um"}, 0.5);
  refused("Area,Perim.\n0.000,0.047\n0.001,0.082\n", {"line 2, column 'Area'", cure}, 1000.0);
  // Smaller grains have powers of ten beside them, and are known well: 5.320E-4 and 0.002.
  std::vector<double> mixed(30, 50.0);
  mixed.insert(mixed.end(), powder.begin(), powder.end());
  refused(imagej_table(mixed, 1, 0.5e-3), {"column 'Area'", "0.002", cure}, 1000.0);
  EXPECT_FALSE(
      any_note(read(imagej_table(std::vector<double>(20, 50.0), 1, 0.5e-3), 1000.0), cure));
  // Four decimals are felt, six are not.
  const ParticleSet four = read(imagej_table(powder, 1, 0.5e-3, 4), 1000.0);
  EXPECT_TRUE(any_note(four, cure));
  EXPECT_NEAR(four.area_step_um2, 100.0, 1e-9);
  EXPECT_FALSE(any_note(four, "--pixel-size-um 1"));
  const ParticleSet six = read(imagej_table(powder, 1, 0.5e-3, 6), 1000.0);
  EXPECT_FALSE(any_note(six, cure));
  EXPECT_NEAR(six.particles[0].area_diameter_um(), 46.0, 0.2);
  // mm in the names need no scale; pixels are counted, and exact.
  std::string named = imagej_table(powder, 1, 0.5e-3, 6);
  named.replace(named.find("Area,Perim."), 11, "Area (mm^2),Perim. (mm)");
  EXPECT_NEAR(read(named, std::nullopt).particles[0].area_diameter_um(), 46.0, 0.2);
  EXPECT_EQ(read(imagej_table(powder, 1), 0.5).area_step_um2, 0.0);
}

/// Outlines of noise: combs of one pixel between grains of 18 pixels.
/// ImageJ's names have no unit: a table in mm says nothing, and its grains are smaller than a pixel.
TEST(TableDoubts, TablesInMillimetresAreAskedFor) {
  const std::vector<double> powder(20, 92.0);  // 46 um, 0.5 um per pixel
  const std::string text = imagej_table(powder, 1, 0.5e-3, 6), cure = "--pixel-size-um 1000";
  refused(text, {"pixel size", "less than a pixel", cure, "46"}, std::nullopt);
  refused(text, {"pixel size", "0.5 um", cure, "46"}, 0.5);
  EXPECT_TRUE(any_note(read(text, 1.0), cure));
  EXPECT_FALSE(any_note(read(text, 1000.0), cure));
  EXPECT_NEAR(read(text, 1000.0).particles[0].area_diameter_um(), 46.0, 0.2);
  // Powders below 1 um under an electron microscope, in um.
  EXPECT_FALSE(any_note(read(imagej_table(powder, 1, 0.005, 4), 1.0), cure));
}

TEST(TableDoubts, SumsBelowTheGrainsAreNone) {
  const std::string grains = " ,Area,Perim.\n1,1385,132.5\n2,1420,134.1\n3,1450,135.2\n";
  const ParticleSet set = read(grains + "Sum,4255,401.8\n,1418.3,133.9\n");
  EXPECT_EQ(set.particles.size(), 3U);
  EXPECT_TRUE(any_note(set, "line 5: 'Sum'"));
  // Names in all rows, and names with numbers, are those of grains.
  EXPECT_EQ(read(grains + "extra 4,1418,133.9\n").particles.size(), 4U);
  EXPECT_EQ(read(" ,Area,Perim.\n1,1385,132.5\na,1420,134.1\n3,1450,135.2\n").particles.size(), 3U);
  EXPECT_EQ(read(" ,Area,Perim.\na,1385,132.5\nb,1420,134.1\n").particles.size(), 2U);
}

TEST(TableDoubts, SpecksAreNoted) {
  const auto comb = [](int teeth) {
    std::vector<std::array<long, 2>> columns;
    for (int i = 0; i < teeth; ++i) columns.push_back({0, i % 2 == 0 ? 1 : 8});
    return traced(columns);
  };
  const auto with = [&](int specks) {
    std::string text = imagej_table(std::vector<double>(300, 18.0), 4);
    const PixelShape s = comb(9);
    for (int i = 0; i < specks; ++i)
      text += fmt::format("{},{:.0f},{:.3f},{:.3f},1,1,0.5\n", 300 + i, s.area_px, s.perimeter_px,
                          s.circularity());
    return text;
  };
  EXPECT_LT(comb(9).circularity(), 0.2);
  EXPECT_FALSE(any_note(read(with(0)), "noise"));
  EXPECT_TRUE(any_note(read(with(900)), "noise"));
  EXPECT_TRUE(any_note(read(with(900)), "Otsu"));
  // Salt: single pixels are round, and no grains either.
  std::string salt = imagej_table(std::vector<double>(300, 18.0), 4);
  for (int i = 0; i < 900; ++i) salt += fmt::format("{},1,2.828,1,1,1,1\n", 300 + i);
  EXPECT_TRUE(any_note(read(salt), "pixels"));
  const TestFolder folder;
  const GrainDiameters d = read_grains({{folder.write("b.csv", with(0)).string()},
                                        {folder.write("a.csv", with(400)).string()},
                                        1.0});
  EXPECT_TRUE(std::any_of(d.notes.begin(), d.notes.end(), [](const std::string& note) {
    return note.find("grains after the drop have a median circularity") != std::string::npos;
  }));
}

TEST(TableDoubts, OtherTablesOfImagejAreNamed) {
  refused("Slice,Count,Total Area,Average Size,%Area,Mean\na.tif,96,53201,554.2,5.5,255\n",
          {"ImageJ's table Summary", "Results", "Display results"});
  refused(
      "Slice\tCount\tTotal Area\tAverage "
      "Size\t%Area\tPerim.\tCirc.\na.tif\t96\t53201\t554.2\t5.5\t80.1\t0.9\n",
      {"ImageJ's table Summary"});
  refused("1\t400\t80.1\t0.785\n2\t300\t70.2\t0.765\n", {"header", "Save column headers"});
  refused("1,a.tif,400,80.1\n2,a.tif,300,70.2\n", {"header", "Save column headers"});
}

}  // namespace
}  // namespace powderlink::analysis
