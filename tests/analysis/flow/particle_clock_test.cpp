// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/particle_clock.h"

#include "analysis/flow/flow_report.h"
#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

void write_clock(const TestFolder& folder, const std::string& time, const std::string& entries) {
  write_in(folder, time + "/uniform/couplingClock",
           "FoamFile { version 2.0; format ascii; class dictionary; object couplingClock; }\n" +
               entries);
}

TEST(ParticleClock, WithoutASettlingBothClocksAreOne) {
  const TestFolder folder;
  ParticleClock clock(folder.path(), 1e-6);
  EXPECT_FALSE(clock.known());
  EXPECT_EQ(clock.gas_time_s(3000L), 3e-3);
}

TEST(ParticleClock, SubtractsWhatTheParticlesAreAhead) {
  POWDERLINK_NEEDS_FOAM();
  for (const char* root : {"", "processor0/"}) {
    const TestFolder folder;
    write_clock(folder, std::string(root) + "0.004", "particlesAhead 0.003;");
    ParticleClock clock(folder.path(), 1e-6);
    EXPECT_TRUE(clock.known());
    EXPECT_NEAR(clock.gas_time_s(7000L), 4e-3, 1e-15) << root;
    EXPECT_NEAR(clock.gas_time_s(2000L), -1e-3, 1e-15) << root;
    DumpState state;
    state.step = 5;
    state.time_s = 0.0055;  // the dump's own time is the particles' too
    EXPECT_NEAR(clock.gas_time_s(state), 2.5e-3, 1e-15) << root;
  }
}

/// A dump at the very time that a user gives counts, on whatever side of it round-off leaves the difference.
TEST(ParticleClock, HasTheTimesThatUsersWrite) {
  POWDERLINK_NEEDS_FOAM();
  const TestFolder folder;
  write_clock(folder, "0.02", "particlesAhead 0.003;");
  ParticleClock clock(folder.path(), 1e-6);
  for (long step = 3000; step <= 23000; step += 100) {
    EXPECT_EQ(clock.gas_time_s(step), static_cast<double>(step - 3000) / 1e6) << step;
  }
  const TestFolder unsettled;
  ParticleClock one(unsettled.path(), 1e-7);
  for (long step = 0; step <= 200000; step += 1000) {
    EXPECT_EQ(one.gas_time_s(step), static_cast<double>(step) / 1e7) << step;
  }
}

TEST(ParticleClock, TheGasMayBeAheadToo) {
  POWDERLINK_NEEDS_FOAM();
  // Steady gas of 0.5 s, new particles.
  const TestFolder folder;
  write_clock(folder, "0.6", "particlesAhead -0.5;");
  ParticleClock clock(folder.path(), 1e-6);
  EXPECT_NEAR(clock.gas_time_s(0L), 0.5, 1e-12);
  EXPECT_NEAR(clock.gas_time_s(100000L), 0.6, 1e-12);
}

TEST(ParticleClock, EachPartOfARunHasItsOwn) {
  POWDERLINK_NEEDS_FOAM();
  const TestFolder folder;
  // Written as anyone may write it; a clock that was cut off says nothing.
  write_clock(folder, "0.004", "/* particlesAhead 9; */ particlesAhead 1; particlesAhead 0.003;");
  write_clock(folder, "0.008", "particlesAhead 0.013;");
  write_clock(folder, "0.009", "particlesAhe");
  ParticleClock clock(folder.path(), 1e-6);
  EXPECT_NEAR(clock.gas_time_s(7000L), 4e-3, 1e-12);
  EXPECT_NEAR(clock.gas_time_s(18000L), 5e-3, 1e-12);
  EXPECT_NEAR(clock.gas_time_s(22000L), 9e-3, 1e-12);
}

/// The same run with and without 3 ms of settling before: the same numbers from 2 ms of gas on.
TEST(ParticleClock, FlowCountsOnTheGasClock) {
  POWDERLINK_NEEDS_FOAM();
  std::optional<double> flow[2];
  for (const long settled : {0L, 3000L}) {
    const TestFolder folder;
    for (long step = 0; step <= 6000 + settled; step += 500) {
      auto particles = stream_at(step);
      // At rest before the gas comes, then faster and faster.
      const double v = 1e-3 * static_cast<double>(std::max(0L, step - settled));
      for (DumpParticle& p : particles) p.vz_m_s = v;
      write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, particles));
    }
    FlowOptions options;
    options.time_step_s = kStreamTimeStep_s;
    options.from_s = 2e-3;
    // A coupled run that has not written yet is told apart.
    write_in(folder, "constant/couplingProperties", "model A;\n");
    const FlowReport early = analyse_flow(folder.path(), options);
    EXPECT_NE(early.notes.front().find("not written"), std::string::npos) << early.notes.front();
    write_clock(folder, "0.006", fmt::format("particlesAhead {:g};", 1e-6 * settled));
    const FlowReport report = analyse_flow(folder.path(), options);
    for (const auto& note : report.notes) EXPECT_EQ(note.find("not written"), std::string::npos);
    flow[settled > 0 ? 1 : 0] = report.mean_flow_kg_s;
    EXPECT_NEAR(report.times_s.front(), 2e-3, 1e-12);
    EXPECT_NEAR(report.times_s.back(), 6e-3, 1e-12);
  }
  // Mean of 2 to 6 m/s.
  EXPECT_NEAR(*flow[0], kStreamMass_kg * 4.0 / kStreamSpacing_m, 1e-12);
  EXPECT_NEAR(*flow[1], *flow[0], 1e-12);
}

}  // namespace
}  // namespace powderlink::analysis
