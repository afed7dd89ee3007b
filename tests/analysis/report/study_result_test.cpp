// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says of a study whose answer is known by construction, and which LIGGGHTS results it
// takes for its own.
#include "analysis/report/study_result.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/report_words.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// One Gamma is fixed, so the model is the same for every table. Its own diameters, times a factor
/// per row, are the measurements.
std::filesystem::path write_study(const TestFolder& folder, const std::vector<double>& factors) {
  const std::string head = "impact_velocity_m_s,critical_diameter_um,critical_diameter_sigma_um\n";
  const std::string toml =
      "[study]\nname = \"s\"\nexperiment = \"kat_critical_diameter\"\nmeasurements = \"m.csv\"\n"
      "[particle]\nmaterial = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n"
      "[fit]\nadhesive_energy_J_m2 = 10.0\nmodel_discrepancy = 0.0\n";
  std::string any = head;
  for (std::size_t i = 0; i < factors.size(); ++i) any += fmt::format("{},20,1\n", i + 1);
  folder.write("m.csv", any);
  const auto file = folder.write("s.toml", toml);
  const StudyResult model(file, false);
  std::string text = head;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double measured = model.comparison.model[i] / factors[i];
    text += fmt::format("{},{:.9g},{:.9g}\n", i + 1, measured, 0.02 * measured);
  }
  folder.write("m.csv", text);
  return file;
}

TEST(ReportWords, NameWhereTheModelFails) {
  const TestFolder folder;
  // 2 % noise: 10 % too large is 5 sigmas.
  const StudyResult r(write_study(folder, {1.1, 1.1, 1.0, 1.0, 0.9, 0.9}), false);
  const std::vector<std::string> words = fit_words(r);
  ASSERT_EQ(words.size(), 3U);
  EXPECT_NE(words[0].find("At 1 to 2 m/s"), std::string::npos) << words[0];
  EXPECT_NE(words[0].find("too large by 10 %, 5 sigmas"), std::string::npos) << words[0];
  EXPECT_NE(words[1].find("At 3 to 4 m/s"), std::string::npos) << words[1];
  EXPECT_NE(words[1].find(" fits"), std::string::npos) << words[1];
  EXPECT_NE(words[2].find("too small by 10 %, 5 sigmas"), std::string::npos) << words[2];
  EXPECT_NE(headline(r).find("does not describe"), std::string::npos);
}

TEST(ReportWords, SayThatAllIsWell) {
  const TestFolder folder;
  const StudyResult r(write_study(folder, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}), true);
  ASSERT_EQ(fit_words(r).size(), 1U);
  EXPECT_NE(headline(r).find("No effect is missing"), std::string::npos) << headline(r);
}

TEST(DemResults, BelongToTheStudyWithTheSameRowsAndValues) {
  const TestFolder folder;
  StudyResult r(write_study(folder, {1.1, 1.1, 1.0, 1.0, 0.9, 0.9}), false);
  DemFile dem;
  for (const ParameterEstimate& p : r.comparison.fit.parameters)
    dem.parameters.emplace_back(p.name, p.value);
  for (const Observation& o : r.observations.list) {
    dem.velocity_m_s.push_back(o.row.impact_velocity_m_s);
    dem.measured_um.push_back(o.measured);
    dem.model_um.push_back(1.04 * o.measured);
  }
  DemFile other_rows = dem;
  other_rows.measured_um.front() *= 1.01;
  EXPECT_FALSE(r.take(other_rows));
  DemFile fewer = dem;
  fewer.model_um.pop_back();
  EXPECT_FALSE(r.take(fewer));
  DemFile other_values = dem;
  other_values.parameters.front().second *= 1.01;
  EXPECT_FALSE(r.take(other_values));
  ASSERT_TRUE(r.take(dem));
  EXPECT_NEAR(r.dem->rms_relative_error, 0.04, 1e-12);
  EXPECT_NEAR(r.dem->residuals.front(), 2.0, 1e-6);  // 4 % over 2 %
}

TEST(DemResults, AreRefusedWhenTheyAreSomethingElse) {
  const TestFolder folder;
  const auto reduced = folder.write("r.json", R"({"backend":"reduced"})");
  expect_refusal([&] { read_dem_file(reduced); }, {"reduced model"});
  const auto noise = folder.write("n.json", "not JSON");
  expect_refusal([&] { read_dem_file(noise); }, {"n.json"});
}

}  // namespace
}  // namespace powderlink::analysis
