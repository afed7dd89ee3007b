// SPDX-License-Identifier: GPL-3.0-or-later
// Texts go through gnuplot unharmed and come out as titles; fingerprints are SHA-1.
#include "base/gnuplot/gnuplot.h"

#include "base/files/file_text.h"
#include "base/files/sha1.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

TEST(Gnuplot, QuotesAnyText) {
  EXPECT_EQ(gnuplot_string("it's"), "'it''s'");
  EXPECT_EQ(gnuplot_string("a\nb"), "'a b'");
}

TEST(Gnuplot, TurnsItsTooltipsIntoTitles) {
  const std::string svg =
      "<g onmousemove=\"gnuplot_svg.showHypertext(evt,'5 m/s &lt; 6')\" "
      "onmouseout=\"gnuplot_svg.hideHypertext()\"><title> </title><use/></g>"
      "<title>gnuplot_plot_3</title><title>model</title>";
  EXPECT_EQ(mended_svg(svg),
            "<g class=\"point\"><title>5 m/s &lt; 6</title><use/></g><title>model</title>");
}

TEST(Gnuplot, DrawsWithTheValuesOfTheTable) {
  if (!have_gnuplot()) GTEST_SKIP() << "no gnuplot";
  const TestFolder folder;
  const auto table = folder.write("it's.csv",
                                  "study,name,reduced_percent,dem_percent,hover,dem_hover\n"
                                  "1,a,33.3,,\"a & b < c: 33.3\",\"\"\n2,b,6.5,,\"b: 6.5\",\"\"\n");
  const auto svg = folder.path() / "figure.svg";
  draw_figure(svg, "report_staircase.gp",
              "table=" + gnuplot_string(table.string()) +
                  "; studies=2; names='a b'; n_dem=0; noise=5; most=33.3",
              "stop");
  const std::string text = file_text(svg);
  EXPECT_NE(text.find("<title>a &amp; b &lt; c: 33.3</title>"), std::string::npos);
  EXPECT_NE(text.find("<title>b: 6.5</title>"), std::string::npos);
  EXPECT_EQ(text.find("gnuplot_svg"), std::string::npos) << "asks for a script";
}

TEST(Gnuplot, SaysWhatItRefuses) {
  if (!have_gnuplot()) GTEST_SKIP() << "no gnuplot";
  const TestFolder folder;
  expect_refusal(
      [&] { draw_figure(folder.path() / "f.svg", "report_fit.gp", "table='absent'", "stop"); },
      {"f.svg"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "f.svg"));
}

// FIPS 180-4, the example of one block.
TEST(Fingerprint, IsSha1) { EXPECT_EQ(sha1("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d"); }

}  // namespace
}  // namespace powderlink::analysis
