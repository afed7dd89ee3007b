// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/analysis/command_line.h"
#include "tests/analysis/flow_case.h"

namespace powderlink::analysis {
namespace {

const std::vector<std::string> kKeys{"pressure_slope_Pa_m",
                                     "solids_flow_kg_s",
                                     "solids_flow_rms_percent",
                                     "window_s",
                                     "particle_velocity_mean_m_s",
                                     "particle_velocity_std_m_s",
                                     "particle_count",
                                     "coupling_share_percent",
                                     "wall_s_per_simulated_ms"};

TEST(FlowCommand, WritesTablesFiguresAndExactlyTheseNumbers) {
  const TestFolder folder;
  write_stream_case(folder);
  const std::string json = (folder.path() / "flow.json").string();
  const auto result =
      powderlink("flow '" + folder.path().string() + "' --from 0.01 --json " + json);
  ASSERT_EQ(result.status, 0) << result.err;
  const auto found = nlohmann::ordered_json::parse(read_file(json));
  std::vector<std::string> keys;
  for (const auto& [key, value] : found.items()) keys.push_back(key);
  EXPECT_EQ(keys, kKeys);
  EXPECT_NEAR(found["solids_flow_kg_s"].get<double>(), kStreamFlow_kg_s, 1e-12);
  EXPECT_EQ(found["particle_count"], kStreamParticles);
  const bool gnuplot = std::system("command -v gnuplot >/dev/null 2>&1") == 0;
  for (const char* name :
       {"pressure", "solids_flow", "height", "velocity", "width", "concentration"}) {
    const auto base = folder.path() / "flow" / name;
    EXPECT_TRUE(std::filesystem::exists(base.string() + ".csv")) << name;
    if (gnuplot) {
      const std::string svg = read_file(base.string() + ".svg");
      EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
      // A curve, points or an image, not just axes.
      EXPECT_GT(svg.size(), 5000U) << name;
    }
  }
  // Nothing half-made is left.
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "flow")) {
    EXPECT_NE(entry.path().filename().string()[0], '.');
  }
}

TEST(FlowCommand, NullWithANoteForWhatIsMissing) {
  const TestFolder folder;
  write_in(folder, "post/particles_0.dump", dump_text(0, stream_at(0)));
  const std::string json = (folder.path() / "flow.json").string();
  const auto result =
      powderlink("flow '" + folder.path().string() + "' --dt 1e-6 --no-figures --json " + json);
  ASSERT_EQ(result.status, 0) << result.err;
  const auto found = nlohmann::json::parse(read_file(json));
  for (const char* key : {"pressure_slope_Pa_m", "solids_flow_rms_percent",
                          "coupling_share_percent", "wall_s_per_simulated_ms"}) {
    EXPECT_TRUE(found[key].is_null()) << key;
  }
  for (const char* note : {"no pressure", "no RMS", "no wall clock", "no coupling share"}) {
    EXPECT_NE(result.err.find(note), std::string::npos) << note;
  }
}

TEST(FlowCommand, RefusesInOneLine) {
  const TestFolder folder;
  const auto result = powderlink("flow '" + folder.path().string() + "/none'");
  EXPECT_EQ(result.status, 1);
  for (const char* part : {"; given: ", "; allowed: ", "; to do: "}) {
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
  }
  EXPECT_EQ(powderlink("flow").status, 2);
  EXPECT_EQ(powderlink("restart '" + folder.path().string() + "'").status, 1);
}

}  // namespace
}  // namespace powderlink::analysis
