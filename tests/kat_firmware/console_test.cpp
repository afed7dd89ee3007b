// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_firmware/core/kat_console.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "kat_firmware/core/kat_text.h"
#include "tests/kat_firmware/simulated_board.h"

namespace kat {
namespace {

class Screen : public Output {
 public:
  bool open = true;
  std::vector<std::string> lines;
  bool ready() override { return open; }
  void write(const char* text, uint16_t length) override {
    const std::string all(text, length);
    ASSERT_EQ(all.back(), '\n');
    Line line;
    ASSERT_EQ(line.parse(text, static_cast<uint16_t>(length - 1)), Code::none) << all;
    lines.push_back(all.substr(5, all.size() - 11));
  }
  std::vector<std::string> take() {
    std::vector<std::string> taken;
    taken.swap(lines);
    return taken;
  }
};

using Lines = std::vector<std::string>;

struct Bench {
  SimulatedBoard board;
  Machine machine{board};
  Screen screen, second_screen;
  Console console{machine, screen}, second{machine, second_screen};

  void type(const std::string& bytes) {
    for (const char c : bytes) console.receive(c);
  }
  Lines say(const std::string& words, const std::string& version = "1") {
    std::string text = "KAT" + version + " " + words;
    char end[8];
    std::snprintf(end, sizeof(end), "*%04X\n",
                  crc16(text.c_str(), static_cast<uint16_t>(text.size())));
    type(text + end);
    return screen.take();
  }
  Lines run(uint64_t duration_us) {
    board.run(machine, duration_us, 500, [this] {
      console.poll();
      second.poll();
    });
    return screen.take();
  }
};

TEST(Console, AnswersEveryCommand) {
  Bench b;
  EXPECT_EQ(b.say("version"), (Lines{"version device=kat firmware=1", "ok cmd=version"}));
  EXPECT_EQ(b.say("status"),
            (Lines{"status state=idle fault=none n=0 magnet=off sensors=off beam=- contact=-",
                   "ok cmd=status"}));
  EXPECT_EQ(b.say("set carrier_um=9000 beam_um=40000"), (Lines{"ok cmd=set"}));
  EXPECT_EQ(b.say("config"), (Lines{"ok cmd=config"}));
  const Lines config = b.run(20000);
  ASSERT_EQ(config.size(), kConfigKeys + 1U);
  EXPECT_EQ(config.front(), "config key=carrier_um value=9000 smallest=1000 largest=200000");
  EXPECT_EQ(config.back(), "done cmd=config");
  EXPECT_EQ(b.say("report"), (Lines{"error cmd=report code=no_report"}));
  EXPECT_EQ(b.say("selftest"), (Lines{"ok cmd=selftest"}));
  EXPECT_EQ(b.run(300000),
            (Lines{"state name=self_test", "selftest result=pass found=none", "state name=idle"}));
  b.board.blocked = true;
  b.say("selftest");
  EXPECT_EQ(b.run(300000)[1], "selftest result=fail found=beam_blocked");
  b.board.blocked = false;
  EXPECT_EQ(b.say("arm"), (Lines{"ok cmd=arm"}));
  EXPECT_EQ(b.say("status")[0],
            "status state=armed fault=none n=1 magnet=on sensors=on beam=clear contact=open");
  b.board.blocked = b.board.closed = true;
  EXPECT_EQ(b.say("status")[0],
            "status state=armed fault=none n=1 magnet=on sensors=on beam=blocked contact=closed");
  EXPECT_EQ(b.say("abort"), (Lines{"ok cmd=abort"}));
  EXPECT_EQ(b.say("clear"), (Lines{"error cmd=clear code=wrong_state"}));
}

TEST(Console, NamesWhatItRefuses) {
  Bench b;
  EXPECT_EQ(b.say("jump"), (Lines{"error cmd=- code=unknown_command"}));
  EXPECT_EQ(b.say("arm", "2"), (Lines{"error cmd=- code=wrong_version"}));
  EXPECT_EQ(b.say("set beam_um=9"), (Lines{"error cmd=set code=out_of_range"}));
  EXPECT_EQ(b.say("set beam_um=1e4"), (Lines{"error cmd=set code=bad_value"}));
  EXPECT_EQ(b.say("set height=9"), (Lines{"error cmd=set code=unknown_key"}));
  EXPECT_EQ(b.say("set"), (Lines{"error cmd=set code=bad_value"}));
  EXPECT_EQ(b.say("set beam_um=5000"), (Lines{"error cmd=set code=beam_below_carrier"}));
  EXPECT_EQ(b.say("drop"), (Lines{"error cmd=drop code=wrong_state"}));
  b.type("KAT1 arm*0000\n");
  EXPECT_EQ(b.screen.take(), (Lines{"error cmd=- code=bad_checksum"}));
  b.type("KAT1 arm\n");
  EXPECT_EQ(b.screen.take(), (Lines{"error cmd=- code=no_checksum"}));
  b.type("arm\n\n\r\n");
  EXPECT_EQ(b.screen.take(), (Lines{"error cmd=- code=not_a_line"}));
  b.type("\xff\n" + std::string(300, 'K') + "\n");
  EXPECT_EQ(b.screen.take(), (Lines{"error cmd=- code=noise", "error cmd=- code=too_long"}));
  EXPECT_EQ(b.machine.state(), State::idle);
}

TEST(Console, ReportsADropToEveryPortAndThenIsIdle) {
  Bench b;
  b.say("arm");
  b.run(300000);
  EXPECT_EQ(b.say("drop"), (Lines{"ok cmd=drop"}));
  EXPECT_EQ(b.say("report"), Lines{});  // not while it falls
  Lines lines = b.run(2000000);
  EXPECT_EQ(lines.front(), "error cmd=report code=wrong_state");
  lines.erase(lines.begin());
  ASSERT_EQ(lines.size(), 1U + 5U + 4U + 1U);
  EXPECT_EQ(lines.front(), "state name=report");
  EXPECT_EQ(lines[1], "drop n=1 fault=none state=report");
  EXPECT_EQ(lines[lines.size() - 2], "end n=1 contacts=4 finished=3 lines=8");
  EXPECT_EQ(lines.back(), "state name=idle");
  EXPECT_EQ(b.second_screen.lines.size(), lines.size() + 1U);  // it saw `armed` too
  EXPECT_EQ(b.machine.state(), State::idle);
  // Again, when asked for.
  EXPECT_EQ(b.say("report"), (Lines{"ok cmd=report"}));
  const Lines again = b.run(20000);
  ASSERT_EQ(again.size(), 10U);
  EXPECT_EQ(again.back(), "done cmd=report");
  EXPECT_EQ(again.front(), lines[1]);
}

/// Interrupts of a port would delay those of the edges: it is silent from release to the end.
TEST(Console, NothingIsSentWhileItFalls) {
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"status", "error cmd=status code=wrong_state"},
      {"clear", "error cmd=clear code=wrong_state"},
      {"jump", "error cmd=- code=unknown_command"}};
  for (const auto& [said, answer] : lines) {
    Bench b;
    b.say("arm");
    b.run(300000);
    b.say("drop");
    EXPECT_EQ(b.say(said), Lines{});
    b.say("set beam_um=40000");
    b.type("KAT1 arm*0000\n");
    while (b.machine.measuring()) {
      // The last turn of the loop may be that in which it ends.
      const Lines sent = b.run(500);
      ASSERT_TRUE(sent.empty() || !b.machine.measuring()) << sent.front();
      b.screen.lines.insert(b.screen.lines.begin(), sent.begin(), sent.end());
    }
    const Lines told = b.run(20000);
    ASSERT_GT(told.size(), 4U);
    EXPECT_EQ(told[0], answer);
    EXPECT_EQ(told[1], "error cmd=- code=wrong_state");
    EXPECT_EQ(told[2], "error cmd=- code=wrong_state");
    EXPECT_EQ(told[3], "state name=report");
    EXPECT_EQ(b.machine.last().fault, Code::none);
    EXPECT_EQ(b.machine.config().beam_um, 30000U);
  }
}

