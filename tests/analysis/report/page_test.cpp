// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings inside a page, and texts as it shows them.
#include "analysis/report/column_title.h"
#include "analysis/report/inline_svg.h"
#include "analysis/report/report_figures.h"
#include "analysis/report/typeset.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

TEST(InlineSvg, OwnsItsIdsAndHasNoSize) {
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg width=\"720\" height=\"540\" viewBox=\"0 0 720 540\">"
      "<path id='gpPt0'/><use xlink:href='#gpPt0'/><g clip-path=\"url(#clip)\" id=\"clip\" "
      "width=\"3\"/></svg>";
  EXPECT_EQ(inline_svg(svg, "fit"),
            "<svg viewBox=\"0 0 720 540\"><path id='fit-gpPt0'/><use xlink:href='#fit-gpPt0'/>"
            "<g clip-path=\"url(#fit-clip)\" id=\"fit-clip\" width=\"3\"/></svg>");
  expect_refusal([] { inline_svg("no drawing", "fit"); }, {"fit"});
}

TEST(Typeset, WritesSignsForNames) {
  EXPECT_EQ(typeset("chi^2 1, 3 J/m^2, 5 um, delta BIC"), "χ² 1, 3 J/m², 5 µm, ΔBIC");
  EXPECT_EQ(typeset("critical_diameter_um, sum"), "critical_diameter_um, sum");
  EXPECT_EQ(typeset("adhesive_energy_J_m2 = 2 J/m^2, v_star_m_s = 1 m/s, n = 3"),
            "Γ = 2 J/m², v_star = 1 m/s, n = 3");
  EXPECT_EQ(typeset("curve over impact_velocity_m_s"), "curve over impact velocity");
  EXPECT_EQ(sentence("a drop"), "A drop.");
  EXPECT_EQ(sentence("psd_cutoff: x"), "psd_cutoff: x.");
  EXPECT_EQ(parts("a; b"), (std::vector<std::string>{"a", "b"}));
}

TEST(ColumnTitle, HasWordsAndUnit) {
  EXPECT_EQ(column_title("gamma_energy_J_m2"), "Γ energy (J/m²)");
  EXPECT_EQ(column_title("rebound_time_ns"), "rebound time (ns)");
  EXPECT_EQ(column_title("relative_humidity"), "relative humidity");
  EXPECT_EQ(column_words("impact_velocity_m_s"), "impact velocity");
}

TEST(FigureNames, AreSafe) {
  EXPECT_EQ(safe_name("a/../b <c>'d"), "a____b__c__d");
  EXPECT_EQ(safe_name("x+finite_stop-1"), "x+finite_stop-1");
  EXPECT_EQ(safe_name(""), "study");
}

}  // namespace
}  // namespace powderlink::analysis
