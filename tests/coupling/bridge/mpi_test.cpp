// SPDX-License-Identifier: GPL-3.0-or-later
// Two programs in one mpirun.
#include <string>

#include <gtest/gtest.h>

#include "tests/coupling/bridge/mpirun.h"
#include "tests/coupling/bridge/temporary_folder.h"

namespace powderlink::test {
namespace {

std::string program(int ranks, const std::string& role, const std::string& task) {
  return ranks_of(ranks, BRIDGE_MPI_PROGRAM, role + " " + task);
}

Outcome coupled(int dem_ranks, int solver_ranks, const std::string& task) {
  return mpirun(program(dem_ranks, "dem", task) + " : " + program(solver_ranks, "solver", task));
}

TEST(Mpi, ConformanceOneToTwo) {
  const Outcome run = coupled(1, 2, "conformance");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(run.says("solver LeavingPeer: ok")) << run.output;
}

class MpiRanks : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(MpiRanks, EveryParticleFindsItsOwnerAndBack) {
  const TemporaryFolder folder;
  const Outcome run = coupled(GetParam().first, GetParam().second, "exchange " + folder.path());
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(run.says("dem 0: exchanges ok")) << run.output;
}

INSTANTIATE_TEST_SUITE_P(Ranks, MpiRanks,
                         ::testing::Values(std::pair(1, 1), std::pair(1, 2), std::pair(2, 1),
                                           std::pair(2, 3)),
                         [](const auto& info) {
                           return std::to_string(info.param.first) + "_to_" +
                                  std::to_string(info.param.second);
                         });

TEST(Mpi, SteadyRoundsAllocateNothing) {
  const Outcome run = coupled(1, 2, "steady");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(run.says("dem 0: 0 allocations")) << run.output;
}

TEST(Mpi, AnOwnerThatDoesNotExistStopsAllRanks) {
  const TemporaryFolder folder;
  const Outcome run = coupled(1, 2, "wrong_owner " + folder.path());
  EXPECT_EQ(run.status, 0) << run.output;
  for (const char* who : {"dem 0: told", "solver 0: told", "solver 1: told"}) {
    EXPECT_TRUE(run.says(who)) << run.output;
  }
}

TEST(Mpi, AWrongCaseIsToldToAllRanks) {
  const Outcome run = coupled(1, 2, "other_case");
  EXPECT_EQ(run.status, 0) << run.output;
  for (const char* who : {"dem 0: told", "solver 0: told", "solver 1: told"}) {
    EXPECT_TRUE(run.says(who)) << run.output;
  }
}

TEST(Mpi, ASolverThatIsLateEndsTheExchangeAtTheTimeout) {
  const Outcome run = coupled(1, 1, "late");
  EXPECT_NE(run.status, 0);
  EXPECT_TRUE(run.says("dem 0: told")) << run.output;
}

TEST(Mpi, AKilledProgramEndsBothWithinFiveSeconds) {
  const Outcome run = coupled(1, 2, "killed");
  EXPECT_NE(run.status, 0);
  EXPECT_LT(run.wall_s, 5.0) << run.output;
}

TEST(Mpi, AProgramThatDoesNotCoupleIsNoticedAtTheTimeout) {
  const Outcome run = mpirun(program(1, "dem", "present") + " : " + program(1, "solver", "absent"));
  EXPECT_NE(run.status, 0);
  EXPECT_LT(run.wall_s, 5.0);
  EXPECT_TRUE(run.says("waiting for the other program in this mpirun")) << run.output;
}

}  // namespace
}  // namespace powderlink::test
