// SPDX-License-Identifier: GPL-3.0-or-later
/// Bad input: one line with what failed, was given, is allowed and is to do; exit status 1; no file
/// more than before.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tests/analysis/render/dump_sample.h"

namespace powderlink::render::test {
namespace {

class BadInput : public ::testing::Test {
 protected:
  void SetUp() override { write_run(run()); }

  std::filesystem::path run() const { return folder_.path() / "run"; }
  std::filesystem::path dump() const { return run() / "post/particles_200.vtp"; }

  void refuses(const std::string& arguments, const std::string& expected) {
    const auto before = names_below(run());
    const auto messages = folder_.path() / "messages";
    const std::string command = std::string("'") + POWDERLINK_RENDER + "' " + arguments + " >'" +
                                messages.string() + "' 2>&1";
    const int status = std::system(command.c_str());  // NOLINT
    const std::string text = text_of(messages);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    for (const std::string& part : {expected, std::string("; given: "), std::string("; allowed: "),
                                    std::string("; to do: ")}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    EXPECT_EQ(names_below(run()), before);
  }
  void both_refuse(const std::string& expected) {
    refuses("series '" + run().string() + "'", expected);
    refuses("png '" + run().string() + "' -o '" + (run() / "kat.png").string() + "'", expected);
  }

  TemporaryFolder folder_;
};

TEST_F(BadInput, NoFolder) { refuses("series '" + run().string() + "/none'", "opening the run"); }

TEST_F(BadInput, NoDumps) {
  std::filesystem::remove_all(run() / "post");
  both_refuse("post/particles_<step>.vtp");
}

TEST_F(BadInput, FileBreaksOff) {
  const std::string text = text_of(dump());
  std::ofstream(dump()) << text.substr(0, text.size() / 2);
  both_refuse("particles_200.vtp");
}

TEST_F(BadInput, FileIsSomethingElse) {
  std::ofstream(dump()) << "ITEM: TIMESTEP\n200\n";
  both_refuse("particles_200.vtp");
}

TEST_F(BadInput, EmptyFile) {
  std::ofstream(dump()) << "";
  both_refuse("particles_200.vtp");
}

TEST_F(BadInput, MissingArrays) {
  DumpStyle style;
  style.with_fix = false;
  write_dump(dump(), sample_grains(200), style);
  both_refuse("'f_kat[1]' is missing");
  style = {};
  style.with_velocity = false;
  write_dump(dump(), sample_grains(200), style);
  both_refuse("'v' is missing");
}

TEST_F(BadInput, OtherFixId) {
  refuses("series --fix drop '" + run().string() + "'", "'f_drop[1]' is missing");
}

TEST_F(BadInput, RadiusIsNoLength) {
  auto grains = sample_grains(200);
  grains[3].radius_m = -1e-6;
  write_dump(dump(), grains);
  both_refuse("point 3");
}

TEST_F(BadInput, DamagedResults) {
  std::ofstream(run() / "kat_results.json") << "{\"critical_diameter_m\": 4";
  both_refuse("kat_results.json");
  std::ofstream(run() / "kat_results.json") << "{\"time_step_s\": -1}";
  both_refuse("time_step_s");
}

TEST_F(BadInput, NoTimeStepForASeries) {
  std::filesystem::remove(run() / "kat_results.json");
  refuses("series '" + run().string() + "'", "--time-step");
}

TEST_F(BadInput, Options) {
  const std::string png = "png '" + run().string() + "' -o '" + (run() / "kat.png").string() + "' ";
  refuses(png + "--time 1", "option --time");
  refuses(png + "--frames 0", "option --frames");
  refuses(png + "--width 10", "option --width");
  refuses(png + "--window -5", "option --window");
  refuses(png + "--flight -1", "option --flight");
  refuses(png + "--time-step 0", "option --time-step");
}

TEST_F(BadInput, OutputFolderDoesNotExist) {
  refuses("png '" + run().string() + "' --width 400 -o '" + (run() / "none/kat.png").string() + "'",
          "writing");
}

TEST_F(BadInput, DamagedMesh) {
  std::ofstream(run() / "post/plate_0.stl") << "solid nothing\n";
  both_refuse("plate_0.stl");
  std::filesystem::remove(run() / "post/plate_0.stl");
  std::ofstream(run() / "post/plate_0.vtk") << "# vtk DataFile Version 2.0\nno\n";
  both_refuse("plate_0.vtk");
}

TEST_F(BadInput, TableWithoutResults) {
  std::filesystem::remove(run() / "kat_results.json");
  refuses("table '" + run().string() + "'", "residual velocities");
}

}  // namespace
}  // namespace powderlink::render::test
