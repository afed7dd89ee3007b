// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

const std::string kDrop = "kat theory --particle 316L --substrate UPVC --velocity 1.40 ";

/// One message on stderr, nothing on stdout, exit status 1.
void fails(const std::string& arguments, const std::vector<std::string>& fragments) {
  const CommandResult r = powderlink(arguments);
  EXPECT_EQ(r.status, 1) << arguments;
  EXPECT_TRUE(r.out.empty()) << r.out;
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  for (const std::string& f : fragments) EXPECT_NE(r.err.find(f), std::string::npos) << r.err;
}

TEST(Commands, HelpAndVersion) {
  EXPECT_EQ(powderlink("--version").status, 0);
  EXPECT_NE(powderlink("--version").out.find("powderlink "), std::string::npos);
  EXPECT_EQ(powderlink("--help").status, 0);
  EXPECT_EQ(powderlink("kat theory --help").status, 0);
  EXPECT_EQ(powderlink("kat run --help").status, 0);
}

TEST(Commands, UsageErrorsAreStatus2) {
  for (const std::string& line :
       {std::string(""), std::string("fly"), std::string("kat"), std::string("kat theory"),
        kDrop + "--diameter 46 --adhesive-energy 3", kDrop + "--diameter big",
        std::string("kat run"), std::string("effects --yaml")}) {
    const CommandResult r = powderlink(line);
    EXPECT_EQ(r.status, 2) << line;
    for (const char* part : {"command line", "given: ", "allowed: ", "to do: "})
      EXPECT_NE(r.err.find(part), std::string::npos) << line << r.err;
  }
}

TEST(Commands, DecimalCommasOnTheLineAreNamed) {
  const CommandResult r = powderlink(kDrop + "--diameter 46,0");
  EXPECT_EQ(r.status, 2);
  EXPECT_NE(r.err.find("46,0"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("decimal point"), std::string::npos) << r.err;
}

TEST(Commands, TheoryPrintsAndStores) {
  const TestFolder folder;
  const std::string file = (folder.path() / "t.json").string();
  const CommandResult r = powderlink(kDrop + "--diameter 46.0 --json " + file);
  EXPECT_EQ(r.status, 0);
  for (const char* f : {"17.18", "17.53", "Tabor", "Eq. 4.5", "Eq. 4.10", "100 us"}) {
    EXPECT_NE(r.out.find(f), std::string::npos) << r.out;
  }
  const auto j = nlohmann::json::parse(read_file(file));
  EXPECT_NEAR(j.at("adhesive_energy_instant_J_m2").get<double>(), 17.175, 1e-3);
  EXPECT_EQ(j.at("thesis").at("printed_J_m2"), 17.53);
}

TEST(Commands, TheoryWarnsAboutTheConvention) {
  const CommandResult r = powderlink(kDrop + "--adhesive-energy 17.175");
  EXPECT_EQ(r.status, 0);
  EXPECT_NE(r.out.find("46"), std::string::npos);
  EXPECT_NE(r.err.find("surface energy"), std::string::npos);
  EXPECT_TRUE(powderlink(kDrop + "--adhesive-energy 0.1").err.empty());
}

TEST(Commands, TheoryRefuses) {
  fails("kat theory --particle steel --substrate UPVC --velocity 1 --diameter 46",
        {"'steel'", "316L"});
  fails("kat theory --particle 316L --substrate UPVC --velocity 0 --diameter 46",
        {"impact velocity", "0 m/s"});
  fails("kat theory --particle 316L --substrate UPVC --velocity -2 --diameter 46", {"-2 m/s"});
  fails(kDrop + "--diameter 46e-6", {"metres", "write 46"});
  fails(kDrop + "--diameter 0", {"0 um"});
  fails(kDrop + "--adhesive-energy 0", {"adhesive energy"});
  fails(kDrop, {"neither"});
}

TEST(Commands, EarlierResultsStay) {
  const TestFolder folder;
  const std::filesystem::path file = folder.write("t.json", "before");
  fails("kat theory --particle steel --substrate UPVC --velocity 1 --diameter 46 --json " +
            file.string(),
        {"steel"});
  EXPECT_EQ(read_file(file), "before");
  fails(kDrop + "--diameter 46 --json " + (folder.path() / "none" / "t.json").string(),
        {"none/t.json"});
}

TEST(Commands, EffectsListTheRegistry) {
  const TestFolder folder;
  const std::string file = (folder.path() / "e.json").string();
  const CommandResult r = powderlink("effects --json " + file);
  EXPECT_EQ(r.status, 0);
  const auto j = nlohmann::json::parse(read_file(file));
  ASSERT_GE(j.at("effects").size(), 5U);
  for (const auto& e : j["effects"]) {
    EXPECT_NE(r.out.find(e.at("name").get<std::string>()), std::string::npos);
    EXPECT_FALSE(e.at("mechanism").get<std::string>().empty());
    EXPECT_FALSE(e.at("signature").get<std::string>().empty());
    for (const auto& p : e.at("parameters")) {
      EXPECT_LT(p.at("lower").get<double>(), p.at("upper").get<double>());
      EXPECT_FALSE(p.at("source").get<std::string>().empty());
      const std::string name = p.at("name");
      if (name == "v_star_m_s") {
        EXPECT_EQ(p.at("unit"), "m/s");
      }
      if (name == "surface_charge_C_m2") {
        EXPECT_EQ(p.at("unit"), "C/m^2");
      }
      if (name == "exponent") {
        EXPECT_EQ(p.at("unit"), "-");
      }
    }
  }
}

TEST(Commands, KatRunRefuses) {
  const TestFolder folder;
  const std::string json = (folder.path() / "kat.json").string();
  const auto study = [&](const std::string& more) {
    return folder
        .write("study.toml",
               "[study]\nexperiment = \"kat_critical_diameter\"\n[particle]\nmaterial = \"316L\"\n"
               "[substrate]\nmaterial = \"UPVC\"\n" +
                   more)
        .string();
  };
  fails("kat run not_there.toml --json " + json, {"not_there.toml"});
  fails("kat run " + study("[kat]\nvelocities_m_s = [0]\n[fit]\nadhesive_energy_J_m2 = 0.1\n"),
        {"line", "0 m/s"});
  fails("kat run " + study("[kat]\nvelocities_m_s = [1]\ntime_step_rayleigh = "
                           "0.7\n[fit]\nadhesive_energy_J_m2 = 0.1\n"),
        {"time_step_rayleigh", "0.5"});
  EXPECT_FALSE(std::filesystem::exists(json));
  fails("kat run " + study("[kat]\nvelocities_m_s = [1]\n[fit]\nadhesive_energy_J_m2 = 0.1\n") +
            " --json " + (folder.path() / "none" / "kat.json").string(),
        {"none/kat.json", "existing folder"});
}

}  // namespace
}  // namespace powderlink::analysis
