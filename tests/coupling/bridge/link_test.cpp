// SPDX-License-Identifier: GPL-3.0-or-later
// A coupled job as its hosts see it: order of calls, ends and errors, on both routes.
#include "coupling/bridge/link/coupling_link.h"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "tests/coupling/bridge/mpirun.h"
#include "tests/coupling/bridge/temporary_folder.h"

namespace powderlink::test {
namespace {

Outcome job(int dem_ranks, int solver_ranks, const std::string& route, const std::string& task) {
  const TemporaryFolder folder;
  const std::string rest = " " + task + " " + route + " " + folder.path();
  return mpirun(ranks_of(dem_ranks, LINK_PROGRAM, "dem" + rest) + " : " +
                ranks_of(solver_ranks, LINK_PROGRAM, "solver" + rest));
}

/// Every rank of both programs says the words, and the job ends with status 0 in time.
void expect_all_say(const Outcome& run, int dem_ranks, const std::string& dem_words,
                    int solver_ranks, const std::string& solver_words) {
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_LT(run.wall_s, 8.0) << "no wait may have run into its timeout\n" << run.output;
  for (int rank = 0; rank < dem_ranks; ++rank) {
    EXPECT_TRUE(run.says("dem " + std::to_string(rank) + ": " + dem_words)) << run.output;
  }
  for (int rank = 0; rank < solver_ranks; ++rank) {
    EXPECT_TRUE(run.says("solver " + std::to_string(rank) + ": " + solver_words)) << run.output;
  }
}

using Ranks = std::tuple<const char*, int, int>;
class LinkRanks : public ::testing::TestWithParam<Ranks> {};

TEST_P(LinkRanks, ValuesComeBackToTheirParticlesUntilTheDemFinishes) {
  const auto [route, dem, solver] = GetParam();
  expect_all_say(job(dem, solver, route, "go"), dem, "finished", solver, "dem finished");
}

TEST_P(LinkRanks, ASolverThatStopsEndsBothInOrder) {
  const auto [route, dem, solver] = GetParam();
  expect_all_say(job(dem, solver, route, "stop"), dem, "stopped in round 2", solver, "stopped");
}

INSTANTIATE_TEST_SUITE_P(Routes, LinkRanks,
                         ::testing::Combine(::testing::Values("mpi", "socket"),
                                            ::testing::Values(1, 2), ::testing::Values(1, 2)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + "_" +
                                  std::to_string(std::get<1>(info.param)) + "_to_" +
                                  std::to_string(std::get<2>(info.param));
                         });

class LinkRoute : public ::testing::TestWithParam<const char*> {};

TEST_P(LinkRoute, ASolverMayFinishBetweenExchanges) {
  expect_all_say(job(2, 2, GetParam(), "finish"), 2, "stopped in round 2", 2, "finished by itself");
}

TEST_P(LinkRoute, AFieldThatTheDemDoesNotKnowIsRefusedOnAllRanks) {
  expect_all_say(job(2, 2, GetParam(), "unknown_field"), 2, "told", 2, "told");
}

TEST_P(LinkRoute, DifferentIntervalsAreRefusedOnAllRanks) {
  expect_all_say(job(2, 2, GetParam(), "interval"), 2, "told", 2, "told");
}

TEST_P(LinkRoute, AnErrorOfTheDemReachesTheSolver) {
  expect_all_say(job(2, 2, GetParam(), "dem_fails"), 2, "failed", 2, "told");
}

TEST_P(LinkRoute, AnErrorOfTheSolverReachesTheDem) {
  expect_all_say(job(2, 2, GetParam(), "solver_fails"), 2, "told", 2, "failed");
}

TEST_P(LinkRoute, ADemThatLeavesWithoutGoodbyeIsNamed) {
  const Outcome run = job(1, 2, GetParam(), "dem_leaves");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(run.says("solver 1: told")) << run.output;
}

INSTANTIATE_TEST_SUITE_P(Routes, LinkRoute, ::testing::Values("mpi", "socket"),
                         [](const auto& info) { return std::string(info.param); });

TEST(Link, AnErrorOfOneRankIsKnownToAllOfItsProgram) {
  const Outcome run = job(2, 1, "mpi", "dem_rank_fails");
  EXPECT_NE(run.status, 0);
  EXPECT_LT(run.wall_s, 8.0) << run.output;
  EXPECT_TRUE(run.says("dem 0: told") && run.says("dem 1: told")) << run.output;
}

TEST(Link, AProgramThatEndsByItselfSaysWhyOnBothSidesWithinFiveSeconds) {
  const double orderly_s = job(2, 2, "mpi", "go").wall_s;  // start and end of a job on this machine
  for (const auto& [task, told] : {std::pair("dem_dies", "solver 0: told"),
                                   {"dem_rank_dies", "solver 0: told"},
                                   {"solver_rank_fails", "dem 0: told"}}) {
    const Outcome run = job(2, 2, "mpi", task);
    EXPECT_NE(run.status, 0) << task;
    EXPECT_LT(run.wall_s, orderly_s + 5.0) << task << run.output;
    EXPECT_TRUE(run.says(told)) << task << run.output;
  }
}

TEST(Link, AProgramAloneIsToldHowToCouple) {
  for (const char* launcher : {"serial", "mpirun"}) {
    const std::string line = LINK_PROGRAM " dem go mpi";
    const Outcome run =
        std::string(launcher) == "serial" ? shell("timeout 20 " + line) : mpirun("-np 2 " + line);
    EXPECT_NE(run.status, 0);
    EXPECT_TRUE(run.says("coupling by mpi; given: a job that holds this program alone"))
        << run.output;
  }
}

TEST(RankMap, PointsOutsideGoToTheNearestVoxel) {
  bridge::RankMap map;
  map.origin_m = {1.0, 2.0, 3.0};
  map.spacing_m = {0.5, 1.0, 2.0};
  map.voxels = {2, 2, 2};
  map.rank = {0, 1, 2, 3, 4, 5, -1, 7};
  const auto rank = [&](double x, double y, double z) {
    const double point[3] = {x, y, z};
    return map.rank_of(point);
  };
  EXPECT_EQ(rank(1.1, 2.1, 3.1), 0);
  EXPECT_EQ(rank(1.9, 2.1, 3.1), 1);
  EXPECT_EQ(rank(1.1, 3.5, 3.1), 2);
  EXPECT_EQ(rank(1.9, 2.1, 6.9), 5);
  EXPECT_EQ(rank(-9.0, -9.0, -9.0), 0);
  EXPECT_EQ(rank(9.0, 9.0, 1e300), 7);
  EXPECT_EQ(rank(1.1, 9.0, 9.0), 0) << "the voxel of nobody";
  EXPECT_EQ(rank(std::nan(""), 9.0, 3.1), 2) << "not a number: the first voxel along that axis";
}

}  // namespace
}  // namespace powderlink::test
