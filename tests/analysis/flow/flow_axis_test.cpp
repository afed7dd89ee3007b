// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/flow_axis.h"

#include "analysis/flow/flow_report.h"
#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

TEST(FlowAxis, NamesAndOtherAxes) {
  for (const char* name : {"x", "y", "z", "-x", "-y", "-z"}) {
    EXPECT_EQ(flow_axis_of(name).name(), name);
  }
  EXPECT_EQ(flow_axis_of("+y").name(), "y");
  const FlowAxis x = flow_axis_of("x"), y = flow_axis_of("-y"), z;
  EXPECT_EQ(x.across(), 1U);
  EXPECT_EQ(x.up(), 2U);
  EXPECT_EQ(y.across(), 0U);
  EXPECT_EQ(y.up(), 2U);
  EXPECT_EQ(z.across(), 0U);
  EXPECT_EQ(z.up(), 1U);
  for (const char* name : {"", "w", "xy", "--x", "-"}) {
    expect_refusal([&] { flow_axis_of(name); }, {"--axis"});
  }
}

std::vector<DumpParticle> moving(double vx, double vy, double vz) {
  DumpParticle p;
  p.vx_m_s = vx, p.vy_m_s = vy, p.vz_m_s = vz;
  p.mass_kg = 1e-9;
  return {p, p};
}

TEST(FlowAxis, ProbesThenMeshThenParticlesPointTheWay) {
  const std::vector<Place> along_y{{0, 0.01, 0}, {0, 0.03, 0}};
  const Extent long_x{{0, 0, 0}, {0.04, 0.004, 0.004}}, cube{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(choose_flow_axis(along_y, long_x, moving(-1, -2, 3)).name(), "-y");
  EXPECT_EQ(choose_flow_axis({}, long_x, moving(-1, -2, 3)).name(), "-x");
  EXPECT_EQ(choose_flow_axis({{0, 0, 0}}, cube, moving(-1, -5, 3)).name(), "-y");
  EXPECT_EQ(choose_flow_axis({}, {}, {}).name(), "z");
  // A bed that is stirred goes nowhere.
  auto stirred = moving(0, 0, 1.0);
  stirred[1].vz_m_s = -1.05;
  EXPECT_EQ(choose_flow_axis({}, cube, stirred).name(), "z");
}

/// The stream of flow_case.h along any axis, either way: the same numbers.
TEST(FlowAxis, TheSameStreamAlongAnyAxis) {
  for (const char* name : {"x", "-x", "y", "-y", "z", "-z"}) {
    const FlowAxis axis = flow_axis_of(name);
    const TestFolder folder;
    const auto turned = [&](double across, double up, double along) {
      Place p{};
      p[axis.across()] = across;
      p[axis.up()] = up;
      p[axis.index] = axis.way * along;
      return p;
    };
    for (long step = 0; step <= 30000; step += 1000) {
      auto particles = stream_at(step);
      for (DumpParticle& p : particles) {
        const Place at = turned(p.x_m, p.y_m, p.z_m), v = turned(0.0, 0.0, p.vz_m_s);
        p.x_m = at[0], p.y_m = at[1], p.z_m = at[2];
        p.vx_m_s = v[0], p.vy_m_s = v[1], p.vz_m_s = v[2];
      }
      write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, particles));
    }
    std::string probes = probe_text(0.0, 0.03);
    for (int i = 0; i < 30; ++i) {
      const Place at = turned(0, 0, 0.005 + 0.01 * i);
      const std::string old = fmt::format("(0 0 {:g})", 0.005 + 0.01 * i);
      probes.replace(probes.find(old), old.size(),
                     fmt::format("({:g} {:g} {:g})", at[0], at[1], at[2]));
    }
    write_in(folder, "postProcessing/axis/0/p", probes);
    FlowOptions options;
    options.time_step_s = kStreamTimeStep_s;
    options.density_kg_m3 = kDensity_kg_m3;
    options.from_s = 0.01;
    const FlowReport report = analyse_flow(folder.path(), options);
    EXPECT_EQ(report.window().axis.name(), name);
    ASSERT_TRUE(report.slope) << name;
    EXPECT_EQ(report.slope->probes, 10U) << name;
    EXPECT_NEAR(report.slope->slope_Pa_m, kDensity_kg_m3 * kSlope_m_s2, 1e-3 * 28760.0) << name;
    EXPECT_NEAR(*report.mean_flow_kg_s, kStreamFlow_kg_s, 1e-9 * kStreamFlow_kg_s) << name;
    EXPECT_NEAR(*report.particles.velocity_mean_m_s(), kStreamSpeed_m_s, 1e-9) << name;
    const auto tables = flow_tables(report);
    EXPECT_NE(
        tables[2].second.find(fmt::format("{}_m,count,{}_05_m", axis.letter(), "xyz"[axis.up()])),
        std::string::npos)
        << tables[2].second.substr(0, 100);
    // Against the axis that was found: the same amounts, the other sign.
    options.axis = axis.way > 0 ? "-" + axis.name() : axis.name().substr(1);
    const FlowReport against = analyse_flow(folder.path(), options);
    EXPECT_NEAR(*against.mean_flow_kg_s, -kStreamFlow_kg_s, 1e-9 * kStreamFlow_kg_s) << name;
  }
}

