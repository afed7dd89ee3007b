// SPDX-License-Identifier: GPL-3.0-or-later
// `powderlink kat analyse` as users call it: contract of its JSON, study, figures, refusals.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/kat/study/study.h"
#include "tests/analysis/kat/retention_sample.h"
#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

namespace fs = std::filesystem;

/// As ImageJ saves it, in pixels of 0.5 um.
std::string image_table(const std::vector<double>& diameters_um) {
  std::string text = " ,Area,Perim.\n";
  for (std::size_t i = 0; i < diameters_um.size(); ++i) {
    const double d = diameters_um[i] / 0.5;
    text += fmt::format("{},{:.0f},{:.3f}\n", i + 1, 0.25 * M_PI * d * d, M_PI * d);
  }
  return text;
}

class KatAnalyse : public testing::Test {
 protected:
  KatAnalyse() { write({46.0, 0.08, 600}, 21); }
  void write(const RetentionTruth& truth, unsigned seed) {
    const RetentionSample s = draw_sample(truth, seed);
    folder.write("before.csv", image_table(s.before_um));
    folder.write("after.csv", image_table(s.after_um));
  }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }
  CommandResult analyse(const std::string& more, const std::string& drop = drop_options()) const {
    return powderlink("kat analyse --before " + file("before.csv") + " --after " +
                      file("after.csv") + " " + drop + " " + more);
  }
  static std::string drop_options() {
    return "--pixel-size-um 0.5 --velocity 1.4 --particle 316L --substrate UPVC";
  }
  /// Status 1, one message of four parts, nothing written.
  void refused(const std::string& more, const std::string& drop,
               const std::vector<std::string>& fragments) const {
    folder.write("old.json", "old");
    const CommandResult r =
        analyse(more + " --json " + file("old.json") + " --study " + file("none.toml"), drop);
    EXPECT_EQ(r.status, 1) << r.out << r.err;
    for (const char* part : {"; given: ", "; allowed: ", "; to do: "})
      EXPECT_NE(r.err.find(part), std::string::npos) << r.err;
    for (const std::string& f : fragments) EXPECT_NE(r.err.find(f), std::string::npos) << r.err;
    EXPECT_EQ(read_file(file("old.json")), "old");
    EXPECT_FALSE(fs::exists(file("none.toml")) || fs::exists(file("none.csv")));
  }
  TestFolder folder;
};

TEST_F(KatAnalyse, WritesTheContract) {
  const CommandResult r = analyse("--contact-time-us 100 --json " + file("kat.json"));
  ASSERT_EQ(r.status, 0) << r.err;
  const auto j = nlohmann::json::parse(read_file(file("kat.json")));
  const auto& d = j.at("critical_diameter_um");
  EXPECT_LE(d.at("low").get<double>(), 46.0);
  EXPECT_GE(d.at("high").get<double>(), 46.0);
  const auto& gamma = j.at("adhesive_energy_J_m2");
  for (const char* name : {"energy", "rebound_time", "finite_stop"}) {
    EXPECT_LE(gamma.at(name).at("low").get<double>(), gamma.at(name).at("value").get<double>());
    EXPECT_NE(r.out.find(j.at("methods").at(0).at("assumption").get<std::string>()),
              std::string::npos);
  }
  EXPECT_FALSE(gamma.contains("deceleration"));
  ASSERT_TRUE(j.at("warnings").is_array());
  EXPECT_NE(r.err.find("the methods disagree"), std::string::npos);
  EXPECT_NE(r.out.find("2 ln L"), std::string::npos);
}

