// SPDX-License-Identifier: GPL-3.0-or-later
// `powderlink kat analyse` with pictures instead of tables.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/analysis/program/command_line.h"
#include "tests/analysis/sizes/drawn_spheres.h"

namespace powderlink::analysis {
namespace {

// Some 400 grains around d_c, so that the two beside it are 1 % apart; edges add less than that.
constexpr double kCut = 0.03;

class KatPictures : public testing::Test {
 protected:
  KatPictures() {
    scene_.width = 1600;
    scene_.height = 1200;
    scene_.median_px = 40;
    scene_.fraction = 0.2;
    scene_.light = 0.3;
    save("before.png");
    scene_.largest_px = 46;
    save("after.png");
  }
  void save(const std::string& name) {
    cv::Mat bytes;
    draw(scene_).grey.convertTo(bytes, CV_8U, 255);
    cv::imwrite(path(name), bytes);
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  CommandResult analyse(const std::string& after, const std::string& more) const {
    return powderlink("kat analyse --before " + path("before.png") + " --after " + path(after) +
                      " --velocity 1.4 --particle 316L --substrate UPVC --no-figures --out " +
                      path("out") + " --json " + path("kat.json") + " " + more);
  }
  TestFolder folder_;
  Scene scene_;
};

TEST_F(KatPictures, GiveTheDiameterAboveWhichGrainsLeft) {
  const CommandResult r = analyse("after.png", "--pixel-size-um 1");
  ASSERT_EQ(r.status, 0) << r.err;
  const auto d = nlohmann::json::parse(read_file(path("kat.json"))).at("critical_diameter_um");
  EXPECT_NEAR(d.at("value").get<double>() / 46.0, 1.0, kCut) << d;
  EXPECT_LE(d.at("low"), d.at("value"));
  EXPECT_GE(d.at("high"), d.at("value"));
  for (const char* overlay : {"overlay_1_before.png", "overlay_2_after.png"})
    EXPECT_FALSE(cv::imread(path("out/") + overlay).empty()) << overlay;
}

TEST_F(KatPictures, MixWithTables) {
  // The same grains, one of the two sets measured before by powderlink psd.
  ASSERT_EQ(powderlink("psd " + path("after.png") + " --pixel-size-um 1 --no-figures --out " +
                       path("psd"))
                .status,
            0);
  ASSERT_EQ(analyse("after.png", "--pixel-size-um 1").status, 0);
  const std::string pictures = read_file(path("kat.json"));
  const CommandResult r = analyse("psd/particles.csv", "--pixel-size-um 1");
  ASSERT_EQ(r.status, 0) << r.err;
  const auto value = [](const std::string& text) {
    return nlohmann::json::parse(text).at("critical_diameter_um").at("value").get<double>();
  };
  constexpr double kGapAtTheCut = 0.01;  // between two grains every d_c is as likely
  EXPECT_NEAR(value(read_file(path("kat.json"))) / value(pictures), 1.0, kGapAtTheCut);
}

/// Tables of counted pixels: the same areas as exact numbers leave d_c of an ideal truncation outside of
/// its interval, 0.6 % too high, as the grains that scatter upwards stay.
TEST(KatTables, ThePixelIsInTheInterval) {
  constexpr double cut_px = 19;
  boost::random::mt19937_64 generator(4);
  boost::random::uniform_01<double> any;
  boost::random::normal_distribution<double> normal;
  const auto table = [&](const char* header, double largest) {
    generator.seed(largest < 100 ? 4 : 5);
    std::string text = header;
    for (int k = 0; k < 6000; ++k) {
      const double r = 8.5 * std::exp(0.3 * normal(generator)), x = any(generator),
                   y = any(generator);
      if (2 * r > largest) continue;
      int area = 0;
      for (int i = static_cast<int>(-r) - 1; i <= static_cast<int>(r) + 2; ++i) {
        const double half = std::sqrt(std::max(0.0, r * r - (i - x) * (i - x)));
        if (half > 0) area += static_cast<int>(std::floor(y + half) - std::ceil(y - half)) + 1;
      }
      text += fmt::format("{},{:.5g}\n", area, std::sqrt(4 * M_PI * area));
    }
    return text;
  };
  const TestFolder folder;
  const std::string base = folder.path().string();
  const auto analyse = [&](const char* header, const char* option) {
    folder.write("b.csv", table(header, 1e9));
    folder.write("a.csv", table(header, cut_px));
    const CommandResult r = powderlink(fmt::format(
        "kat analyse --before {0}/b.csv --after {0}/a.csv --velocity 1.4 --particle 316L "
        "--substrate UPVC --bootstrap 50 --json {0}/k.json {1}",
        base, option));
    EXPECT_EQ(r.status, 0) << r.err;
    return nlohmann::json::parse(read_file(folder.path() / "k.json"));
  };
  const auto known = analyse("Area,Perim.\n", "--pixel-size-um 1").at("critical_diameter_um");
  EXPECT_LE(known.at("low").get<double>(), cut_px) << known;
  EXPECT_GE(known.at("high").get<double>(), cut_px) << known;
  EXPECT_NEAR(known.at("value").get<double>() / cut_px, 1, 0.004) << known;
  const auto exact = analyse("area_um2,perimeter_um\n", "");
  EXPECT_GT(exact.at("retained").at("truncation_um").at("low").get<double>(), cut_px) << exact;
}

TEST_F(KatPictures, NeedAScaleAndGrains) {
  const CommandResult unscaled = analyse("after.png", "");
  EXPECT_EQ(unscaled.status, 1);
  EXPECT_NE(unscaled.err.find("a picture without a scale"), std::string::npos) << unscaled.err;
  cv::imwrite(path("empty.png"), cv::Mat(200, 300, CV_8U, cv::Scalar(120)));
  const CommandResult empty = analyse("empty.png", "--pixel-size-um 1");
  EXPECT_EQ(empty.status, 1);
  EXPECT_NE(empty.err.find("empty.png"), std::string::npos) << empty.err;
  for (const auto& r : {unscaled, empty}) EXPECT_NE(r.err.find("; to do: "), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("kat.json")));
}

}  // namespace
}  // namespace powderlink::analysis
