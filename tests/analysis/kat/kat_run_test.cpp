// SPDX-License-Identifier: GPL-3.0-or-later
// Child processes, runs and the runner, with a stand-in for LIGGGHTS.
#include "analysis/kat/dem/kat_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "analysis/kat/study/material_library.h"
#include "base/process/child_process.h"
#include "base/process/progress.h"
#include "tests/analysis/kat/steel_drop.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

namespace fs = std::filesystem;

/// Reads the sizes from the script and lets everything above 46 um leave; counts its calls.
const char* kStandIn = R"(#!/bin/sh
echo run >> calls.txt
mkdir -p post && touch post/particles_0.vtp
awk '/sizes range/ {
  for (i = 1; i <= NF; ++i) if ($i == "range") { low = $(i+1); high = $(i+2); n = $(i+3) }
  big = 0; small = 0; list = ""
  for (k = 0; k < n; ++k) {
    d = low * exp(log(high / low) * k / (n - 1))
    stays = d < 46e-6
    if (stays) big = d
    if (!stays && small == 0) small = d
    list = list (k ? "," : "") sprintf("{\"diameter_m\":%.12g,\"attached\":%s,\"speed_m_s\":0.1,\"balance\":1e-9}", d, stays ? "true" : "false")
  }
  printf "{\"largest_attached_m\":%s,\"smallest_detached_m\":%s,\"particles\":[%s]}\n", big ? sprintf("%.12g", big) : "null", small ? sprintf("%.12g", small) : "null", list
}' in.kat > kat_results.json
)";

