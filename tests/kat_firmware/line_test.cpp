// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_firmware/core/kat_line.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "kat_firmware/core/kat_text.h"

namespace kat {
namespace {

std::string with_checksum(const std::string& text) {
  char end[6];
  std::snprintf(end, sizeof(end), "*%04X", crc16(text.c_str(), static_cast<uint16_t>(text.size())));
  return text + end;
}

Code parse(Line& line, const std::string& text) {
  return line.parse(text.data(), static_cast<uint16_t>(text.size()));
}

Code code_of(const std::string& text) {
  Line line;
  const Code code = parse(line, text);
  if (code != Code::none) {
    EXPECT_STREQ(line.word(), "");
    EXPECT_EQ(line.fields(), 0);
  }
  return code;
}

TEST(Crc16, HasTheCheckValueOfCcittFalse) {
  EXPECT_EQ(crc16("123456789", 9), 0x29B1);
  EXPECT_EQ(crc16("", 0), 0xFFFF);
}

TEST(ParseU32, TakesWholeNumbersOnly) {
  uint32_t value = 7;
  for (const char* bad : {"", "-1", "1.5", "4294967296", "99999999999", "0x10", " 1", "1 ", ":"}) {
    EXPECT_FALSE(parse_u32(bad, value)) << bad;
    EXPECT_EQ(value, 7U);
  }
  EXPECT_TRUE(parse_u32("4294967295", value));
  EXPECT_EQ(value, 4294967295U);
  EXPECT_TRUE(parse_u32("007", value));
  EXPECT_EQ(value, 7U);
}

TEST(Codes, AreFoundByTheirNamesAndHaveAdvice) {
  for (uint8_t i = 0; i < static_cast<uint8_t>(Code::count); ++i) {
    const Code code = static_cast<Code>(i);
    EXPECT_EQ(find_code(code_name(code)), code);
    EXPECT_GT(std::string(code_advice(code)).size(), 5U);
  }
  for (uint8_t i = 0; i < static_cast<uint8_t>(State::count); ++i) {
    EXPECT_EQ(find_state(state_name(static_cast<State>(i))), static_cast<State>(i));
  }
  EXPECT_EQ(find_code("no_such"), Code::count);
  EXPECT_EQ(find_state("idl"), State::count);
  EXPECT_EQ(find_state("idlee"), State::count);
}

TEST(Line, ReadsWhatTheWriterWrote) {
  LineWriter writer("impact");
  writer.text("state", "idle")
      .number("zero", 0)
      .number("large", 4294967294U)
      .number("none", kNoValue);
  const std::string text = writer.finish();
  EXPECT_EQ(text, with_checksum("KAT1 impact state=idle zero=0 large=4294967294 none=-") + "\n");
  EXPECT_EQ(writer.length(), text.size());
  EXPECT_TRUE(writer.fits());
  Line line;
  ASSERT_EQ(parse(line, text.substr(0, text.size() - 1)), Code::none);
  EXPECT_STREQ(line.word(), "impact");
  EXPECT_EQ(line.fields(), 4);
  EXPECT_STREQ(line.key(1), "zero");
  EXPECT_STREQ(line.find("state"), "idle");
  EXPECT_EQ(line.find("absent"), nullptr);
  uint32_t value = 1;
  EXPECT_TRUE(line.number("large", value));
  EXPECT_EQ(value, 4294967294U);
  EXPECT_TRUE(line.number("none", value));
  EXPECT_EQ(value, static_cast<uint32_t>(kNoValue));
  EXPECT_FALSE(line.number("state", value));
  EXPECT_FALSE(line.number("absent", value));
}

TEST(Line, AWriterThatIsFullSaysSoAndStaysALine) {
  LineWriter writer("long");
  for (int i = 0; i < 30; ++i) writer.number("key", 4294967294U);
  EXPECT_FALSE(writer.fits());
  const std::string text = writer.finish();
  EXPECT_LE(text.size(), kLineLimit + 1U);
}

TEST(Line, NamesEveryKindOfDamage) {
  EXPECT_EQ(code_of("hello"), Code::not_a_line);
  EXPECT_EQ(code_of(""), Code::not_a_line);
  EXPECT_EQ(code_of("KA"), Code::not_a_line);
  EXPECT_EQ(code_of("KAT1 arm"), Code::no_checksum);
  EXPECT_EQ(code_of("KAT"), Code::no_checksum);
  EXPECT_EQ(code_of("KAT*000"), Code::no_checksum);
  EXPECT_EQ(code_of("KAT1 arm*0000"), Code::bad_checksum);
  EXPECT_EQ(code_of(with_checksum("KAT2 arm")), Code::wrong_version);
  EXPECT_EQ(code_of(with_checksum("KAT12 arm")), Code::wrong_version);
  EXPECT_EQ(code_of(with_checksum("KAT")), Code::wrong_version);
  for (const char* bad : {"KAT1 ", "KAT1  arm", "KAT1 arm ", "KAT1 arm a",
                          "KAT1 arm a=", "KAT1 arm =1", "KAT1 arm a= b=1", "KAT1 arm a b=1",
                          "KAT1 a 1=1 2=1 3=1 4=1 5=1 6=1 7=1 8=1 9=1 10=1 11=1"}) {
    EXPECT_EQ(code_of(with_checksum(bad)), Code::bad_field) << bad;
  }
  EXPECT_EQ(code_of(with_checksum("KAT1 " + std::string(kLineLimit - 9U, 'a'))), Code::too_long);
  EXPECT_EQ(code_of(with_checksum("KAT1 " + std::string(kLineLimit - 10U, 'a'))), Code::none);
  EXPECT_EQ(code_of(with_checksum("KAT1 arm a=b=c")), Code::none);  // a value may hold one
}

/// The checksum's own promise: every error in one or two bits of a line this short is found, and every
/// burst of at most 16 bits.
TEST(Line, EveryOneAndTwoBitErrorIsFound) {
  const std::string good = with_checksum("KAT1 beam n=3 enter_us=1234 leave_us=5678");
  Line line;
  ASSERT_EQ(parse(line, good), Code::none);
  const std::size_t bits = 8 * good.size();
  for (std::size_t i = 0; i < bits; ++i) {
    for (std::size_t j = i; j < bits; ++j) {
      std::string bad = good;
      bad[i / 8] = static_cast<char>(bad[i / 8] ^ (1 << (i % 8)));
      if (j != i) bad[j / 8] = static_cast<char>(bad[j / 8] ^ (1 << (j % 8)));
      ASSERT_NE(parse(line, bad), Code::none) << i << " " << j;
    }
  }
}

TEST(Line, ACutLineIsNotTaken) {
  const std::string good = with_checksum("KAT1 beam n=3 enter_us=1234 leave_us=5678");
  for (std::size_t n = 0; n < good.size(); ++n) EXPECT_NE(code_of(good.substr(0, n)), Code::none);
  for (std::size_t n = 1; n < good.size(); ++n) EXPECT_NE(code_of(good.substr(n)), Code::none);
}

/// Memory is safe and refusals are clean for any bytes; the sanitizers watch this.
TEST(Line, AnyBytesAreEitherALineOrRefused) {
  std::mt19937 random(20240711);
  const std::string letters = "KAT1 arm=*-0F\x80\x01";
  for (int i = 0; i < 200000; ++i) {
    std::string text = i % 2 == 0 ? "KAT1 " : "";
    const std::size_t length = random() % 180;
    while (text.size() < length) text += letters[random() % letters.size()];
    if (i % 4 == 0) text = with_checksum(text);
    code_of(text);
  }
}

std::string feed(LineReader& reader, const std::string& bytes, std::vector<Code>& troubles) {
  std::string lines;
  for (const char c : bytes) {
    if (!reader.take(c)) continue;
    troubles.push_back(reader.trouble());
    lines += std::string(reader.text(), reader.length()) + "|";
  }
  return lines;
}

TEST(LineReader, PartsLinesAndNamesWhatIsNoText) {
  LineReader reader;
  std::vector<Code> troubles;
  EXPECT_EQ(feed(reader, "\n\r\nab\r\nc\n", troubles), "ab|c|");
  EXPECT_EQ(troubles, (std::vector<Code>{Code::none, Code::none}));
  troubles.clear();
  feed(reader, "a\x80z\n\x01\nfine\n" + std::string(200, 'x') + "\nfine\n", troubles);
  EXPECT_EQ(troubles,
            (std::vector<Code>{Code::noise, Code::noise, Code::none, Code::too_long, Code::none}));
  troubles.clear();
  EXPECT_EQ(feed(reader, std::string(kLineLimit, 'y') + "\n", troubles).size(), kLineLimit + 1U);
  EXPECT_EQ(troubles, (std::vector<Code>{Code::none}));
}

}  // namespace
}  // namespace kat
