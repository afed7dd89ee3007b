// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of grains: the numbers of disks and ellipses are known in closed form.
#include "analysis/sizes/particle_table.h"

#include <fmt/format.h>

#include "base/csv/csv_table.h"
#include "base/files/file_patterns.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

const double kPi = std::acos(-1.0);
constexpr double kDigits = 1e-5;  // the tables carry six digits

/// A row of a disk of this diameter in pixels, as ImageJ would write it with exact geometry.
std::string disk(double d) {
  return fmt::format("{:.6g},{:.6g},1,{:.6g},1,1,1", kPi * d * d / 4, kPi * d, d);
}
const char* const kHeader = " ,Area,Perim.,Circ.,Feret,AR,Round,Solidity\n";

TEST(ParticleTable, BothDiametersOfDisksAreTheDiameterTimesThePixelSize) {
  const TestFolder folder;
  const auto file = folder.write(
      "Results.csv", kHeader + ("1," + disk(30) + "\n2," + disk(47.5) + "\n3," + disk(120) + "\n"));
  const ParticleSet set = read_particle_tables({file}, 0.65);
  ASSERT_EQ(set.particles.size(), 3U);
  const double expected[] = {30 * 0.65, 47.5 * 0.65, 120 * 0.65};
  for (std::size_t i = 0; i < 3; ++i) {
    const Particle& p = set.particles[i];
    EXPECT_NEAR(p.area_diameter_um(), expected[i], kDigits * expected[i]);
    EXPECT_NEAR(p.perimeter_diameter_um(), expected[i], kDigits * expected[i]);
    EXPECT_NEAR(p.circularity(), 1.0, 2 * kDigits);
    EXPECT_NEAR(p.feret_um.value(), expected[i], kDigits * expected[i]);
    EXPECT_EQ(p.place, static_cast<int>(i) + 2);
  }
}

TEST(ParticleTable, TabsSemicolonsAndCommasAreTheSame) {
  const TestFolder folder;
  const std::string rows =
      " \tLabel\tArea\tPerim.\tCirc.\tRound\r\n1\tdrop.tif\t400\t80\t0.785\t0.5\r\n";
  const auto as = [&](char separator) {
    std::string text = rows;
    for (char& c : text) c = c == '\t' ? separator : c;
    const auto file = folder.write(fmt::format("{}.xls", static_cast<int>(separator)), text);
    return read_particle_tables({file}, 1.0).particles.at(0);
  };
  for (const char separator : {'\t', ';', ','}) {
    const Particle p = as(separator);
    EXPECT_DOUBLE_EQ(p.area_um2, 400);
    EXPECT_DOUBLE_EQ(p.perimeter_diameter_um(), 20);  // a square: 4 A/P is its side
    EXPECT_DOUBLE_EQ(p.aspect_ratio.value(), 2);      // from Round
  }
}

/// Labels of ImageJ are paths or titles: RFC 4180 knows doubled quotes and no backslash.
TEST(ParticleTable, LabelsMayBePathsAndHoldQuotes) {
  const TestFolder folder;
  for (const std::string label :
       {R"(C:\images\new\a.tif)", R"("C:\images\a,b.tif")", R"("field ""3"", left")", R"(5" tube)",
        R"( "a" )", R"("ends with \")"}) {
    const auto file = folder.write("t.csv", "Label,Area,Perim.\n" + label + ",400,80\n");
    EXPECT_DOUBLE_EQ(read_particle_tables({file}, 1.0).particles.at(0).area_um2, 400) << label;
    EXPECT_EQ(read_csv(file).rows[0].cells.size(), 3U);
  }
  const auto cell = [&](const std::string& text) {
    return read_csv(folder.write("t.csv", "a,b\n" + text + ",1\n")).rows[0].cells[0];
  };
  EXPECT_EQ(cell(R"(C:\new\"x")"), R"(C:\new\"x")");
  EXPECT_EQ(cell(R"("a ""b"", c\")"), R"(a "b", c\)");
  expect_refusal([&] { cell("\"open"); }, {"line 2", "close the quotes"});
  expect_refusal([&] { cell("\"a\"b"); }, {"line 2", "double the quotes"});
}

TEST(ParticleTable, PerimeterComesFromCircularityWhenItIsMissing) {
  const TestFolder folder;
  const ParticleSet set =
      read_particle_tables({folder.write("r.csv", "Area,Circ.\n400,0.785398163\n")}, 2.0);
  EXPECT_NEAR(set.particles.at(0).perimeter_um, 160, 1e-6);
  EXPECT_EQ(set.notes.size(), 1U);
}

TEST(ParticleTable, ScaleFromCommentColumnOrUnit) {
  const TestFolder folder;
  const auto diameter = [&](const std::string& text) {
    return read_particle_tables({folder.write("t.csv", text)}, std::nullopt)
        .particles.at(0)
        .perimeter_diameter_um();
  };
  EXPECT_DOUBLE_EQ(diameter("# pixel_size_um: 0.5\nArea,Perim.\n400,80\n"), 10);
  EXPECT_DOUBLE_EQ(diameter("# Pixel size = 0.5 um\nArea,Perim.\n400,80\n"), 10);
  EXPECT_DOUBLE_EQ(diameter("Area,Perim.,pixel_size_um\n400,80,0.5\n"), 10);
  EXPECT_DOUBLE_EQ(diameter("area_um2,perimeter_um\n400,80\n"), 20);
  EXPECT_DOUBLE_EQ(diameter("Area (µm²),Perim. (µm)\n400,80\n"), 20);
}