fs::path program(const TestFolder& folder, const std::string& text) {
  fs::path file = folder.write("liggghts", text);
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

TEST(ChildProcess, StatusOutputAndFolder) {
  const TestFolder folder;
  const ChildOutcome out = run_child({"/bin/sh", "-c", "pwd; echo bad >&2; exit 3"}, folder.path(),
                                     folder.path() / "out.txt", 10.0);
  EXPECT_EQ(out.exit_status, 3);
  EXPECT_FALSE(out.over_time);
  const std::string text = read_file(folder.path() / "out.txt");
  EXPECT_NE(text.find(folder.path().filename().string()), std::string::npos);
  EXPECT_NE(text.find("bad"), std::string::npos);
  expect_refusal([&] { run_child({"/no/such/program"}, folder.path(), folder.path() / "x", 1.0); },
                 {"/no/such/program"});
}

TEST(ChildProcess, EndsAtTheLimit) {
  const TestFolder folder;
  const ChildOutcome out =
      run_child({"/bin/sleep", "30"}, folder.path(), folder.path() / "out.txt", 0.2);
  EXPECT_TRUE(out.over_time);
  EXPECT_EQ(out.exit_status, 128 + SIGTERM);
  EXPECT_LT(out.wall_s, 5.0);
}

TEST(DropRun, ReusesAFinishedRunOfTheSameScript) {
  const TestFolder folder;
  const DropRunner runner{program(folder, kStandIn), 10.0};
  const fs::path run = folder.path() / "run";
  const DropResult first = run_drop(runner, steel_drop(), run);
  EXPECT_FALSE(first.reused);
  EXPECT_TRUE(first.bracketed());
  EXPECT_EQ(first.particles.size(), 64U);
  const DropResult second = run_drop(runner, steel_drop(), run);
  EXPECT_TRUE(second.reused);
  EXPECT_EQ(second.largest_attached_m, first.largest_attached_m);
  DropScript other = steel_drop();
  other.impact_velocity_m_s = 1.5;
  EXPECT_FALSE(run_drop(runner, other, run).reused);
  fs::remove(run / "finished");  // as if it had been interrupted
  EXPECT_FALSE(run_drop(runner, other, run).reused);
  EXPECT_EQ(read_file(run / "calls.txt"), "run\nrun\nrun\n");
}

TEST(DropRun, TellsWhatLiggghtsSaid) {
  const TestFolder folder;
  const fs::path run = folder.path() / "run";
  const DropRunner fails{
      program(folder, "#!/bin/sh\necho 'ERROR: no such style (../a.cpp:1)'\nexit 1\n"), 10.0};
  expect_refusal([&] { run_drop(fails, steel_drop(), run); },
                 {"exit status 1", "no such style", "screen.txt"});
  const DropRunner silent{program(folder, "#!/bin/sh\nexit 0\n"), 10.0};
  expect_refusal([&] { run_drop(silent, steel_drop(), run); }, {"kat_results.json"});
  const DropRunner broken{program(folder, "#!/bin/sh\necho '{' > kat_results.json\n"), 10.0};
  expect_refusal([&] { run_drop(broken, steel_drop(), run); }, {"kat_results.json", "run again"});
  const DropRunner slow{program(folder, "#!/bin/sh\nexec sleep 30\n"), 0.2};
  expect_refusal([&] { run_drop(slow, steel_drop(), run); }, {"without an end", "--wall-limit"});
}

Study steel_study() {
  Study s;
  s.name = "test";
  s.particle = find_material("316L");
  s.substrate = find_material("UPVC");
  s.rows = {{1.4}, {1.41}, {1.42}};
  return s;
}

TEST(KatRunner, RowsSideBySide) {
  const TestFolder folder;
  KatRunOptions o{{program(folder, kStandIn), 10.0}, folder.path() / "out", 2, 0.002, false};
  const auto points = run_study(steel_study(), {17.175, 17.2, 17.3}, o);
  ASSERT_EQ(points.size(), 3U);
  for (const KatPoint& p : points) {
    EXPECT_NEAR(p.dem.critical_diameter_m / 46e-6, 1.0, 0.002);
    EXPECT_NEAR(p.reduced.diameter_m / p.theory.diameter_m, 1.0, 1e-3);
  }
  EXPECT_TRUE(fs::exists(o.out / "row_01/round_1/post"));
  EXPECT_FALSE(fs::exists(o.out / "row_03/round_2/post"));
  const auto again = run_study(steel_study(), {17.175, 17.2, 17.3}, o);
  EXPECT_EQ(again[2].dem.critical_diameter_m, points[2].dem.critical_diameter_m);
  EXPECT_EQ(again[2].dem.wall_s, 0.0);
}

TEST(KatRunner, NamesTheRowThatFails) {
  const TestFolder folder;
  Study s = steel_study();
  s.kat.diameter_range_um = {50.0, 90.0};
  const KatRunOptions o{{program(folder, kStandIn), 10.0}, folder.path() / "out", 1, 0.002, false};
  try {
    run_study(s, {17.0, 17.0, 17.0}, o);
    FAIL();
  } catch (const std::runtime_error& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("row 1 (1.4 m/s)"), std::string::npos) << text;
    EXPECT_NE(text.find("widen it downwards"), std::string::npos) << text;
  }
}

TEST(KatRunner, FindsLiggghtsByTheVariable) {
  const TestFolder folder;
  ::setenv("POWDERLINK_LIGGGHTS", (folder.path() / "nothing").c_str(), 1);
  expect_refusal([] { find_liggghts(); }, {"POWDERLINK_LIGGGHTS", "nothing"});
  ::setenv("POWDERLINK_LIGGGHTS", program(folder, kStandIn).c_str(), 1);
  EXPECT_EQ(find_liggghts(), folder.path() / "liggghts");
  ::unsetenv("POWDERLINK_LIGGGHTS");
}

TEST(Progress, ShortTimes) {
  EXPECT_EQ(short_time(0.2), "1 s");
  EXPECT_EQ(short_time(89.0), "89 s");
  EXPECT_EQ(short_time(100.0), "2 min");
  EXPECT_EQ(short_time(7200.0), "2.0 h");
}

}  // namespace
}  // namespace powderlink::analysis
