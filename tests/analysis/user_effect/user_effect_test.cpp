// SPDX-License-Identifier: GPL-3.0-or-later
// A user adds an effect by one header and one line: on data that hide it, the ordinary program finds
// nothing, and the one with the line names it and its error falls to the noise.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/evidence/diagnosis.h"
#include "physics/effects/effect_registry.h"
#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

constexpr double kNoise = 0.02;

/// Measurements by closed forms of the film written here once more: Gamma ~ v^(6/5) R.
std::string drops() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::string csv = "impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n";
  for (double v = 1.0; v < 6.0; v *= 1.17) {
    double low = 1e-6;
    double high = 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double r = std::sqrt(low * high);
      const double gamma = 40.0 * (1.0 + 0.45 / (1.0 + std::pow(r / 14e-6, 20.0)));
      const double largest = 0.5e-6 * gamma / std::pow(v, 1.2);  // of an instant stop, to a factor
      (largest > r ? low : high) = r;
    }
    const double d = 2e6 * std::sqrt(low * high) * (1.0 + kNoise * normal(random));
    csv += fmt::format("{:.4g},{:.4f},{:.4f}\n", v, d, kNoise * d);
  }
  return csv;
}

const char* kStudy =
    "[study]\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"drops.csv\"\n"
    "[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n"
    "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";

TEST(UserEffect, IsInTheListAfterOneLine) {
  EXPECT_EQ(physics::find_effect("breaking_film").info->parameters.size(), 2U);
  EXPECT_NO_THROW(physics::find_effect("finite_stop_pulse")) << "beside all others";
}

TEST(UserEffect, IsNamedAndTheErrorFalls) {
  const TestFolder folder;
  folder.write("drops.csv", drops());
  const auto file = folder.write("study.toml", kStudy);
  const Study study = read_study(file);
  const Observations observations = observe(study);
  const Diagnosis d = diagnose(study, observations);
  EXPECT_EQ(d.best, "breaking_film");
  EXPECT_EQ(d.ranking.front().name, "breaking_film");
  EXPECT_LT(rms_relative_error(d.get("breaking_film").rms), 1.5 * kNoise);
  EXPECT_GT(rms_relative_error(d.baseline().rms),
            3.0 * rms_relative_error(d.get("breaking_film").rms));
  EXPECT_NEAR(d.get("breaking_film").find("breaking_radius_m")->value / 14e-6, 1.0, 0.1);

  // The ordinary program does not know it and claims nothing.
  const std::string json = (folder.path() / "d.json").string();
  ASSERT_EQ(powderlink("diagnose " + file.string() + " --json " + json).status, 0);
  const auto j = nlohmann::json::parse(read_file(json));
  EXPECT_TRUE(j.at("verdict") == "unexplained" || j.at("verdict") == "ambiguous")
      << j.at("verdict");
}

}  // namespace
}  // namespace powderlink::analysis
