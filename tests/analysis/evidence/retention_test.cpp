// SPDX-License-Identifier: GPL-3.0-or-later
// Retained shares and residual speeds as measurements: values come back, scatter is seen, tables combine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/evidence/comparison.h"
#include "analysis/evidence/diagnosis.h"
#include "analysis/kat/reduced/critical_diameter.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr double kEnergy = 90.0;
constexpr double kVelocity = 2.0;

std::string study_text(const std::string& measurements, const std::string& experiment) {
  return "[study]\nexperiment = \"" + experiment + "\"\nmeasurements = " + measurements +
         "\n[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n"
         "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";
}

double steel_critical_um(double energy, double velocity = kVelocity) {
  const TestFolder folder;
  folder.write("d.csv", "impact_velocity_m_s,critical_diameter_um\n1,60\n");
  const Study s =
      read_study(folder.write("s.toml", study_text("\"d.csv\"", "kat_critical_diameter")));
  return predicted_diameter_um(s, {{}, energy}, KatRow{velocity});
}

/// Counts of a drop in which ln Gamma of every grain is drawn; d_c ~ Gamma for an instant stop.
std::string counts(double scatter, int grains) {
  const double critical = steel_critical_um(kEnergy);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::string csv =
      "impact_velocity_m_s,diameter_um,diameter_low_um,diameter_high_um,count_before,count_after\n";
  for (double low = 20.0; low < 200.0; low *= 1.2) {
    int stayed = 0;
    for (int i = 0; i < grains; ++i) {
      const double d = low * std::pow(1.2, uniform(random));
      stayed += d < critical * std::exp(scatter * normal(random)) ? 1 : 0;
    }
    csv += fmt::format("{},{:.2f},{:.2f},{:.2f},{},{}\n", kVelocity, low * 1.1, low, low * 1.2,
                       grains, stayed);
  }
  return csv;
}

Study retention_study(const TestFolder& folder, double scatter) {
  folder.write("counts.csv", counts(scatter, 150));
  return read_study(folder.write("study.toml", study_text("\"counts.csv\"", "kat_retention")));
}

TEST(Retention, TheEnergyIsThatOfTheHalfPoint) {
  const TestFolder folder;
  const Study s = retention_study(folder, 0.0);
  const Comparison c = compare(s, observe(s));
  // The half point lies within one class; 150 grains place it to about a tenth of that.
  EXPECT_NEAR(c.fit.find("adhesive_energy_J_m2")->value / kEnergy, 1.0, 0.05);
  EXPECT_NE(c.verdict, Comparison::Verdict::fails);
}

TEST(Retention, ScatterIsNamedAndMeasured) {
  const TestFolder folder;
  constexpr double scatter = 0.4;
  const Study s = retention_study(folder, scatter);
  const Diagnosis d = diagnose(s, observe(s));
  EXPECT_EQ(d.verdict, Verdict::missing_effect);
  EXPECT_EQ(d.best, "adhesion_scatter");
  // 11 classes of 150 grains, of which about five tell: 5 % each.
  EXPECT_NEAR(d.get("adhesion_scatter").find("log_std")->value / scatter, 1.0, 0.15);
  EXPECT_NEAR(d.get("adhesion_scatter").find("adhesive_energy_J_m2")->value / kEnergy, 1.0, 0.1);
}

TEST(Retention, WithoutScatterNothingIsMissing) {
  const TestFolder folder;
  const Study s = retention_study(folder, 0.0);
  EXPECT_EQ(diagnose(s, observe(s)).verdict, Verdict::no_missing_effect);
}

TEST(Retention, DevianceOfAShare) {
  Observation o;
  o.row.count_before = 10.0;
  o.row.count_after = 5.0;
  o.row.diameter_um = 50.0;
  o.measured = 0.5;
  EXPECT_EQ(residual(o, 0.5), 0.0);
  const double deviance = 2.0 * (5 * std::log(5 / 8.0) + 5 * std::log(5 / 2.0));
  EXPECT_NEAR(residual(o, 0.8), std::sqrt(deviance), 1e-12);
  EXPECT_NEAR(residual(o, 0.2), -std::sqrt(deviance), 1e-12);
}

TEST(ResidualSpeed, GivesTheEnergyBack) {
  // v_res^2 = v^2 (1 - (d_c/d)^(5/3)) after an instant stop.
  const double critical = steel_critical_um(kEnergy);
  std::string csv = "impact_velocity_m_s,diameter_um,residual_velocity_m_s\n";
  for (const double ratio : {1.05, 1.2, 1.5, 2.0}) {
    csv += fmt::format("{},{:.4f},{:.6f}\n", kVelocity, ratio * critical,
                       kVelocity * std::sqrt(1.0 - std::pow(ratio, -5.0 / 3.0)));
  }
  const TestFolder folder;
  folder.write("speeds.csv", csv);
  const Study s =
      read_study(folder.write("study.toml", study_text("\"speeds.csv\"", "kat_critical_diameter")));
  const Comparison c = compare(s, observe(s));
  EXPECT_NEAR(c.fit.find("adhesive_energy_J_m2")->value / kEnergy, 1.0, 2e-3);
}

