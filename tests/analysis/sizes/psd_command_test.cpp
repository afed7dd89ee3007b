// SPDX-License-Identifier: GPL-3.0-or-later
// `powderlink psd` as users call it, and what it refuses.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "analysis/sizes/rosin_rammler.h"
#include "base/csv/csv_table.h"
#include "tests/analysis/program/command_line.h"
#include "tests/analysis/sizes/drawn_spheres.h"

namespace powderlink::analysis {
namespace {

constexpr double kRecovered = 0.02;

/// Disks at the middles of equal shares of a law, in pixels of 0.5 um.
std::string table(const RosinRammler& law, int grains) {
  std::string text = " ,Area,Perim.,Circ.\n";
  for (int i = 0; i < grains; ++i) {
    const double d = law.quantile_um((i + 0.5) / grains) / 0.5;
    text += fmt::format("{},{:.8g},{:.8g},1\n", i + 1, M_PI * d * d / 4, M_PI * d);
  }
  return text;
}

TEST(PsdCommand, TableOf2000GrainsGivesTheLawThatMadeIt) {
  const TestFolder folder;
  const RosinRammler law{60, 3};
  folder.write("Results.csv", table(law, 2000));
  const std::string base = folder.path().string();
  const auto result = powderlink(
      fmt::format("psd '{0}/Res*.csv' --pixel-size-um 0.5 --json {0}/f.json --out {0}/out", base));
  ASSERT_EQ(result.status, 0) << result.err;
  const auto j = nlohmann::json::parse(read_file(folder.path() / "f.json"));
  EXPECT_EQ(j["count"], 2000);
  EXPECT_NEAR(j["d10_um"].get<double>() / law.quantile_um(0.1), 1, 1e-3);
  EXPECT_NEAR(j["d50_um"].get<double>() / law.quantile_um(0.5), 1, 1e-3);
  EXPECT_NEAR(j["d90_um"].get<double>() / law.quantile_um(0.9), 1, 1e-3);
  EXPECT_GT(j["d50_mass_um"].get<double>(), j["d50_um"].get<double>());
  EXPECT_NEAR(j["rosin_rammler"]["x0_um"].get<double>() / 60, 1, kRecovered);
  EXPECT_NEAR(j["rosin_rammler"]["n"].get<double>() / 3, 1, kRecovered);
  EXPECT_GT(j["rosin_rammler"]["r_squared"].get<double>(), 0.999);
  EXPECT_LT(j["intervals"]["d50_um"][0].get<double>(), j["d50_um"].get<double>());
  for (const char* name : {"particles.csv", "in.powder", "sizeDistribution"})
    EXPECT_FALSE(read_file(folder.path() / "out" / name).empty()) << name;
  // Its own table gives the same, without being told the scale.
  const auto again = powderlink(
      fmt::format("psd {0}/out/particles.csv --json {0}/g.json --out {0}/two --no-figures", base));
  ASSERT_EQ(again.status, 0) << again.err;
  const auto k = nlohmann::json::parse(read_file(folder.path() / "g.json"));
  EXPECT_NEAR(k["d50_um"].get<double>() / j["d50_um"].get<double>(), 1, 1e-6);
}

TEST(PsdCommand, PictureWithScaleBarColourOr16Bit) {
  const TestFolder folder;
  Scene scene;
  scene.width = 800;
  scene.height = 600;
  const Drawn drawn = draw(scene);
  cv::Mat bytes, words, colour;
  drawn.grey.convertTo(bytes, CV_8U, 255);
  drawn.grey.convertTo(words, CV_16U, 65535);
  cv::cvtColor(bytes, colour, cv::COLOR_GRAY2BGR);
  std::vector<double> medians;
  for (const auto& picture : {bytes, words, colour}) {
    const std::string base = folder.path().string();
    cv::imwrite(base + "/p.png", picture);
    const auto result =
        powderlink(fmt::format("psd {0}/p.png --scale-bar-um 50 --scale-bar-px 100 --json "
                               "{0}/f.json --out {0}/out --no-figures",
                               base));
    ASSERT_EQ(result.status, 0) << result.err;
    const auto j = nlohmann::json::parse(read_file(folder.path() / "f.json"));
    EXPECT_EQ(j["pixel_size_um"], 0.5);
    medians.push_back(j["d50_um"]);
    EXPECT_FALSE(cv::imread(base + "/out/overlay_1_p.png").empty());
  }
  constexpr double kEightBits = 1e-3;  // grey in steps of 1/255
  EXPECT_NEAR(medians[1] / medians[0], 1, kEightBits);
  EXPECT_NEAR(medians[2] / medians[0], 1, kEightBits);
}

TEST(PsdCommand, ReadsItsOwnTableWhateverTheFilesAreCalled) {
  const TestFolder folder;
  const std::string odd = "a,\\\"b\".csv";
  folder.write(odd, table({60, 3}, 50));
  const std::string base = folder.path().string();
  ASSERT_EQ(powderlink("psd '" + base + "/" + odd + "' --pixel-size-um 0.5 --no-figures --out " +
                       base + "/out")
                .status,
            0);
  EXPECT_EQ(read_csv(base + "/out/particles.csv").rows.at(0).cells.at(0), base + "/" + odd);
}

TEST(PsdCommand, SpecksAreFlaggedAndDropped) {
  const TestFolder folder;
  std::string text = table({60, 4}, 500);
  for (int i = 0; i < 300; ++i) text += "0,4,7,1\n";
  folder.write("t.csv", text);
  const std::string base = folder.path().string();
  for (const bool drop : {false, true}) {
    const auto result = powderlink(fmt::format(
        "psd {0}/t.csv --pixel-size-um 0.5 --json {0}/f.json --out {0}/out --no-figures{1}", base,
        drop ? " --drop-specks" : ""));
    ASSERT_EQ(result.status, 0) << result.err;
    const auto j = nlohmann::json::parse(read_file(folder.path() / "f.json"));
    EXPECT_NEAR(j["specks"].get<double>(), 300, 5);  // 1 % of the 500 may count as such
    EXPECT_EQ(j["count"].get<int>(), drop ? 800 - j["specks"].get<int>() : 800);
  }
}

TEST(PsdCommand, TwoPopulationsAreNoSpecksAndHaveNoLaw) {
  const TestFolder folder;
  std::string text = "area_um2,perimeter_um\n";
  for (int i = 0; i < 1000; ++i) {
    const double d = (i < 700 ? 20 : 60) * (1 + 1e-4 * i);
    text += fmt::format("{:.9g},{:.9g}\n", M_PI * d * d / 4, M_PI * d);
  }
  folder.write("t.csv", text);
  const std::string base = folder.path().string();
  const auto result =
      powderlink(fmt::format("psd {0}/t.csv --json {0}/f.json --out {0}/out", base));
  ASSERT_EQ(result.status, 0) << result.err;
  const auto j = nlohmann::json::parse(read_file(folder.path() / "f.json"));
  EXPECT_EQ(j["specks"], 0);
  for (const char* law : {"rosin_rammler", "rosin_rammler_mass", "rosin_rammler_cut"})
    EXPECT_TRUE(j.at(law).is_null()) << law;
  EXPECT_NE(result.out.find("does not fit; the share finer than"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find("no Rosin-Rammler law fits"), std::string::npos) << result.err;
  for (const char* name : {"in.powder", "sizeDistribution", "distribution.svg"})
    EXPECT_FALSE(read_file(folder.path() / "out" / name).empty()) << name;
}

TEST(PsdCommand, BadInputIsRefusedAndNothingIsWritten) {
  const TestFolder folder;
  const std::string base = folder.path().string();
  folder.write("t.csv", table({60, 3}, 50));
  folder.write("columns.csv", "Area,Mean\n1,2\n3,4\n");
  folder.write("text.png", "no picture");
  folder.write("one.csv", "Area,Perim.\n400,80\n");
  folder.write("f.json", "old");
  cv::imwrite(base + "/plain.png", cv::Mat(100, 100, CV_8U, cv::Scalar(7)));
  cv::Mat blob(200, 200, CV_8U, cv::Scalar(20));
  cv::circle(blob, {100, 100}, 50, cv::Scalar(220), -1);
  cv::imwrite(base + "/blob.png", blob);
  const std::pair<const char*, const char*> wrong[] = {
      {"columns.csv --pixel-size-um 1", "'Area' and 'Perim.'"},
      {"text.png --pixel-size-um 1", "reading a micrograph"},
      {"plain.png --pixel-size-um 1", "one brightness"},
      {"blob.png --pixel-size-um 1", "1 grain"},
      {"one.csv --pixel-size-um 1", "1 grain"},
      {"t.csv --pixel-size-um 0", "--pixel-size-um"},
      {"t.csv --pixel-size-um -2", "--pixel-size-um"},
      {"t.csv", "without a scale"},
      {"plain.png", "without a scale"},
      {"none*.csv --pixel-size-um 1", "none*.csv"},
      {"t.csv --scale-bar-um 50", "scale bar"},
      {"t.csv --pixel-size-um 1 --min-diameter-um 9 --max-diameter-um 3", "--min-diameter-um"},
      {"t.csv --pixel-size-um 1 --classes 0", "--classes"},
      {"t.csv --pixel-size-um 1 --replicates 0", "replicates"}};
  for (const auto& [arguments, expected] : wrong) {
    const auto result =
        powderlink(fmt::format("psd {0}/{1} --json {0}/f.json --out {0}/out", base, arguments));
    EXPECT_EQ(result.status, 1) << arguments;
    for (const char* part : {expected, "; given: ", "; allowed: ", "; to do: "})
      EXPECT_NE(result.err.find(part), std::string::npos) << arguments << ": " << result.err;
  }
  EXPECT_EQ(read_file(folder.path() / "f.json"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace powderlink::analysis
