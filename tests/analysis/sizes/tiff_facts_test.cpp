// SPDX-License-Identifier: GPL-3.0-or-later
// Scale and number of pictures of TIFFs as Fiji and microscopes write them, and what becomes of both.
#include "analysis/sizes/pictures/tiff_facts.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/analysis/program/command_line.h"
#include "tests/analysis/sizes/drawn_spheres.h"
#include "tests/analysis/sizes/tiff_files.h"

namespace powderlink::analysis {
namespace {

constexpr double kFloat = 1e-6;  // of libtiff's resolution

class Tiff : public testing::Test {
 protected:
  TiffFacts facts(const TiffTags& tags) const {
    EXPECT_TRUE(write_tiff(path("t.tif"), cv::Mat(40, 50, CV_8U, cv::Scalar(7)), tags));
    return read_tiff_facts(path("t.tif"));
  }
  void save(const std::string& name, const TiffTags& tags, double largest_px = 1e9) const {
    Scene scene;
    scene.width = 800;
    scene.height = 600;
    scene.largest_px = largest_px;
    cv::Mat bytes;
    draw(scene).grey.convertTo(bytes, CV_8U, 255);
    ASSERT_TRUE(write_tiff(path(name), bytes, tags));
  }
  CommandResult psd(const std::string& name, const std::string& more = "") const {
    return powderlink(fmt::format("psd {0}/{1} --json {0}/f.json --out {0}/out --no-figures {2}",
                                  folder.path().string(), name, more));
  }
  nlohmann::json result() const { return nlohmann::json::parse(read_file(path("f.json"))); }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  TestFolder folder;
};

TEST_F(Tiff, HasTheScaleThatFijiWrote) {
  const std::pair<const char*, double> units[] = {
      {"um", 1.0},  {"micron", 1.0}, {"\xC2\xB5m", 1.0}, {"\\u00B5m", 1.0},
      {"nm", 1e-3}, {"mm", 1e3},     {"cm", 1e4},        {"inch", 25400.0}};
  for (const auto& [unit, um] : units) {
    const auto size = facts(of_imagej(0.65 / um, unit)).pixel_size_um;
    ASSERT_TRUE(size) << unit;
    EXPECT_NEAR(*size, 0.65, 0.65 * kFloat) << unit;
  }
  for (const char* none : {"pixel", "", "furlong"})
    EXPECT_FALSE(facts(of_imagej(0.65, none)).pixel_size_um) << none;
  // Millimetres may be large; centimetres and inches are then those of a printer.
  EXPECT_NEAR(*facts(of_imagej(0.05, "mm")).pixel_size_um, 50.0, 50.0 * kFloat);
  EXPECT_FALSE(facts(of_imagej(1.0 / 300.0, "inch")).pixel_size_um);
}

TEST_F(Tiff, HasTheScaleOfAMicroscopeAndNotThatOfAPrinter) {
  EXPECT_NEAR(*facts({"", 1e4 / 0.65, 0.0, RESUNIT_CENTIMETER}).pixel_size_um, 0.65, kFloat);
  // Others than ImageJ write its description with a resolution per centimetre.
  EXPECT_NEAR(
      *facts({"ImageJ=1.51d\nunit=um\n", 1e4 / 0.65, 0.0, RESUNIT_CENTIMETER}).pixel_size_um, 0.65,
      kFloat);
  EXPECT_FALSE(facts({"", 72.0, 0.0, RESUNIT_INCH}).pixel_size_um);
  EXPECT_FALSE(facts({"", 300.0, 0.0, RESUNIT_INCH}).pixel_size_um);
  EXPECT_FALSE(facts({"", 1.5, 0.0, RESUNIT_NONE}).pixel_size_um);
  EXPECT_FALSE(facts({}).pixel_size_um);
  expect_refusal(
      [&] {
        facts({"ImageJ=1.54f\nunit=um\n", 2.0, 1.9, RESUNIT_NONE});
      },
      {"t.tif", "square pixels"});
}

TEST_F(Tiff, CountsItsPictures) {
  EXPECT_EQ(facts({}).pictures, 1);
  EXPECT_EQ(facts({"", 0.0, 0.0, 0, 3}).pictures, 3);
  EXPECT_EQ(facts({"", 0.0, 0.0, 0, 1, true}).pictures, 1);  // and a preview
  EXPECT_EQ(facts({"ImageJ=1.54f\nimages=7\n"}).pictures, 7);
  folder.write("damaged.tif", std::string("II*\0\xff\xff\xff\x7f", 8));
  folder.write("short.tif", "II");
  for (const char* name : {"damaged.tif", "short.tif", "none.tif"})
    EXPECT_EQ(read_tiff_facts(path(name)).pictures, 1) << name;
}

TEST_F(Tiff, ItsScaleIsThatOfTheSizes) {
  save("a.tif", of_imagej(0.65, "um"));
  const CommandResult own = psd("a.tif");
  ASSERT_EQ(own.status, 0) << own.err;
  EXPECT_NE(own.err.find("0.65 um per pixel, as the TIFF says"), std::string::npos) << own.err;
  const double d50_um = result()["d50_um"];
  ASSERT_EQ(psd("a.tif", "--pixel-size-um 0.65").status, 0);
  EXPECT_NEAR(result()["d50_um"].get<double>() / d50_um, 1.0, kFloat);
  EXPECT_EQ(psd("a.tif", "--scale-bar-um 65 --scale-bar-px 100").status, 0);
}

TEST_F(Tiff, ScalesThatDifferAndStacksAreRefused) {
  save("a.tif", of_imagej(0.65, "um"));
  save("b.tif", of_imagej(1.3, "um"));
  save("none.tif", {});
  save("stack.tif", {"", 0.0, 0.0, 0, 2});
  folder.write("t.csv", "# pixel_size_um: 0.5\nArea,Perim.\n400,80\n500,90\n");
  const std::pair<std::string, std::string> wrong[] = {
      {"a.tif --pixel-size-um 1.3", "0.65 um per pixel"},
      {"a.tif --scale-bar-um 1300 --scale-bar-px 1000", "0.65 um per pixel"},
      {"a.tif " + path("b.tif"), "1.3 um per pixel"},
      {"a.tif " + path("t.csv"), "0.5 um, as in the tables"},
      {"none.tif", "without a scale"},
      {"stack.tif --pixel-size-um 1", "a stack of 2 pictures"}};
  for (const auto& [arguments, expected] : wrong) expect_four_parts(psd(arguments), expected);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
  // A scale of one is that of the other.
  EXPECT_EQ(psd("a.tif " + path("none.tif")).status, 0);
}

TEST_F(Tiff, ItsScaleIsThatOfADropToo) {
  save("before.tif", of_imagej(0.5, "micron"));
  save("after.tif", of_imagej(0.5, "micron"), 30);
  const CommandResult r = powderlink(
      fmt::format("kat analyse --before {0}/before.tif --after {0}/after.tif --velocity 1.4 "
                  "--particle 316L --substrate UPVC --json {0}/f.json",
                  folder.path().string()));
  ASSERT_EQ(r.status, 0) << r.err;
  // The few grains of one picture leave gaps of some per cent around the cut at 30 pixels.
  EXPECT_NEAR(result()["critical_diameter_um"]["value"].get<double>(), 15.0, 1.0);
}

}  // namespace
}  // namespace powderlink::analysis
