// SPDX-License-Identifier: GPL-3.0-or-later
// compare, diagnose and add as users call them; keys of the JSON are a contract.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

const std::string kZafar = POWDERLINK_CASES "/zafar2014/study.toml";

/// The answer that belongs to one of the sets of kat_cases/hidden_effects.
struct HiddenSet {
  const char* name;
  const char* verdict;
  const char* best;  ///< empty: null
};

class HiddenSets : public ::testing::TestWithParam<HiddenSet> {};

TEST_P(HiddenSets, AreAnswered) {
  const HiddenSet& set = GetParam();
  const TestFolder folder;
  const std::string json = (folder.path() / "d.json").string();
  const CommandResult r = powderlink(std::string("diagnose " POWDERLINK_CASES "/hidden_effects/") +
                                     set.name + ".toml --json " + json);
  ASSERT_EQ(r.status, 0) << r.err;
  const auto j = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(j.at("verdict"), set.verdict);
  if (*set.best == '\0') {
    EXPECT_TRUE(j.at("best").is_null());
  } else {
    EXPECT_EQ(j.at("best"), set.best);
    EXPECT_EQ(j.at("ranking").at(0).at("effect"), set.best);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, HiddenSets,
    ::testing::Values(HiddenSet{"t1", "missing_effect", "finite_stop_pulse"},
                      HiddenSet{"t2", "missing_effect", "rate_dependent_adhesion"},
                      HiddenSet{"t3", "no_missing_effect", ""},
                      HiddenSet{"t4", "missing_effect", "electrostatic_image_force"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(EvidenceCommands, DiagnoseWritesTheContract) {
  const TestFolder folder;
  const std::string json = (folder.path() / "d.json").string();
  const CommandResult r = powderlink("diagnose " + kZafar + " --json " + json);
  ASSERT_EQ(r.status, 0) << r.err;
  const auto j = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(j.at("verdict"), "ambiguous");
  EXPECT_EQ(j.at("best"), "finite_stop_pulse");
  EXPECT_NEAR(j.at("baseline").at("rms_relative_error").get<double>(), 0.333, 0.002);
  bool none = false;
  for (const auto& c : j.at("ranking")) {
    none = none || c.at("effect") == "none";
    for (const char* key : {"parameters", "rms_relative_error", "chi2_per_dof", "delta_bic",
                            "loo_rms_relative_error", "plausible", "why"}) {
      EXPECT_TRUE(c.contains(key)) << key;
    }
  }
  EXPECT_TRUE(none);
  EXPECT_FALSE(j.at("next_measurement").get<std::string>().empty());
  for (const char* words : {"finite_stop_pulse", "psd_cutoff", "IMPLAUSIBLE", "next measurement"})
    EXPECT_NE(r.out.find(words), std::string::npos) << words;
}

TEST(EvidenceCommands, CompareWritesTheContract) {
  const TestFolder folder;
  const std::string json = (folder.path() / "c.json").string();
  const CommandResult r = powderlink("compare " + kZafar + " --json " + json);
  ASSERT_EQ(r.status, 0) << r.err;
  const auto j = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(j.at("verdict"), "fails");
  EXPECT_NEAR(j.at("rms_relative_error").get<double>(), 0.333, 0.002);
  ASSERT_EQ(j.at("points").size(), 7U);
  EXPECT_EQ(j.at("points").at(0).at("measured"), 66.4);
  for (const char* key : {"model", "residual_sigma", "impact_velocity_m_s"})
    EXPECT_TRUE(j.at("points").at(0).contains(key)) << key;
  EXPECT_LT(j.at("trends").at(0).at("p_value").get<double>(), 1e-3);
  EXPECT_LT(j.at("intervals").at("adhesive_energy_J_m2").at("low"),
            j.at("parameters").at("adhesive_energy_J_m2"));
}

TEST(EvidenceCommands, AddMakesAStudyWithAFallenError) {
  const TestFolder folder;
  const std::string study = (folder.path() / "with_stop.toml").string();
  const std::string script = (folder.path() / "in.kat").string();
  const CommandResult added =
      powderlink("add " + kZafar + " finite_stop_pulse -o " + study + " --script " + script);
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_NE(read_file(script).find("stop halfsine 0.0001"), std::string::npos);
  const std::string json = (folder.path() / "c.json").string();
  ASSERT_EQ(powderlink("compare " + study + " --json " + json).status, 0);
  const auto j = nlohmann::json::parse(read_file(json));
  EXPECT_LT(j.at("rms_relative_error").get<double>(), 0.333 / 4);
  // Once more finds it there.
  const CommandResult again = powderlink("add " + study + " finite_stop_pulse -o " + study + "2");
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("has not yet"), std::string::npos) << again.err;
  const CommandResult itself = powderlink("add " + study + " psd_cutoff -o " + study);
  EXPECT_EQ(itself.status, 1);
  EXPECT_NE(itself.err.find("another file"), std::string::npos) << itself.err;
}

TEST(EvidenceCommands, AddTakesTwoEffects) {
  const TestFolder folder;
  const std::string study = (folder.path() / "pair.toml").string();
  const CommandResult r = powderlink("add " + kZafar + " finite_stop_pulse+psd_cutoff -o " + study);
  ASSERT_EQ(r.status, 0) << r.err;
  const std::string text = read_file(study);
  EXPECT_NE(text.find("[effect.finite_stop_pulse]"), std::string::npos) << text;
  EXPECT_NE(text.find("[effect.psd_cutoff]"), std::string::npos) << text;
  const CommandResult three = powderlink(
      "add " + kZafar + " finite_stop_pulse+psd_cutoff+surface_roughness -o " + study + "3");
  EXPECT_EQ(three.status, 1);
  EXPECT_NE(three.err.find("two as a+b"), std::string::npos) << three.err;
}

TEST(EvidenceCommands, DiagnoseSaysHowToAddBothOfTwoEffects) {
  // Flat at low v, as a cut-off makes it, and less steep than any single effect at high v.
  const TestFolder folder;
  std::string csv = "impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n";
  for (const double v : {1.0, 1.4, 1.9, 2.5, 3.2, 4.0, 4.9, 5.9}) {
    const double d = 60.0 / std::pow(1.0 + std::pow(v / 2.0, 6.4), 0.125);
    csv += std::to_string(v) + "," + std::to_string(d) + "," + std::to_string(0.01 * d) + "\n";
  }
  folder.write("drop.csv", csv);
  const auto study = folder.write(
      "study.toml",
      "[study]\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"drop.csv\"\n"
      "[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n"
      "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n");
  const std::string json = (folder.path() / "d.json").string();
  const CommandResult r = powderlink("diagnose " + study.string() + " --json " + json);
  ASSERT_EQ(r.status, 0) << r.err;
  const std::string best = nlohmann::json::parse(read_file(json)).at("best");
  ASSERT_NE(best.find('+'), std::string::npos) << best;
  EXPECT_NE(r.out.find("powderlink add " + study.string() + " " + best + " -o "), std::string::npos)
      << r.out;
}

TEST(EvidenceCommands, EveryQuantityHasItsOwnUnit) {
  const TestFolder folder;
  folder.write("drops.csv", "impact_velocity_m_s,critical_diameter_um\n1,91\n2,38\n3,24\n4,17\n");
  folder.write("speeds.csv",
               "impact_velocity_m_s,diameter_um,residual_velocity_m_s,residual_velocity_sigma_m_s\n"
               "2,80,1.9,0.02\n2,60,1.9,0.02\n");
  folder.write("counts.csv",
               "impact_velocity_m_s,diameter_um,count_before,count_after\n2,30,50,10\n2,60,50,2\n");
  const auto compared = [&](const std::string& tables) {
    const auto study = folder.write(
        "study.toml", "[study]\nexperiment = \"kat_retention\"\nmeasurements = " + tables +
                          "\n[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = "
                          "\"borosilicate_glass\"\n[fit]\nadhesive_energy_J_m2 = 90.0\n");
    const std::string json = (folder.path() / "c.json").string();
    const CommandResult r = powderlink("compare " + study.string() + " --json " + json);
    EXPECT_EQ(r.status, 0) << r.err;
    return std::make_pair(r.out, nlohmann::json::parse(read_file(json)));
  };
  const auto [text, j] = compared("[\"drops.csv\", \"speeds.csv\", \"counts.csv\"]");
  for (const char* words :
       {"rms relative error of critical diameters ", " %, rms error of retained shares 0.",
        "rms error of residual speeds 0.", " m/s, chi^2/dof", "grains of 30 um (share 0.2)",
        "grains of 80 um (1.9 m/s)", "critical diameter [um]", "residual speed [m/s]",
        "critical diameters of drops.csv: no sigma in the table"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
  // Each by itself, from the points.
  double squares[3] = {};
  for (const auto& p : j.at("points")) {
    const double off = p.at("model").get<double>() - p.at("measured").get<double>();
    if (p.contains("sigma_relative"))
      squares[0] += std::pow(off / p.at("measured").get<double>(), 2);
    if (p.contains("sigma_m_s")) squares[1] += off * off;
    if (p.contains("sigma_share")) squares[2] += off * off;
  }
  constexpr double rounding = 1e-9;
  EXPECT_NEAR(j.at("rms_relative_error").get<double>(), std::sqrt(squares[0] / 4.0), rounding);
  EXPECT_NEAR(j.at("rms_speed_error_m_s").get<double>(), std::sqrt(squares[1] / 2.0), rounding);
  EXPECT_NEAR(j.at("rms_share_error").get<double>(), std::sqrt(squares[2] / 2.0), rounding);
  const auto [shares, only] = compared("[\"counts.csv\"]");
  EXPECT_TRUE(only.at("rms_relative_error").is_null());
  EXPECT_EQ(shares.find("relative"), std::string::npos) << shares;
}

TEST(EvidenceCommands, BadInputIsToldPlainly) {
  const TestFolder folder;
  const auto study = [&](const std::string& csv) {
    folder.write("drop.csv", csv);
    return folder
        .write("study.toml",
               "[study]\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"drop.csv\"\n"
               "[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"UPVC\"\n"
               "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n")
        .string();
  };
  const std::string head = "impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n";
  const struct {
    std::string csv;
    std::vector<std::string> words;
  } cases[] = {
      {head + "1,60,2\n2,30,1\n", {"2 rows", "at least 4"}},
      {head + "2,60,2\n2,61,2\n2,59,2\n2,60,2\n", {"2 to 2 m/s"}},
      {head + "1,60,0\n2,30,1\n3,20,1\n4,15,1\n", {"line 2", "standard deviation", "0 um"}},
      {head + "1,nan,2\n2,30,1\n3,20,1\n4,15,1\n", {"line 2", "nan", "finite number"}},
      {head + "1,-60,2\n2,30,1\n3,20,1\n4,15,1\n", {"line 2", "-60 um"}},
      {head + "1,60e-6,2e-6\n2,30e-6,1e-6\n3,20e-6,1e-6\n4,15e-6,1e-6\n",
       {"micrometres are meant", "write 60"}},
      {head + "1,60e6,2e6\n2,30e6,1e6\n3,20e6,1e6\n4,15e6,1e6\n",
       {"micrometres are meant", "write 60"}},
      {head + "1,60,2e-6\n2,30,1e-6\n3,20,1e-6\n4,15,1e-6\n", {"line 2", "were metres given"}},
      {head + "1,60,2000\n2,30,1000\n3,20,1000\n4,15,1000\n", {"line 2", "2000 um of 60 um"}},
      {"v,d\n1,60\n2,30\n", {"columns v, d", "rename"}}};
  for (const auto& c : cases) {
    const CommandResult r = powderlink("diagnose " + study(c.csv));
    EXPECT_EQ(r.status, 1) << c.csv;
    for (const std::string& w : c.words) EXPECT_NE(r.err.find(w), std::string::npos) << r.err;
  }
}

}  // namespace
}  // namespace powderlink::analysis
