// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of users on the command line: the same answer in every form, questions, clean refusals.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <utf8.h>

#include <nlohmann/json.hpp>

#include "tests/analysis/kat/retention_sample.h"
#include "tests/analysis/program/command_line.h"
#include "tests/analysis/sizes/imagej_table.h"

namespace powderlink::analysis {
namespace {

struct Drop {
  double velocity_m_s, diameter_um;
};
const std::vector<Drop> kDrops = {{1.8, 66.4}, {2.3, 63.8}, {3.0, 59.8}, {4.1, 53.0}, {4.8, 47.5}};

std::string study(const std::string& energy) {
  return "[study]\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"drops.csv\"\n"
         "[particle] # 20 \xB0"
         "C\nmaterial = \"borosilicate_glass\"\n[substrate]\n"
         "material = \"borosilicate_glass\"\n[fit]\nadhesive_energy_J_m2 = " +
         energy + "\n";
}

nlohmann::json compared(const std::string& table, const std::string& energy, CommandResult& r) {
  const TestFolder folder;
  folder.write("drops.csv", table);
  const std::string base = folder.path().string();
  folder.write("s.toml", study(energy));
  r = powderlink("compare " + base + "/s.toml --json " + base + "/c.json");
  return r.status == 0 ? nlohmann::json::parse(read_file(base + "/c.json")) : nlohmann::json();
}

std::string plain(double factor) {
  std::string text = "impact_velocity_m_s,critical_diameter_um\n";
  for (const Drop& d : kDrops)
    text += fmt::format("{},{:.6g}\n", d.velocity_m_s, d.diameter_um * factor);
  return text;
}

TEST(TableCommands, OneAnswerInEveryForm) {
  CommandResult r;
  const std::string bounds = "[0.001, 1000.0]";
  const auto expected = compared(plain(1.0), bounds, r);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.err, "");
  std::string german = "sep=;\rImpact velocity [m/s];Critical diameter [\xB5m];note\r";
  for (const Drop& d : kDrops)
    german += fmt::format("{:.2f};{:.2f};by hand # checked\r", d.velocity_m_s, d.diameter_um);
  std::replace(german.begin(), german.end(), '.', ',');
  EXPECT_EQ(compared(german, bounds, r).at("points"), expected.at("points")) << r.err;
}

/// Grains of 66 um given in mm: with a Gamma that cannot follow, the model is off by the factor too.
TEST(TableCommands, MillimetresAreAskedFor) {
  CommandResult r;
  compared(plain(1e-3), "[0.001, 1000.0]", r);
  EXPECT_NE(r.err.find("were mm given where um are meant?"), std::string::npos) << r.err;
  const auto j = compared(plain(1e-3), "[10.0, 1000.0]", r);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_NE(r.out.find("were millimetres given where micrometres are meant?"), std::string::npos)
      << r.out;
  EXPECT_NE(j.dump().find("millimetres"), std::string::npos);
  compared(plain(1.0), "[10.0, 1000.0]", r);
  EXPECT_EQ(r.out.find("are meant?"), std::string::npos) << r.out;
}

/// Refused once, in four parts, with no byte that a terminal cannot show.
TEST(TableCommands, RefusalsAreValidText) {
  const TestFolder folder;
  const auto refused = [&](const std::string& name, const std::string& text,
                           const std::string& fragment) {
    folder.write(name, text);
    const CommandResult r =
        powderlink("psd '" + (folder.path() / name).string() + "' --pixel-size-um 1 --out " +
                   (folder.path() / "out").string());
    expect_four_parts(r, fragment);
    EXPECT_TRUE(utf8::is_valid(r.err.begin(), r.err.end())) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(r.err.find('\x1B'), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
  };
  refused("t.csv", "Area (\xE6m\xFD),Perim. (\xE6m)\n400,80\n", "Windows-1252");  // of MS-DOS
  refused("t.csv", "Area,Perim.\n400,\x1B[31m80\n", "column 'Perim.'");
  refused("t.csv", "Area,Perim.\n\xB5\xC2,80\n", "column 'Area'");
  refused("t\xB5.csv", "Area,Perim.\n400,x\n", "'x'");
  refused("t.csv", "PK\x03\x04", "workbook");
  refused("t.csv", "Area,Circ.\n1385,12.9\n1401,13.2\n1388,12.8\n", "P^2/A");
}

/// A dusty table, to which no law can be fitted: the words are the program's own.
TEST(TableCommands, LibrariesKeepTheirLogs) {
  const TestFolder folder;
  std::string text = imagej_table(std::vector<double>(300, 36.0), 3);
  for (int i = 0; i < 3000; ++i) text += "300,1,2.828,1.000,1,1,1\n";
  folder.write("t.csv", text);
  const CommandResult r =
      powderlink("psd " + (folder.path() / "t.csv").string() +
                 " --pixel-size-um 0.5 --no-figures --out " + (folder.path() / "out").string());
  EXPECT_EQ(r.status, 0);
  for (const char* log : {"InitGoogleLogging", ".cc:", "ceres"})
    EXPECT_EQ(r.err.find(log), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("noise rather than grains?"), std::string::npos) << r.err;
}

/// d_c of grains of 0.5 um per pixel that ImageJ measured, true 46 um, by both diameters.
TEST(TableCommands, PerimetersOfImagejGiveTheCriticalDiameter) {
  const TestFolder folder;
  const RetentionSample s = draw_sample({46.0, 0.02, 1500}, 11);
  const auto write = [&](const char* name, std::vector<double> d, unsigned seed) {
    for (double& x : d) x /= 0.5;
    folder.write(name, imagej_table(d, seed));
  };
  write("b.csv", s.before_um, 1);
  write("a.csv", s.after_um, 2);
  const std::string base = folder.path().string();
  for (const char* diameter : {"area", "perimeter"}) {
    const CommandResult r = powderlink(fmt::format(
        "kat analyse --before {0}/b.csv --after {0}/a.csv --pixel-size-um 0.5 --velocity 1.4 "
        "--particle 316L --substrate UPVC --bootstrap 50 --json {0}/k.json --diameter {1}",
        base, diameter));
    ASSERT_EQ(r.status, 0) << r.err;
    const auto d = nlohmann::json::parse(read_file(base + "/k.json")).at("critical_diameter_um");
    EXPECT_NEAR(d.at("value").get<double>(), 46.0, 0.6) << diameter;  // 44.2 with ImageJ's bias
    EXPECT_EQ(r.err.find("ImageJ's") != std::string::npos, diameter[0] == 'p') << r.err;
  }
}

/// A table of a study that a German spreadsheet saved gets its next drop in a form that is read.
TEST(TableCommands, ARowIsAddedToATableOfASpreadsheet) {
  const TestFolder folder;
  const RetentionSample s = draw_sample({46.0, 0.02, 600}, 5);
  const std::string base = folder.path().string();
  for (const auto& [name, d] :
       {std::pair("b.csv", &s.before_um), std::pair("a.csv", &s.after_um)}) {
    std::string text = "area_um2,perimeter_um\n";
    for (const double x : *d) text += fmt::format("{:.6g},{:.6g}\n", 0.25 * M_PI * x * x, M_PI * x);
    folder.write(name, text);
  }
  const auto add = [&](double velocity) {
    return powderlink(fmt::format(
        "kat analyse --before {0}/b.csv --after {0}/a.csv --velocity {1} --particle 316L "
        "--substrate UPVC --bootstrap 50 --study {0}/s.toml",
        base, velocity));
  };
  ASSERT_EQ(add(1.4).status, 0);
  std::string table = read_file(base + "/s.csv");
  std::replace(table.begin(), table.end(), ',', ';');
  std::replace(table.begin(), table.end(), '.', ',');
  folder.write("s.csv", "sep=;\n" + table);
  EXPECT_EQ(add(1.4).status, 1);  // in it already
  ASSERT_EQ(add(2.0).status, 0);
  const CommandResult r = powderlink("compare " + base + "/s.toml");
  EXPECT_EQ(r.status, 0) << r.err << read_file(base + "/s.csv");
  EXPECT_NE(r.out.find("\n1.4"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("\n2 "), std::string::npos) << r.out;
}

/// Four decimals of mm^2 leave 1.5 % open, which the interval of D50 holds; whole pixels leave nothing.
TEST(TableCommands, IntervalsKnowThePrintedDigits) {
  const TestFolder folder;
  const std::string base = folder.path().string();
  const auto width = [&](double unit, int decimals, const char* scale) {
    folder.write("t.csv", imagej_table(std::vector<double>(200, 92.0), 3, unit, decimals));
    const CommandResult r = powderlink(fmt::format(
        "psd {0}/t.csv --pixel-size-um {1} --json {0}/p.json --out {0}/out --no-figures", base,
        scale));
    EXPECT_EQ(r.status, 0) << r.err;
    const auto d = nlohmann::json::parse(read_file(base + "/p.json"));
    const auto d50 = d.at("intervals").at("d50_um");
    return d50.at(1).get<double>() - d50.at(0).get<double>();
  };
  EXPECT_GT(width(0.5e-3, 4, "1000"), 2 * 0.013 * 46.0);
  EXPECT_LT(width(1.0, 3, "0.5"), 0.05);
}

}  // namespace
}  // namespace powderlink::analysis
