// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/solver_log.h"

#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

/// As powderFoam prints it, 2 s of wall clock per simulated ms; `mark` before each line.
std::string log_text(const std::string& program, const std::string& mark = "") {
  std::string text = mark + "Build  : 1912\n" + mark + "Exec   : " + program + " -parallel\n";
  for (int i = 0; i <= 20; ++i) {
    text += fmt::format("{0}Time = {1:g}\n{0}\n{0}ExecutionTime = {2} s  ClockTime = {2} s\n", mark,
                        1e-3 * i, 2 * i);
  }
  return text + mark + "coupling share: 7.5 % of the coupled steps\n";
}

TEST(SolverLog, WhateverItsName) {
  for (const char* name :
       {"log.powderFoam", "job.out", "slurm-4711.out", "terminal", "log.mpirun"}) {
    const TestFolder folder;
    folder.write(name, "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0)\n" + log_text("powderFoam"));
    folder.write("log.blockMesh", log_text("blockMesh"));
    folder.write("in.duct", "timestep 1e-6\n");
    EXPECT_EQ(find_solver_log(folder.path()).filename(), name);
    const SolverCost cost = read_solver_cost(folder.path(), 0.0);
    EXPECT_NEAR(cost.wall_s_per_simulated_ms.value_or(0.0), 2.0, 1e-9) << name;
    EXPECT_EQ(cost.coupling_share_percent, 7.5) << name;
  }
}

TEST(SolverLog, MarksOfRanksAndTheOption) {
  const TestFolder folder;
  EXPECT_TRUE(find_solver_log(folder.path()).empty());
  EXPECT_FALSE(read_solver_cost(folder.path(), 0.0).wall_s_per_simulated_ms);
  const std::string tagged = log_text("/usr/local/bin/powderFoam", "[1,1]<stdout>:");
  write_in(folder, "elsewhere/run", tagged);
  EXPECT_TRUE(find_solver_log(folder.path()).empty());
  const SolverCost cost = read_solver_cost(folder.path(), 0.0, folder.path() / "elsewhere/run");
  EXPECT_NEAR(cost.wall_s_per_simulated_ms.value_or(0.0), 2.0, 1e-9);
  expect_refusal([&] { read_solver_cost(folder.path(), 0.0, folder.path() / "none"); }, {"--log"});
}

TEST(SolverLog, TheNewestOfSeveral) {
  const TestFolder folder;
  folder.write("first.log", log_text("powderFoam"));
  folder.write("second.log", log_text("powderFoam"));
  const auto now = std::filesystem::last_write_time(folder.path() / "second.log");
  std::filesystem::last_write_time(folder.path() / "second.log", now - std::chrono::hours(1));
  EXPECT_EQ(find_solver_log(folder.path()).filename(), "first.log");
}

}  // namespace
}  // namespace powderlink::analysis
