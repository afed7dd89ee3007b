// SPDX-License-Identifier: GPL-3.0-or-later
// `powderlink kat analyse` with pictures instead of tables.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/analysis/command_line.h"
#include "tests/psd/drawn_spheres.h"

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
