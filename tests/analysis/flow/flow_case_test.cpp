// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/analysis/flow/flow_case.h"
#include "analysis/flow/flow_report.h"
#include "analysis/flow/run/dem_time_step.h"

namespace powderlink::analysis {
namespace {

TEST(FlowCase, UniformStreamBesideALinearPressure) {
  POWDERLINK_NEEDS_FOAM();
  const TestFolder folder;
  write_stream_case(folder);
  FlowOptions options;
  options.from_s = 0.01;
  const FlowReport report = analyse_flow(folder.path(), options);
  ASSERT_TRUE(report.slope);
  EXPECT_EQ(report.slope->probes, 10U);
  // The shaking averages out but for its last unpaired row of 200: 50 x 2 m^2/s^2 / 201 over 0.1 m.
  EXPECT_NEAR(report.slope->slope_Pa_m, kDensity_kg_m3 * kSlope_m_s2, 1e-3 * 28760.0);
  EXPECT_NEAR(*report.mean_flow_kg_s, kStreamFlow_kg_s, 1e-9 * kStreamFlow_kg_s);
  ASSERT_TRUE(report.irregularity);
  EXPECT_NEAR(report.irregularity->rms_percent, 0.0, 1e-6);
  EXPECT_NEAR(*report.cost.wall_s_per_simulated_ms, 4.0, 1e-9);
  EXPECT_FALSE(report.cost.by_processor_time);
  EXPECT_EQ(report.cost.coupling_share_percent, 6.4);
  // Of what the case does not record at all, and of what does not bend or slow down.
  for (const std::string& note : report.notes) {
    EXPECT_TRUE(note.find("through the outlet") != std::string::npos ||
                note.find("pressure at the inlet") != std::string::npos ||
                note.find("balance of forces") != std::string::npos)
        << note;
  }
}

TEST(FlowCase, TablesSayWhatTheNamesSay) {
  POWDERLINK_NEEDS_FOAM();
  const TestFolder folder;
  write_stream_case(folder);
  const FlowReport report = analyse_flow(folder.path(), {});
  const auto tables = flow_tables(report);
  ASSERT_GE(tables.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [name, text] = tables[i];
    EXPECT_NE(text.find(name == "solids_flow.csv" ? "\n0.03,3000,3e-05," : "z_m,"),
              std::string::npos)
        << name;
    if (name == "concentration.csv") {
      // 10 particles of 1e-9 kg per mm.
      EXPECT_NE(text.find("\n0.01,0.1505,10000,1e-05\n"), std::string::npos) << text.substr(0, 300);
    }
    if (name == "height.csv") {
      EXPECT_NE(text.find("z_m,count,y_05_m"), std::string::npos);
    }
  }
}

TEST(FlowCase, LaterProbesReplaceThoseBeforeARestart) {
  const TestFolder folder;
  // The first run went on to 0.02 with 1000 too much after the checkpoint at 0.01.
  write_in(folder, "postProcessing/axis/0/p", probe_text(0.0, 0.01));
  const std::string first = read_file(folder.path() / "postProcessing/axis/0/p");
  const std::string wrong = probe_text(0.01, 0.02, 1000.0);
  write_in(folder, "postProcessing/axis/0/p", first + wrong.substr(wrong.find("Time\n") + 5));
  write_in(folder, "postProcessing/axis/0.01/p", probe_text(0.01, 0.02));
  const PressureProfile profile = read_pressure(folder.path(), "axis", 1.0, 0.0);
  // Rows that are multiples of both shaking values: probe 0 does not shake.
  EXPECT_NEAR(profile.probes.front().pressure_Pa, kSlope_m_s2 * 0.295 + 5e4 * 0.195, 1e-6 * 5187.0);
  EXPECT_EQ(profile.rows, 200U);
}

TEST(FlowCase, ProbesOutsideTheMeshAndUnfinishedLastLine) {
  const TestFolder folder;
  write_in(
      folder, "postProcessing/axis/0/p",
      "# Probe 0 (0 0 0.2)\n# Probe 1 (0 0 0.25)\n# Probe 2 (0 0 0.3)\n#  Probe 0 1 2\n# Time\n"
      "0.1 200 100 -1e+300\n0.2 220 120 -1e+300\n0.3 240");
  const PressureProfile profile = read_pressure(folder.path(), "axis", 2.0, 0.0);
  ASSERT_EQ(profile.probes.size(), 2U);
  EXPECT_NEAR(profile.probes[0].pressure_Pa, 2.0 * 210.0, 1e-9);
  EXPECT_NEAR(fit_slope(profile, 0.2, 1.0)->slope_Pa_m, 2.0 * 100.0 / 0.05, 1e-6);
  EXPECT_FALSE(fit_slope(profile, 0.21, 1.0));
}

TEST(FlowCase, RefusesDamagedProbes) {
  const TestFolder folder;
  const auto refuse = [&](const std::string& text, const std::string& fragment) {
    write_in(folder, "postProcessing/axis/0/p", text);
    expect_refusal([&] { read_pressure(folder.path(), "axis", 1.0, 0.0); }, {fragment});
  };
  refuse("# Time\n0.1 3\n0.2 4\n", "1 values for 0 probes");
  refuse("# Probe 0 (0 0 0.2)\n0.1 3 4\n0.2 3\n", "2 values for 1 probes");
  refuse("# Probe 0 (0 0 0.2)\n0.1 abc\n", "'abc'");
  refuse("", "no line # Probe");
  expect_refusal([&] { read_pressure(folder.path(), "wall", 1.0, 0.0); }, {"--probes", "axis"});
}

TEST(FlowCase, DensityInAllItsSpellings) {
  POWDERLINK_NEEDS_FOAM();
  for (const char* text :
       {"rho 1.25;", "rho [1 -3 0 0 0 0 0] 1.25;", "nu 1e-5;\nrho rho [1 -3 0 0 0 0 0] 1.25;\n",
        "/* in water:\nrho 998;\n*/ nu 1e-5; rho 1.25;", "rho 998;\nrho 1.25;",
        "gas 1.25; rho $gas;", "\"rh.\" 1.25;", "water { rho 998; } rho 1.25; // rho 3;",
        "rho [kg m^-3] 1.25;"}) {
    const TestFolder folder;
    write_in(folder, "constant/transportProperties", text);
    EXPECT_EQ(gas_density_kg_m3(folder.path(), {}), 1.25) << text;
  }
  const TestFolder folder;
  EXPECT_FALSE(gas_density_kg_m3(folder.path(), {}));
  expect_refusal([&] { gas_density_kg_m3(folder.path(), -1.0); }, {"--density"});
  for (const char* text : {"rho air;", "rho 0;", "rho (1 2);", "rho { a 1; }"}) {
    write_in(folder, "constant/transportProperties", text);
    expect_refusal([&] { gas_density_kg_m3(folder.path(), {}); }, {"rho in ", "above 0"});
  }
}

TEST(FlowCase, TimeStepFromLogThenScriptThenOption) {
  const TestFolder folder;
  expect_refusal([&] { dem_time_step_s(folder.path(), {}); }, {"--dt"});
  folder.write("in.pipe", "variable dt equal 2e-7\ntimestep ${dt}\n");
  expect_refusal([&] { dem_time_step_s(folder.path(), {}); }, {"--dt"});
  folder.write("in.pipe", "timestep 5e-7\n");
  EXPECT_EQ(dem_time_step_s(folder.path(), {}), 5e-7);
  folder.write("log.liggghts", "timestep ${dt}\ntimestep 2e-07\n");
  EXPECT_EQ(dem_time_step_s(folder.path(), {}), 2e-7);
  EXPECT_EQ(dem_time_step_s(folder.path(), 1e-6), 1e-6);
  expect_refusal([&] { dem_time_step_s(folder.path(), 0.0); }, {"--dt"});
  folder.write("log.liggghts", "timestep 2e-07\ntimestep 1e-07\n");
  expect_refusal([&] { dem_time_step_s(folder.path(), {}); }, {"1e-07 s, 2e-07 s"});
}

TEST(FlowCase, NotesWhatIsMissingAndRefusesNothingAtAll) {
  const TestFolder folder;
  expect_refusal([&] { analyse_flow(folder.path(), {}); }, {"neither particles"});
  write_in(folder, "postProcessing/axis/0/p", probe_text(0.0, 0.03));
  expect_refusal([&] { analyse_flow(folder.path(), {}); }, {"--density"});
  FlowOptions options;
  options.density_kg_m3 = kDensity_kg_m3;
  const FlowReport report = analyse_flow(folder.path(), options);
  EXPECT_TRUE(report.slope);
  EXPECT_EQ(report.notes.size(), 3U);  // particles, wall clock, coupling share
  EXPECT_NE(flow_json(report).find("\"solids_flow_kg_s\": null"), std::string::npos);
}

TEST(FlowCase, SaysThatThePipeStillFills) {
  const TestFolder folder;
  for (long step = 0; step < 10; ++step) {
    auto particles = stream_at(0);
    particles.resize(static_cast<std::size_t>(2100 + 100 * step));
    write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, particles));
  }
  FlowOptions options;
  options.time_step_s = 1e-4;
  const FlowReport report = analyse_flow(folder.path(), options);
  ASSERT_FALSE(report.notes.empty());
  bool said = false;
  for (const auto& note : report.notes) said |= note.find("still changes") != std::string::npos;
  EXPECT_TRUE(said);
  options.from_s = 1.0;
  expect_refusal([&] { analyse_flow(folder.path(), options); }, {"--from", "0.0009"});
}

}  // namespace
}  // namespace powderlink::analysis
