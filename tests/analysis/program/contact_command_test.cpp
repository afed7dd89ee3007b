// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/analysis/program/command_line.h"

namespace powderlink::analysis {
namespace {

const std::string kGrain = "contact --particle 316L --substrate 316L --diameter 66.9 --velocity 1 ";

TEST(ContactCommand, AlphaBesideRestitution) {
  const CommandResult r = powderlink("contact --alpha 0.12");
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_NE(r.out.find("coefficientRestitution 0.8446"), std::string::npos) << r.out;
  EXPECT_NE(powderlink("contact --restitution 0.9").out.find("alpha 0.07495"), std::string::npos);
}

TEST(ContactCommand, PrintsAndStoresWhatALoweredModulusChanges) {
  const TestFolder folder;
  const std::string file = (folder.path() / "c.json").string();
  const CommandResult r = powderlink(
      kGrain + "--alpha 0.12 --softened-modulus 2.11e7 --adhesive-energy 0.1 --json " + file);
  EXPECT_EQ(r.status, 0) << r.err;
  for (const char* f :
       {"softened/real", "Rayleigh time", "greatest overlap", "pull-off", "39.81 times"}) {
    EXPECT_NE(r.out.find(f), std::string::npos) << r.out;
  }
  const auto j = nlohmann::json::parse(read_file(file));
  EXPECT_NEAR(j.at("restitution").get<double>(), 0.8446, 5e-5);
  // Undamped it is 4.7 % deep.
  EXPECT_NEAR(j.at("softened").at("greatest_overlap_percent").get<double>(), 4.4, 0.1);
  EXPECT_NEAR(j.at("change").at("time_step_factor").get<double>(), 100.0, 1e-9);
  EXPECT_EQ(j.at("substrate"), "316L");
}

TEST(ContactCommand, WithoutALoweredModulusOneColumn) {
  const TestFolder folder;
  const std::string file = (folder.path() / "c.json").string();
  const CommandResult r =
      powderlink("contact --particle 316L --diameter 66.9 --velocity 1 --json " + file);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.out.find("softened"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("against its like"), std::string::npos) << r.out;
  const auto j = nlohmann::json::parse(read_file(file));
  EXPECT_FALSE(j.contains("softened"));
  EXPECT_TRUE(j.at("substrate").is_null());
}

TEST(ContactCommand, Refuses) {
  expect_four_parts(powderlink("contact"), "--alpha 0.12");
  expect_four_parts(powderlink("contact --alpha 0.12 --restitution 0.9"), "0.8446");
  expect_four_parts(powderlink("contact --alpha 2.5"), "sqrt 5");
  expect_four_parts(
      powderlink(kGrain + "--softened-modulus 2.11e7 --softened-effective-modulus 2.11e7"),
      "1.159e+07");
  expect_four_parts(powderlink("contact --softened-modulus 2.11e7 --diameter 66.9"),
                    "no --particle, --velocity");
  expect_four_parts(powderlink(kGrain + "--alpha 0.12 --json /no/such/folder/c.json"), "folder");
}

}  // namespace
}  // namespace powderlink::analysis
