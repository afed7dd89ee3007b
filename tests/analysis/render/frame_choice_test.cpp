// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/frame_choice.h"

#include <gtest/gtest.h>

#include "analysis/render/legend.h"
#include "tests/analysis/render/dump_sample.h"

namespace powderlink::render::test {
namespace {

std::vector<State> sample_states(const std::filesystem::path& folder) {
  write_run(folder);
  const RunDirectory run = open_run(folder);
  std::vector<State> states;
  for (std::size_t i = 0; i < run.particles.size(); ++i)
    states.push_back(read_state(run, i, "kat"));
  return states;
}

TEST(FrameChoice, BeforeIsTheLastStateWithAllAttached) {
  const TemporaryFolder folder;
  EXPECT_EQ(state_before(sample_states(folder.path())), 0U);
}

TEST(FrameChoice, WindowHoldsGrainsThatStayAndGrainsThatLeave) {
  const TemporaryFolder folder;
  const auto states = sample_states(folder.path());
  const ViewWindow window = choose_window(states.front(), states.back(), 6.0, 0.6, 1.0);
  int stay = 0, leave = 0;
  for (const Grain& grain : grains_in(states.back(), states.front(), window)) {
    ++(grain.attached ? stay : leave);
  }
  EXPECT_GT(stay, 3);
  EXPECT_GT(leave, 3);
}

TEST(FrameChoice, StatesRunFromBeforeTheImpactToTheEnd) {
  const TemporaryFolder folder;
  const auto states = sample_states(folder.path());
  const ViewWindow window = choose_window(states.front(), states.back(), 10.0, 0.6, 1.0);
  EXPECT_EQ(choose_states(states, window, 3), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(choose_states(states, window, 1), (std::vector<std::size_t>{4}));
}

TEST(FrameChoice, FarGrainsAreClipped) {
  const TemporaryFolder folder;
  const auto states = sample_states(folder.path());
  ViewWindow window = choose_window(states.front(), states.back(), 10.0, 0.6, 1.0);
  const auto all = grains_in(states.back(), states.front(), window).size();
  window.depth_um = 60.0;
  for (const Grain& grain : grains_in(states.back(), states.front(), window)) {
    EXPECT_GE(grain.z_um - 0.5 * grain.diameter_um, -60.0);
  }
  EXPECT_LT(grains_in(states.back(), states.front(), window).size(), all);
}

TEST(FreeFlight, FallsWithSpeedAndGravityAndOnlyWhatIsDetached) {
  State last;
  last.clock = 1e-5;
  last.grains = {{1, 0.0, 0.0, -50.0, 60.0, 0.5, false}, {2, 0.0, 0.0, -20.0, 40.0, 0.0, true}};
  const State later = fly(last, 1e-3);
  EXPECT_NEAR(later.grains[0].z_um, -50.0 - 500.0 - 4.905, 1e-9);
  EXPECT_NEAR(later.grains[0].speed_m_s, 0.5 + 9.81e-3, 1e-12);
  EXPECT_DOUBLE_EQ(later.grains[1].z_um, -20.0);
  EXPECT_DOUBLE_EQ(later.clock, 1.01e-3);
}

TEST(FreeFlight, EndsWhereTheFirstGrainReachesTheDepth) {
  State last;
  last.grains = {{1, 0.0, 0.0, -50.0, 60.0, 0.5, false}, {2, 10.0, 0.0, -20.0, 40.0, 0.0, true}};
  ViewWindow window;
  window.width_um = window.breadth_um = window.depth_um = 1000.0;
  const double time = flight_time_s(last, last, window, 0.7);
  const State end = fly(last, time);
  EXPECT_NEAR(end.grains[0].z_um - 30.0, -700.0, 1e-6);
  last.grains[0].attached = true;
  EXPECT_DOUBLE_EQ(flight_time_s(last, last, window, 0.7), 0.0);
}

TEST(Legend, LengthsAndScalesAreRound) {
  EXPECT_DOUBLE_EQ(round_length(730.0), 500.0);
  EXPECT_DOUBLE_EQ(round_length(499.0), 200.0);
  EXPECT_DOUBLE_EQ(round_length(0.11), 0.1);
  EXPECT_DOUBLE_EQ(round_scale(1.23), 1.5);
  EXPECT_DOUBLE_EQ(round_scale(0.081), 0.1);
  EXPECT_DOUBLE_EQ(round_scale(0.0), 1.0);
  for (const double scale : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 0.1, 15.0}) {
    // At most one digit after the leading decade.
    const double step = scale / scale_ticks(scale) / round_scale(scale) * 60.0;
    EXPECT_NEAR(step, std::round(step), 1e-9) << scale;
    EXPECT_GE(scale_ticks(scale), 3) << scale;
    EXPECT_LE(scale_ticks(scale), 5) << scale;
  }
}

}  // namespace
}  // namespace powderlink::render::test
