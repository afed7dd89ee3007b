// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of retained shares from tables of grains: Gamma and scatter come back, cells are checked.
#include "analysis/kat/experiment/grain_drops.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/evidence/comparison.h"
#include "analysis/kat/study/study.h"
#include "physics/kat/kat_theory.h"
#include "tests/analysis/kat/retention_sample.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr double kVelocity = 2.0;
constexpr double kWidth = 0.15;

std::string table_of(const std::vector<double>& diameters_um) {
  std::string text = " ,Area,Perim.\n";
  for (std::size_t i = 0; i < diameters_um.size(); ++i) {
    const double d = diameters_um[i];
    text += fmt::format("{},{:.4f},{:.4f}\n", i + 1, 0.25 * M_PI * d * d, M_PI * d);
  }
  return text;
}

void write_drop(const TestFolder& folder, double area_ratio) {
  RetentionTruth t{46.0, kWidth, 3000};
  t.area_ratio = area_ratio;
  const RetentionSample s = draw_sample(t, 41);
  const auto half = s.before_um.begin() + 1500;
  folder.write("b1.csv", table_of({s.before_um.begin(), half}));
  folder.write("b2.csv", table_of({half, s.before_um.end()}));
  folder.write("a1.csv", table_of(s.after_um));
}

const std::string kHeader = "impact_velocity_m_s,before_files,after_files,pixel_size_um";

std::string study_text() {
  return "[study]\nexperiment = \"kat_retention\"\nmeasurements = \"drops.csv\"\n[particle]\n"
         "material = \"316L\"\n[substrate]\nmaterial = \"borosilicate_glass\"\n[model]\n"
         "effects = [\"adhesion_scatter\"]\n[effect.adhesion_scatter]\nlog_std = [0.01, 1.0]\n"
         "[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";
}

TEST(GrainDrops, AStudyFindsGammaAndScatter) {
  const TestFolder folder;
  write_drop(folder, 0.7);
  folder.write("drops.csv", kHeader + "\n2.0,b?.csv,a1.csv,1\n");
  const Study s = read_study(folder.write("s.toml", study_text()));
  ASSERT_GT(s.rows.size(), 15U);
  EXPECT_NEAR(*s.rows[0].area_ratio, 0.7, 0.05);
  const Comparison c = compare(s, observe(s));
  const double gamma = physics::adhesive_energy_instant_J_m2(
      physics::effective_youngs_modulus_Pa(s.particle, s.substrate), s.particle.density_kg_m3,
      kVelocity, 46e-6);
  // d_c of 3 000 grains to about 1 %; Gamma ~ d_c, so that the width is that of ln Gamma.
  EXPECT_NEAR(c.fit.find("adhesive_energy_J_m2")->value / gamma, 1.0, 0.04);
  EXPECT_NEAR(c.fit.find("log_std")->value / kWidth, 1.0, 0.25);
  EXPECT_LT(c.fit.chi2_per_dof(), 2.0);
}

TEST(GrainDrops, ClassesAndAreasMayBeGiven) {
  const TestFolder folder;
  write_drop(folder, 1.0);
  const auto rows = [&](const std::string& width) {
    return read_measurements(
               folder.write("drops.csv", kHeader +
                                             ",area_ratio,class_width_percent,who\n2.0,b1.csv;"
                                             "b2.csv,a1.csv,1,1.0," +
                                             width + ",me\n"))
        .rows;
  };
  EXPECT_GT(rows("5").size(), rows("20").size());
  EXPECT_EQ(rows("20")[0].area_ratio, 1.0);
  double before = 0.0;
  for (const KatRow& r : rows("20")) before += *r.count_before;
  EXPECT_EQ(before, 3000.0);
}

TEST(GrainDrops, CellsThatCannotBe) {
  const TestFolder folder;
  write_drop(folder, 1.0);
  const auto read = [&](const std::string& text) {
    return [&folder, text] { read_measurements(folder.write("drops.csv", text)); };
  };
  expect_refusal(read("impact_velocity_m_s,before_files\n2,b1.csv\n"), {"after_files"});
  expect_refusal(read(kHeader + "\n2,none*.csv,a1.csv,1\n"), {"none*.csv"});
  expect_refusal(read(kHeader + "\n0,b1.csv,a1.csv,1\n"), {"line 2", "0 m/s"});
  expect_refusal(read(kHeader + "\n2,b1.csv,b1.csv,1\n"), {"in both"});
  folder.write("b1.WEBP", "");
  expect_refusal(read(kHeader + "\n2,b1.WEBP,a1.csv,1\n"),
                 {"b1.WEBP, a picture", "powderlink psd"});
  expect_refusal(read(kHeader + ",class_width_percent\n2,b1.csv,a1.csv,1,90\n"),
                 {"class_width_percent", "1 to 50"});
}

}  // namespace
}  // namespace powderlink::analysis