TEST(ParticleTable, PatternsAreExpandedAndEachFileIsReadOnce) {
  const TestFolder folder;
  for (const char* name : {"before_1.csv", "before_2.csv", "after_1.csv"})
    folder.write(name, "Area,Perim.\n400,80\n");
  const std::string base = folder.path().string();
  EXPECT_EQ(expand_patterns({base + "/before_*.csv"}).size(), 2U);
  EXPECT_EQ(expand_patterns({base + "/*_[1].csv", base + "/after_1.csv"}).size(), 2U);
  const ParticleSet set = read_particle_tables(expand_patterns({base + "/*.csv"}), 1.0);
  EXPECT_EQ(set.files.size(), 3U);
  EXPECT_EQ(set.particles.back().file, 2U);
  expect_refusal([&] { expand_patterns({base + "/none_*.csv"}); },
                 {"files of grains", "none_*.csv"});
}

/// ImageJ's Summarize writes its words into the nameless first column or, in newer versions, into Label.
TEST(ParticleTable, RowsOfSummarizeAreNoGrains) {
  const TestFolder folder;
  const auto read = [&](const std::string& text) {
    return read_particle_tables({folder.write("t.csv", text)}, 1.0);
  };
  for (const std::string& head :
       {std::string(" ,Label,Area,Perim.\n"), std::string(" ,Area,Perim.\n")}) {
    const bool label = head.find("Label") != std::string::npos;
    const auto row = [&](const char* number, const char* name, const char* rest) {
      return std::string(number) + (label ? std::string(",") + name : "") + rest;
    };
    for (const bool in_label : {false, label}) {
      std::string text =
          head + row("1", "mean.tif", ",400,80\n") + row("2", "mean.tif", ",100,40\n");
      for (const char* word : {"Mean", "SD", "Min", "Max"})
        text += in_label ? row("3", word, ",250,60\n") : row(word, "", ",-,60\n");
      const ParticleSet set = read(text);
      ASSERT_EQ(set.particles.size(), 2U) << text;
      EXPECT_DOUBLE_EQ(set.particles[1].area_um2, 100);
      ASSERT_EQ(set.notes.size(), 1U);
      EXPECT_NE(set.notes[0].find("4 rows"), std::string::npos) << set.notes[0];
    }
  }
  expect_refusal([&] { read("Label,Area,Perim.\nMean,400,80\n"); }, {"no grains"});
}

TEST(ParticleTable, RefusesWhatItCannotUse) {
  const TestFolder folder;
  const auto read = [&](const std::string& text, std::optional<double> size = 1.0) {
    return [&folder, text, size] { read_particle_tables({folder.write("t.csv", text)}, size); };
  };
  expect_refusal(read("Area,Feret\n400,80\n"), {"t.csv, header", "Area, Feret", "'Perim.'"});
  expect_refusal(read("1,400,80\n2,300,70\n"), {"header"});
  expect_refusal(read("Area,Perim.\n"), {"a header without rows"});
  expect_refusal(read("Area,Perim.\n400,x\n"), {"line 2, column 'Perim.'", "'x'"});
  expect_refusal(read("Area,Perim.\n-4,80\n"), {"line 2, column 'Area'", "above 0"});
  expect_refusal(read("Area;Perim.\n4,5;80\n"), {"column 'Area'", "decimal point"});
  expect_refusal(read("Area;Perim.\n4.5,1;80\n"), {"column 'Area'", "'4.5,1'"});
  expect_refusal(read("Area,Perim.\n400,80\n", 0.0), {"--pixel-size-um", "given: 0"});
  expect_refusal(read("Area,Perim.\n400,80\n", -0.5), {"--pixel-size-um", "-0.5"});
  expect_refusal(read("Area,Perim.\n400,80\n", std::nullopt),
                 {"without a scale", "--pixel-size-um"});
  expect_refusal(read("area_um2,Perim.\n400,80\n"), {"different units"});
  expect_refusal(read("Area (inch^2),Perim.\n400,80\n"), {"the unit 'inch^2'"});
  expect_refusal([&] { read_particle_tables({folder.path() / "absent.csv"}, 1.0); },
                 {"absent.csv"});
}

TEST(ParticleTable, RefusesMixedPixelSizes) {
  const TestFolder folder;
  const auto fine = folder.write("fine.csv", "# pixel_size_um: 0.5\nArea,Perim.\n400,80\n");
  const auto coarse = folder.write("coarse.csv", "# pixel_size_um: 1\nArea,Perim.\n400,80\n");
  expect_refusal(
      [&] {
        read_particle_tables({fine, coarse}, std::nullopt);
      },
      {"coarse.csv, pixel size", "1 um", "0.5 um"});
  expect_refusal([&] { read_particle_tables({fine}, 1.0); }, {"fine.csv, pixel size", "0.5 um"});
  const auto rows = folder.write("rows.csv", "Area,Perim.,pixel_size_um\n400,80,0.5\n400,80,0.6\n");
  expect_refusal([&] { read_particle_tables({rows}, std::nullopt); }, {"line 3", "0.6 um"});
}

TEST(ParticleTable, DoubtsAreNoted) {
  const TestFolder folder;
  const auto notes = [&](const std::string& text) {
    return read_particle_tables({folder.write("t.csv", text)}, 0.5).notes;
  };
  EXPECT_TRUE(notes("Area,Perim.,Circ.\n400,80,0.785\n").empty());
  ASSERT_EQ(notes("Area,Perim.\n400.5,80\n").size(), 1U);
  ASSERT_EQ(notes("Area,Perim.,Circ.\n400,80,0.9\n").size(), 1U);
  expect_refusal([&] { notes("Area,Perim.,Circ.\n400,40,0.785\n"); }, {"line 2, column 'Perim.'"});
}

}  // namespace
}  // namespace powderlink::analysis
