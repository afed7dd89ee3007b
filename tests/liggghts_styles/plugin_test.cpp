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

/// One rank that finds an error ends by MPI_Abort; what it said stood in a buffer.
TEST(Plugin, AnErrorOfThePreloadedProgramIsInItsRedirectedOutput) {
  for (const int ranks : {1, 2}) {
    const LiggghtsCase c("preload_error");
    const Outcome o = c.run("units si\natom_style granular\nread_data missing.data\n", ranks,
                            LiggghtsCase::Program::preload);
    EXPECT_EQ(o.status, 1) << o.output;
    EXPECT_NE(o.output.find("ERROR on proc 0: Cannot open file missing.data"), std::string::npos)
        << o.output;
  }
}

/// No function of ours is asked when a process is killed.
TEST(Plugin, WhatWasSaidBeforeAKillIsInTheRedirectedOutput) {
  for (const auto program : {LiggghtsCase::Program::launcher, LiggghtsCase::Program::preload}) {
    const LiggghtsCase c("preload_killed");
    c.write("kill.sh",
            "for p in $PPID $(cut -d' ' -f4 /proc/$PPID/stat); do\n"
            "  case $(cat /proc/$p/comm) in liggghts*) kill -9 $p; sleep 1 ;; esac\ndone\n");
    const Outcome o = c.run(
        "units si\nprint \"before the end\"\nshell sh kill.sh\nprint \"after it\"\n", 1, program);
    EXPECT_NE(o.status, 0);
    EXPECT_NE(o.output.find("before the end"), std::string::npos) << o.output;
    EXPECT_EQ(o.output.find("after it"), std::string::npos) << o.output;
  }
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