/// A duct of 40 mm: its last third counts, and all of it as long as no grain has come there.
TEST(FlowAxis, ShortDuctHasDefaultsThatFit) {
  const TestFolder folder;
  const auto grains = [](double until_m) {
    std::vector<DumpParticle> particles;
    for (int i = 0; 1e-3 * i < until_m; ++i) {
      DumpParticle p;
      p.id = i + 1;
      p.z_m = 5e-4 + 1e-3 * i;
      p.vz_m_s = 1.0 + p.z_m;
      p.radius_m = 2e-5, p.mass_kg = 1e-9;
      particles.push_back(p);
    }
    return particles;
  };
  std::string box = dump_text(0, grains(0.04));
  box.replace(box.find("-1 1\n-1 1\n0 1\n"), 14, "-1e-3 1e-3\n-1e-3 1e-3\n0 0.04\n");
  write_in(folder, "post/particles_0.dump", box);
  FlowOptions options;
  options.time_step_s = 1e-6;
  const FlowReport all = analyse_flow(folder.path(), options);
  EXPECT_NEAR(all.window().from_m, 0.04 * 2.0 / 3.0, 1e-9);
  // Grains at 27.5 to 39.5 mm.
  EXPECT_NEAR(*all.particles.velocity_mean_m_s(), 1.0335, 1e-9);
  box = dump_text(0, grains(0.02));
  box.replace(box.find("-1 1\n-1 1\n0 1\n"), 14, "-1e-3 1e-3\n-1e-3 1e-3\n0 0.04\n");
  write_in(folder, "post/particles_0.dump", box);
  const FlowReport half = analyse_flow(folder.path(), options);
  EXPECT_NEAR(*half.particles.velocity_mean_m_s(), 1.01, 1e-9);
  EXPECT_NE(half.notes.front().find("last third"), std::string::npos) << half.notes.front();
  // Two probes, at inlet and outlet: their slope, not none.
  write_in(folder, "postProcessing/ends/0/p",
           "# Probe 0 (0 0 0)\n# Probe 1 (0 0 0.04)\n# Time\n1e-3 8 4\n2e-3 8 4\n");
  options.density_kg_m3 = 1.5;
  const FlowReport ends = analyse_flow(folder.path(), options);
  ASSERT_TRUE(ends.slope);
  EXPECT_NEAR(ends.slope->slope_Pa_m, 1.5 * 4.0 / 0.04, 1e-9);
  // Periodic along the axis: nothing develops.
  box.replace(box.find("BOUNDS ff ff ff"), 15, "BOUNDS ff ff pp");
  write_in(folder, "post/particles_0.dump", box);
  const FlowReport periodic = analyse_flow(folder.path(), options);
  EXPECT_FALSE(std::isfinite(periodic.window().from_m));
  EXPECT_NEAR(*periodic.particles.velocity_mean_m_s(), 1.01, 1e-9);
}

/// Of a stream through a box of 0 to 1 m (dump_text()): lengths in mm, or beyond the ends, would thin it.
TEST(FlowAxis, SlicesOfTheFlowLieInTheChannel) {
  const TestFolder folder;
  for (const long step : {0L, 1000L}) {
    write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, stream_at(step)));
  }
  FlowOptions options;
  options.time_step_s = kStreamTimeStep_s;
  for (const Interval wrong : {Interval{240, 250}, Interval{0.9, 1.1}, Interval{-0.01, 0.2}}) {
    options.flow_slice_m = wrong;
    expect_refusal([&] { analyse_flow(folder.path(), options); },
                   {"option --slice;", "0 to 1 m", "metres"});
  }
  options.flow_slice_m = Interval{0.1, 0.2};
  EXPECT_NEAR(*analyse_flow(folder.path(), options).mean_flow_kg_s, kStreamFlow_kg_s,
              1e-2 * kStreamFlow_kg_s);
  options.slice_m = 1.5;
  expect_refusal([&] { analyse_flow(folder.path(), options); }, {"--slice-thickness", "0 to 1 m"});
}

}  // namespace
}  // namespace powderlink::analysis
