// SPDX-License-Identifier: GPL-3.0-or-later
// The results file: its content, and that a failed write leaves earlier results alone.
#include "liggghts_styles/kat_drop/kat_results.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

namespace fs = std::filesystem;
using host::KatResults;
using test::refuses;

class KatResultsFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("powderlink_results_" + std::string(info->name()) + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "results.json").string(); }
  std::string text() const {
    std::ifstream in(file());
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  fs::path folder_;
};

KatResults example() {
  KatResults r;
  r.impact_velocity_m_s = 1.4;
  r.critical_diameter_m = 46.03e-6;
  r.largest_attached_m = 46e-6;
  r.smallest_detached_m = 46.06e-6;
  r.out_of_order = 2;
  r.steps = 12345;
  r.impact_step = 678;
  r.time_step_s = 1.25e-9;
  r.grains = {{7, 40e-6, 1.0, 0.01, 1e-9, -2e-10},
              {8, 50e-6, 0.0, 0.7, 3e-9, 4e-10},
              {9, 45e-6, 2.0, 0.02, 0.0, 0.0}};
  return r;
}

TEST_F(KatResultsFile, HoldsEveryValueToTheLastDigit) {
  const KatResults r = example();
  host::write(r, file());
  const auto j = nlohmann::json::parse(text());
  EXPECT_EQ(j.at("impact_velocity_m_s"), r.impact_velocity_m_s);
  EXPECT_EQ(j.at("critical_diameter_m"), r.critical_diameter_m);
  EXPECT_EQ(j.at("largest_attached_m"), r.largest_attached_m);
  EXPECT_EQ(j.at("smallest_detached_m"), r.smallest_detached_m);
  EXPECT_EQ(j.at("attached"), 2) << "in contact, or bound across the gap";
  EXPECT_EQ(j.at("detached"), 1);
  EXPECT_EQ(j.at("out_of_order"), 2);
  EXPECT_EQ(j.at("steps"), 12345);
  EXPECT_EQ(j.at("impact_step"), 678);
  EXPECT_EQ(j.at("time_step_s"), r.time_step_s);
  ASSERT_EQ(j.at("particles").size(), r.grains.size());
  for (std::size_t i = 0; i < r.grains.size(); ++i) {
    const auto& p = j.at("particles").at(i);
    EXPECT_EQ(p.at("id"), static_cast<long>(r.grains[i].id));
    EXPECT_EQ(p.at("diameter_m"), r.grains[i].diameter_m);
    EXPECT_EQ(p.at("attached"), r.grains[i].attached > 0.0);
    EXPECT_EQ(p.at("speed_m_s"), r.grains[i].speed_m_s);
    EXPECT_EQ(p.at("balance"), r.grains[i].energy_residual);
    EXPECT_EQ(p.at("momentum_balance"), r.grains[i].momentum_residual);
  }
}

TEST_F(KatResultsFile, WhatWasNotFoundIsNull) {
  host::write(KatResults(), file());
  const auto j = nlohmann::json::parse(text());
  for (const char* key : {"critical_diameter_m", "largest_attached_m", "smallest_detached_m"}) {
    EXPECT_TRUE(j.at(key).is_null()) << key;
  }
  EXPECT_EQ(j.at("attached"), 0);
  EXPECT_EQ(j.at("detached"), 0);
  EXPECT_TRUE(j.at("particles").is_array());
  EXPECT_TRUE(j.at("particles").empty());
}

TEST_F(KatResultsFile, ReplacesEarlierResultsAndLeavesNothingBeside) {
  std::ofstream(file()) << "earlier";
  host::write(example(), file());
  EXPECT_NO_THROW(nlohmann::json::parse(text()));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) files += entry.exists() ? 1 : 0;
  EXPECT_EQ(files, 1U);
}

TEST_F(KatResultsFile, AFullDiskLeavesEarlierResultsAlone) {
  ASSERT_TRUE(fs::exists("/dev/full")) << "Linux has it";
  std::ofstream(file()) << "earlier";
  // Where the writer writes beside the file.
  fs::create_symlink("/dev/full", folder_ / (".results.json.part" + std::to_string(::getpid())));
  EXPECT_TRUE(refuses([this] { host::write(example(), file()); }, "results file", file()));
  EXPECT_EQ(text(), "earlier");
}

TEST_F(KatResultsFile, RefusesFoldersThatCannotBeWritten) {
  const std::string missing = (folder_ / "no_such_folder" / "results.json").string();
  EXPECT_TRUE(refuses([&] { host::write(example(), missing); }, "results file", missing));
  fs::create_directory(file());  // a folder where the file should be
  EXPECT_TRUE(refuses([this] { host::write(example(), file()); }, "results file", file()));
  EXPECT_TRUE(fs::is_directory(file()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "nothing half-written";
}

}  // namespace
}  // namespace powderlink
