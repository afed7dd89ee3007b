// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/analysis/flow/flow_case.h"
#include "tests/analysis/program/command_line.h"

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

TEST(FlowCommand, WritesTablesFiguresAndTheseNumbersFirst) {
  const TestFolder folder;
  write_stream_case(folder);
  const std::string json = (folder.path() / "flow.json").string();
  const auto result =
      powderlink("flow '" + folder.path().string() + "' --from 0.01 --json " + json);
  ASSERT_EQ(result.status, 0) << result.err;
  const auto found = nlohmann::ordered_json::parse(read_file(json));
  std::vector<std::string> keys;
  for (const auto& [key, value] : found.items()) keys.push_back(key);
  // Scripts that read the first ones stay right; observables add theirs behind.
  ASSERT_GT(keys.size(), kKeys.size());
  keys.resize(kKeys.size());
  EXPECT_EQ(keys, kKeys);
  EXPECT_NEAR(found["solids_flow_kg_s"].get<double>(), kStreamFlow_kg_s, 1e-12);
  EXPECT_EQ(found["particle_count"], kStreamParticles);
  const bool gnuplot = std::system("command -v gnuplot >/dev/null 2>&1") == 0;
  for (const char* name : {"pressure", "solids_flow", "height", "velocity", "width",
                           "concentration", "section_height", "section_radius", "envelope"}) {
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

/// Whatever a run has too little of: numbers and tables, a note for a figure that would be empty, and
/// not a word of gnuplot.
TEST(FlowCommand, FewGrainsOrNoneOrOneDump) {
  struct Run {
    const char* name;
    std::vector<std::size_t> grains;  ///< of each dump
    double apart_m;                   ///< between grains
    const char* probes;               ///< of p; empty: none
  };
  const char* const outside =
      "# Probe 0 (0 0 0.1)\n# Probe 1 (0 0 0.2)\n# Time\n1e-4 -1e300 -1e300\n";
  const char* const one = "# Probe 0 (0 0 0.1)\n# Time\n1e-4 5\n2e-4 6\n";
  const char* const two = "# Probe 0 (0 0 0.1)\n# Probe 1 (0 0 0.2)\n# Time\n1e-4 5 4\n2e-4 6 5\n";
  for (const Run& run : std::vector<Run>{{"one dump", {5}, 1e-3, ""},
                                         {"one grain", {1, 1, 1}, 1e-3, two},
                                         {"no grain", {0, 0}, 1e-3, two},
                                         {"no grain at first", {0, 3}, 1e-3, outside},
                                         {"one dump of no grain", {0}, 1e-3, one},
                                         {"few", {9, 9, 9}, 1e-2, one},
                                         {"all in one slice", {40, 40}, 1e-5, two},
                                         {"enough", {60, 60}, 5e-5, two}}) {
    const TestFolder folder;
    for (std::size_t i = 0; i < run.grains.size(); ++i) {
      std::vector<DumpParticle> particles;
      for (std::size_t k = 0; k < run.grains[i]; ++k) {
        DumpParticle p;
        p.id = static_cast<long>(k) + 1;
        p.z_m = 0.25 + run.apart_m * (static_cast<double>(k) + 0.5);
        p.vz_m_s = 1.0, p.radius_m = 2e-5, p.mass_kg = 1e-9;
        particles.push_back(p);
      }
      write_in(folder, fmt::format("post/particles_{}.dump", 100 * i),
               dump_text(100 * static_cast<long>(i), particles));
    }
    if (*run.probes != '\0') write_in(folder, "postProcessing/p/0/p", run.probes);
    // Another run left figures that would not belong to these tables.
    write_in(folder, "flow/height.svg", "<svg>old</svg>");
    const auto result = powderlink("flow '" + folder.path().string() + "' --dt 1e-6 --density 1.6");
    EXPECT_EQ(result.status, 0) << run.name << result.err;
    for (const char* word : {"gnuplot", "warning", "undefined", "\" line ", "nan"}) {
      EXPECT_EQ(result.err.find(word), std::string::npos) << run.name << ": " << result.err;
      EXPECT_EQ(result.out.find(word), std::string::npos) << run.name << ": " << result.out;
    }
    for (const char* name : {"solids_flow", "height", "velocity", "width", "concentration",
                             "section_height", "section_radius", "envelope"}) {
      const auto base = folder.path() / "flow" / name;
      EXPECT_TRUE(std::filesystem::exists(base.string() + ".csv")) << run.name << name;
      const bool drawn = std::filesystem::exists(base.string() + ".svg");
      const bool said = result.err.find(std::string("no figure ") + name) != std::string::npos ||
                        result.err.find("no figures: gnuplot") != std::string::npos;
      EXPECT_NE(drawn, said) << run.name << ", " << name << ": " << result.err;
      if (drawn) {
        EXPECT_NE(read_file(base.string() + ".svg").find("</svg>"), std::string::npos);
      }
    }
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
