// SPDX-License-Identifier: GPL-3.0-or-later
// The two ways into LIGGGHTS: the launcher, and the preload into the stock program. Not under the
// sanitizers: their runtime must come first in a process, and LD_PRELOAD is taken.
#include <gtest/gtest.h>

#include "liggghts_case.h"

namespace powderlink::testing {
namespace {

Outcome bounce(const std::string& name, LiggghtsCase::Program program) {
  Setting s;
  Sphere sphere;
  sphere.x[2] = 0.5 * sphere.diameter + 1e-7;
  sphere.v[2] = -2.0;
  const LiggghtsCase c(name);
  c.write_spheres("spheres.data", {sphere}, 3e-4);
  return c.run(header(s, "spheres.data") + primitive_plate(s) + run_lines(1200), 1, program);
}

TEST(Plugin, PreloadIntoTheStockProgramGivesTheSameAsTheLauncher) {
  const Outcome ours = bounce("by_launcher", LiggghtsCase::Program::launcher);
  const Outcome stock = bounce("by_preload", LiggghtsCase::Program::preload);
  ASSERT_EQ(ours.status, 0) << ours.output;
  ASSERT_EQ(stock.status, 0) << stock.output;
  ASSERT_EQ(stock.last.size(), 1u);
  EXPECT_GT(stock.last[0].v[2], 0.0);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(ours.last[0].v[k], stock.last[0].v[k]);
}

TEST(Plugin, StockProgramAloneDoesNotKnowJkr) {
  EXPECT_NE(bounce("by_stock", LiggghtsCase::Program::stock).status, 0);
}

TEST(Plugin, HelpListsOurStyles) {
  const LiggghtsCase c("help");
  const Outcome o = c.help();
  for (const char* word : {"model jkr", "kat/drop", "adhesion/effect", "kat/run", "-in"}) {
    EXPECT_NE(o.output.find(word), std::string::npos) << word << "\n" << o.output;
  }
}

}  // namespace
}  // namespace powderlink::testing