TEST(Tables, MayBeCombined) {
  const TestFolder folder;
  folder.write("counts.csv", counts(0.0, 150));
  std::string drops = "impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n";
  for (const double v : {1.5, 2.0, 3.0, 4.0}) {
    const double d = steel_critical_um(kEnergy, v);
    drops += fmt::format("{},{:.4f},{:.4f}\n", v, d, 0.02 * d);
  }
  folder.write("drops.csv", drops);
  const Study s = read_study(
      folder.write("study.toml", study_text("[\"drops.csv\", \"counts.csv\"]", "kat_retention")));
  EXPECT_GT(s.rows.size(), 12U);
  const Comparison c = compare(s, observe(s));
  EXPECT_NEAR(c.fit.find("adhesive_energy_J_m2")->value / kEnergy, 1.0, 0.03);
}

TEST(Tables, AreOfTheExperimentThatTheStudyNames) {
  const TestFolder folder;
  folder.write("counts.csv",
               "impact_velocity_m_s,diameter_um,count_before,count_after\n2,50,9,4\n");
  folder.write("drops.csv", "impact_velocity_m_s,critical_diameter_um\n2,50\n");
  const auto read = [&](const std::string& tables, const std::string& experiment) {
    return read_study(folder.write("s.toml", study_text(tables, experiment))).rows.size();
  };
  const std::string both = "[\"drops.csv\", \"counts.csv\"]";
  EXPECT_EQ(read(both, "kat_retention"), 2U);
  EXPECT_EQ(read("\"drops.csv\"", "kat_critical_diameter"), 1U);
  expect_refusal([&] { read(both, "kat_critical_diameter"); },
                 {"experiment", "counts.csv", "write \"kat_retention\""});
  expect_refusal([&] { read("\"drops.csv\"", "kat_retention"); },
                 {"experiment", "count_before", "write \"kat_critical_diameter\""});
}

TEST(Tables, BadCountsAreRefused) {
  const std::string head = "impact_velocity_m_s,diameter_um,count_before,count_after\n";
  const struct {
    std::string row;
    std::vector<std::string> words;
  } cases[] = {{"2,50,10,11\n", {"10 before, 11 after"}},
               {"2,50,0,0\n", {"0 before"}},
               {"2,50,10,0.5\n", {"whole number"}},
               {"2,-5,10,5\n", {"-5 um"}}};
  for (const auto& c : cases) {
    const TestFolder folder;
    folder.write("c.csv", head + c.row);
    expect_refusal(
        [&] { read_study(folder.write("s.toml", study_text("\"c.csv\"", "kat_retention"))); },
        c.words);
  }
}

/// Speeds have a kink where grains begin to leave, so that chi^2 has many valleys. An effect that can
/// be switched off is never worse than none but for the parameters that BIC counts.
TEST(ResidualSpeeds, AnEffectThatDoesNothingIsNotWorseThanNone) {
  std::string csv =
      "impact_velocity_m_s,diameter_um,residual_velocity_m_s,residual_velocity_sigma_m_s\n";
  // d_c falls with the first power of v, and the speeds scatter.
  constexpr double d_um[] = {88.2, 100.8, 126.0, 168.0, 218.4};  // at 1 m/s
  constexpr double velocity[] = {1.0, 1.4, 2.2};
  constexpr double speed[3][5] = {{0.29342, 0.47350, 0.69986, 0.81155, 0.87393},
                                  {0.37185, 0.74363, 0.95480, 1.12110, 1.27335},
                                  {0.62626, 1.06474, 1.49718, 1.86822, 1.94472}};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 5; ++i) {
      csv += fmt::format("{},{:.3f},{:.5f},{:.4f}\n", velocity[k], d_um[i] / velocity[k],
                         speed[k][i], 0.02 * velocity[k]);
    }
  }
  const TestFolder folder;
  folder.write("speeds.csv", csv);
  const Study s =
      read_study(folder.write("study.toml", study_text("\"speeds.csv\"", "kat_critical_diameter")));
  const Observations o = observe(s);
  const Candidate none = fit_candidate(s, o, {});
  for (const char* name : {"psd_cutoff", "electrostatic_image_force"}) {
    const Candidate c = fit_candidate(s, o, {name}, {&none});
    EXPECT_LE(c.bic, none.bic + c.fitted() * std::log(15.0)) << name;
  }
}

}  // namespace
}  // namespace powderlink::analysis