TEST(Console, DamagedLinesWhileItFallsAreNamed) {
  Bench b;
  b.say("arm");
  b.run(300000);
  b.say("drop");
  b.type("KAT1 arm*0000\n");
  EXPECT_EQ(b.run(2000000).front(), "error cmd=- code=bad_checksum");
}

TEST(Console, AbortActsWhileItFalls) {
  Bench b;
  b.say("arm");
  b.run(300000);
  b.say("drop");
  b.run(1000);
  EXPECT_EQ(b.say("abort"), (Lines{"ok cmd=abort"}));
  EXPECT_EQ(b.run(20000).at(1), "drop n=1 fault=aborted state=released");
}

TEST(Console, ReportsAFault) {
  Bench b;
  b.board.disturb = [](SimulatedBoard::Edges& edges) { edges.resize(2); };
  b.say("arm");
  EXPECT_EQ(b.say("report"), (Lines{"error cmd=report code=wrong_state"}));
  b.run(300000);
  b.say("drop");
  const Lines lines = b.run(3000000);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "state name=fault");
  EXPECT_EQ(lines[1], "drop n=1 fault=no_impact state=beam_left");
  EXPECT_EQ(b.say("status")[0],
            "status state=fault fault=no_impact n=1 magnet=off sensors=off beam=- contact=-");
  EXPECT_EQ(b.say("arm"), (Lines{"error cmd=arm code=wrong_state"}));
  EXPECT_EQ(b.say("clear"), (Lines{"ok cmd=clear"}));
}

TEST(Console, APortThatTakesNothingDoesNotHoldTheOther) {
  Bench b;
  b.second_screen.open = false;
  b.say("arm");
  b.run(300000);
  b.say("drop");
  EXPECT_EQ(b.run(2000000).size(), 11U);
  EXPECT_TRUE(b.second_screen.lines.empty());
  b.second_screen.open =
      true;  // it comes back while nothing newer is there: told of the state only
  b.run(20000);
  EXPECT_TRUE(b.second_screen.lines.empty());
}

TEST(Console, AReportIsCutByTheNextDropAndItsEndIsMissing) {
  Bench b;
  b.say("arm");
  b.run(300000);
  b.say("drop");
  b.run(2000000);
  b.say("report");
  b.console.poll();
  b.console.poll();
  ASSERT_EQ(b.screen.take().size(), 2U);
  b.board.closed = false;
  b.say("arm");
  for (const std::string& line : b.run(20000)) {
    EXPECT_EQ(line.find("end"), std::string::npos) << line;
  }
  b.run(300000);
  b.say("drop");
  const Lines lines = b.run(2000000);
  EXPECT_EQ(lines.back(), "state name=idle");  // and no `done` of the report before
}

TEST(Console, AnyBytesLeaveItInOrder) {
  Bench b;
  std::mt19937 random(7);
  for (int i = 0; i < 100000; ++i) b.console.receive(static_cast<char>(random() & 0xFF));
  b.type("\n");
  b.screen.take();
  EXPECT_EQ(b.machine.state(), State::idle);
  EXPECT_EQ(b.say("version").back(), "ok cmd=version");
}

}  // namespace
}  // namespace kat
