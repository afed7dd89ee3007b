// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_device_live_test.cpp
/// `kat device` on a pseudo-terminal with a bad cable, and when it is interrupted: a drop that the device
/// holds is not lost, and neither are lines that came.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

#include "base/csv/csv_table.h"
#include "tests/analysis/program/command_line.h"
#include "tests/kat_firmware/simulated_device.h"

namespace powderlink::analysis {
namespace {

namespace fs = std::filesystem;

class LiveDevice : public testing::Test {
 protected:
  /// With `--do arm --do drop` and more.
  CommandResult drop(const std::string& more = "") {
    device.start();
    return powderlink("kat device --wait 20 --port " + device.port() +
                      " --do arm --do drop --log " + file("d.log") + " --csv " + file("d.csv") +
                      " " + more);
  }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }
  /// One row with the velocity of the fall.
  void expect_measured() const {
    const CsvTable table = read_csv(file("d.csv"));
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_NEAR(table.number(table.rows[0], 0) / device.board.scene.impact_velocity_m_s(), 1.0,
                1e-3);
  }
  /// Spoils the first `times` lines that begin with `word`; to be called before the device starts.
  void spoil(const std::string& word, int times,
             const std::function<std::string(std::string)>& how) {
    device.on_the_way = [word, times, how,
                         before = device.on_the_way](const std::string& line) mutable {
      if (line.compare(5, word.size(), word) != 0 || times == 0) return before(line);
      --times;
      return how(line);
    };
  }
  static std::string flipped(std::string line) {
    line[line.size() / 2] ^= 1;
    return line;
  }
  static std::string cut(std::string line) { return line.substr(0, line.size() / 2); }

  TestFolder folder;
  kat::SimulatedDevice device;
};

TEST_F(LiveDevice, ADamagedLineOfTheReportIsAskedForAgain) {
  spoil("impact", 1, flipped);
  const CommandResult r = drop();
  ASSERT_EQ(r.status, 0) << r.err << r.out;
  EXPECT_NE(r.err.find("bad_checksum"), std::string::npos) << r.err;
  expect_measured();
  EXPECT_EQ(powderlink("kat device --skip-damaged " + file("d.log")).status, 0);
}

TEST_F(LiveDevice, ACutEndOfTheReportIsAskedForAgain) {
  spoil("end", 1, cut);
  const CommandResult r = drop();
  ASSERT_EQ(r.status, 0) << r.err << r.out;
  expect_measured();
}

TEST_F(LiveDevice, ADamagedAnswerToTheDropLosesNothing) {
  spoil("ok cmd=drop", 1, flipped);
  const CommandResult r = drop();
  ASSERT_EQ(r.status, 0) << r.err << r.out;
  expect_measured();
}

/// Noise while it falls, then the silence of the fall.
TEST_F(LiveDevice, NoiseAfterTheReleaseEndsNothing) {
  spoil("ok cmd=drop", 1, [](const std::string& line) { return line + "KAT1 \x7f\xff noise\n"; });
  const CommandResult r = drop();
  ASSERT_EQ(r.status, 0) << r.err << r.out;
  expect_measured();
}

TEST_F(LiveDevice, AQuestionIsRepeatedAndAnActionIsNot) {
  spoil("ok cmd=status", 2, flipped);
  spoil("ok cmd=arm", 1, flipped);
  device.start();
  const std::string port = "kat device --wait 20 --port " + device.port();
  EXPECT_EQ(powderlink(port + " --do status").status, 0);
  expect_four_parts(powderlink(port + " --do arm"), "--do status tells");
  EXPECT_NE(powderlink(port + " --do status").out.find("state=armed"), std::string::npos);
}

TEST_F(LiveDevice, AReportThatStaysDamagedIsStillInTheDevice) {
  spoil("impact", 3, flipped);
  const CommandResult r = drop();
  expect_four_parts(r, "the device holds the drop until the next is armed: --do report");
  EXPECT_EQ(r.err.find("skip-damaged"), std::string::npos) << r.err;
  EXPECT_NE(read_file(file("d.log")).find("ok cmd=drop"), std::string::npos);
  EXPECT_FALSE(fs::exists(file("d.log.part")));
  // The advice helps.
  EXPECT_EQ(powderlink("kat device --wait 20 --port " + device.port() + " --do report --csv " +
                       file("d.csv"))
                .status,
            0);
  expect_measured();
}

TEST_F(LiveDevice, ARefusalLeavesTheLog) {
  expect_four_parts(drop("--do drop"), "wrong_state");
  EXPECT_FALSE(fs::exists(file("d.log.part")));
  EXPECT_EQ(powderlink("kat device " + file("d.log") + " --csv " + file("d.csv")).status, 0);
  expect_measured();
}

TEST_F(LiveDevice, AnInterruptLeavesTheLinesThatCame) {
  bool mute = false;
  device.on_the_way = [mute](const std::string& line) mutable {
    mute = mute || line.find("cmd=selftest") != std::string::npos;
    return mute ? std::string() : line;
  };
  device.start();
  const std::string log = file("d.log"), part = log + ".part";
  const pid_t program = ::fork();
  ASSERT_GE(program, 0);
  if (program == 0) {
    // Files instead of the terminal of the test.
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(1);
    ::execl(POWDERLINK_PROGRAM, "powderlink", "kat", "device", "--wait", "60", "--port",
            device.port().c_str(), "--do", "arm", "--do", "drop", "--do", "selftest", "--log",
            log.c_str(), nullptr);
    ::_exit(1);
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (read_file(part).find("KAT1 end ") == std::string::npos &&
         std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_EQ(::kill(program, SIGINT), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(program, &status, 0), program);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  EXPECT_FALSE(fs::exists(log));
  EXPECT_EQ(powderlink("kat device " + part + " --csv " + file("d.csv")).status, 0);
  expect_measured();
  // They are not lost to the next session either.
  expect_four_parts(powderlink("kat device --do status --port " + device.port() + " --log " + log),
                    "interrupted");
}

}  // namespace
}  // namespace powderlink::analysis