TEST_F(KatAnalyse, DrawsFigures) {
  const CommandResult r = analyse("--out " + file("out"));
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_TRUE(fs::exists(file("out/retained.csv")));
  if (r.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  for (const char* name : {"out/sizes.svg", "out/retained.svg"})
    EXPECT_NE(read_file(file(name)).find("</svg>"), std::string::npos);
}

TEST_F(KatAnalyse, GrowsAStudyThatCompareReads) {
  for (const double velocity : {1.0, 1.4, 2.0, 2.8}) {
    // A slow stop of 100 us: d_c ~ v^-1/2.
    write({46.0 * std::sqrt(1.4 / velocity), 0.05, 800}, 30);
    const CommandResult r =
        analyse("--contact-time-us 100 --study " + file("s.toml"),
                fmt::format("--pixel-size-um 0.5 --velocity {} --particle 316L --substrate UPVC",
                            velocity));
    ASSERT_EQ(r.status, 0) << r.err;
  }
  // A name may hold anything, and becomes a comment of the new study too.
  std::string text = read_file(file("s.toml"));
  const std::string name = "name = \"s\"";
  ASSERT_NE(text.find(name), std::string::npos) << text;
  folder.write("s.toml", text.replace(text.find(name), name.size(), R"(name = "s\n[\"x]")"));
  EXPECT_EQ(powderlink("add " + file("s.toml") + " finite_stop_pulse -o " + file("f.toml")).status,
            0);
  const CommandResult r = powderlink("compare " + file("f.toml") + " --json " + file("c.json"));
  ASSERT_EQ(r.status, 0) << r.err;
  const auto j = nlohmann::json::parse(read_file(file("c.json")));
  EXPECT_EQ(j.at("verdict"), "agrees") << r.out;
  EXPECT_NEAR(j.at("parameters").at("adhesive_energy_J_m2").get<double>(), 0.0825, 0.01);

  const std::string before = read_file(file("s.csv"));
  EXPECT_EQ(analyse("--contact-time-us 100 --study " + file("s.toml"),
                    "--pixel-size-um 0.5 --velocity 2.8 --particle 316L --substrate UPVC")
                .status,
            1);                                               // in it already
  EXPECT_EQ(analyse("--study " + file("s.toml")).status, 1);  // another table
  EXPECT_EQ(analyse("--contact-time-us 100 --study " + file("s.toml"),
                    "--pixel-size-um 0.5 --velocity 5 --particle 316L --substrate "
                    "borosilicate_glass")
                .status,
            1);
  EXPECT_EQ(read_file(file("s.csv")), before);
}

TEST_F(KatAnalyse, MaterialsOfYourOwnGoIntoTheStudyByValue) {
  folder.write("powder.toml",
               "density_kg_m3 = 7980\nyoungs_modulus_Pa = 2.11e11\npoissons_ratio = 0.3\n");
  const auto drop = [](double velocity, const std::string& particle) {
    return fmt::format("--pixel-size-um 0.5 --velocity {} --substrate AlSi10Mg --particle {}",
                       velocity, particle);
  };
  const std::string study = "--study " + file("own.toml");
  const CommandResult first = analyse(study, drop(1.4, file("powder.toml")));
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("powder.toml on AlSi10Mg"), std::string::npos) << first.out;
  EXPECT_EQ(read_study(file("own.toml")).particle.youngs_modulus_Pa, 2.11e11);
  // The same by its name, and by its values; another by its values.
  EXPECT_EQ(analyse(study, drop(1.5, "316L")).status, 0);
  const std::string values = "density_kg_m3=7980,poissons_ratio=0.3,youngs_modulus_Pa=";
  EXPECT_EQ(analyse(study, drop(1.6, values + "2.11e11")).status, 0);
  const CommandResult other = analyse(study, drop(1.7, values + "2.0e11"));
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("2e+11 Pa"), std::string::npos) << other.err;
}

TEST_F(KatAnalyse, AStudyMayHaveAnOddName) {
  const std::string odd = "a\"b\\\n[c].toml";
  ASSERT_EQ(analyse("--study '" + file(odd) + "'").status, 0);
  EXPECT_EQ(read_study(file(odd)).name, "a\"b\\\n[c]");
}

TEST_F(KatAnalyse, RefusesBadInput) {
  refused("", "--pixel-size-um 0.5 --particle 316L --substrate UPVC",
          {"impact velocity", "nothing"});
  refused("", "--pixel-size-um 0.5 --velocity 1.4 --particle wood --substrate UPVC",
          {"'wood'", "316L"});
  refused("", "--velocity 1.4 --particle 316L --substrate UPVC", {"pixel size"});
  refused("--contact-time-us 1e-4", drop_options(), {"contact time", "write 100"});
  refused("--area-ratio 0", drop_options(), {"area after over area before"});
  folder.write("after.csv", " ,Mean\n1,2\n");
  refused("", drop_options(), {"after.csv"});
  const RetentionSample s = draw_sample({46.0, 0.08, 600}, 22);
  folder.write("after.csv", "# pixel_size_um: 0.25\n" + image_table(s.after_um));
  refused("", drop_options(), {"pixel size", "0.25"});
  folder.write("after.csv", image_table(s.before_um));
  refused("", drop_options(), {"nothing left the plate"});
  folder.write("before.csv", image_table(s.after_um));
  refused("", drop_options(), {"exchange --before"});
  folder.write("before.csv", image_table(s.before_um));
  refused("--after " + file("before.csv"), drop_options(), {"in both"});
  refused("--after " + file("./before.csv"), drop_options(), {"in both"});
  fs::create_symlink(file("before.csv"), file("link.csv"));
  refused("--after " + file("link.csv"), drop_options(), {"in both"});
  folder.write("after.png", "not a picture");
  refused("--after " + file("after.png"), drop_options(), {"after.png"});
  folder.write("after.csv", " ,Area,Perim.\n");
  refused("", drop_options(), {"after.csv", "a header without rows"});
}

TEST_F(KatAnalyse, TenThousandGrainsNarrowTheInterval) {
  const auto width = [&](const RetentionTruth& truth) {
    write(truth, 23);
    EXPECT_EQ(analyse("--json " + file("kat.json")).status, 0);
    const auto d = nlohmann::json::parse(read_file(file("kat.json"))).at("critical_diameter_um");
    EXPECT_LT(d.at("low").get<double>(), truth.critical_um);
    EXPECT_GT(d.at("high").get<double>(), truth.critical_um);
    return d.at("high").get<double>() - d.at("low").get<double>();
  };
  // Sixteen times the grains: a quarter of the width, give or take the scatter of one sample.
  constexpr double kScatterOfWidth = 0.4;
  EXPECT_NEAR(4.0 * width({46.0, 0.1, 10000}) / width({46.0, 0.1, 625}), 1.0, kScatterOfWidth);
}

}  // namespace
}  // namespace powderlink::analysis
