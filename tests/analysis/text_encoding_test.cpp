// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of other programs and countries; the letters are known by their code points.
#include "analysis/text_encoding.h"

#include <gtest/gtest.h>

#include "tests/analysis/test_files.h"

namespace powderlink::analysis {
namespace {

using namespace std::string_literals;

const std::string kText = "Area (\u00B5m\u00B2)\n1 \u00B0C\n";

std::string wide(const std::string& ascii_or_latin1, bool little_endian) {
  std::string bytes;
  for (const char c : ascii_or_latin1) {
    if (!little_endian) bytes += '\0';
    bytes += c;
    if (little_endian) bytes += '\0';
  }
  return bytes;
}

TEST(TextEncoding, EveryEncodingGivesTheSameText) {
  const std::string latin1 =
      "Area (\xB5m\xB2)\n1 \xB0"
      "C\n";
  const auto is = [&](const std::string& bytes, const std::string& encoding) {
    const Text text = decoded(bytes, "t.csv");
    EXPECT_EQ(text.utf8, kText) << encoding;
    EXPECT_EQ(text.encoding, encoding);
  };
  is(kText, "UTF-8");
  is("\xEF\xBB\xBF" + kText, "UTF-8");
  is(latin1, "Windows-1252");
  is("\xFF\xFE" + wide(latin1, true), "UTF-16LE");
  is("\xFE\xFF" + wide(latin1, false), "UTF-16BE");
  is(wide(latin1, true), "UTF-16LE");
  is(wide(latin1, false), "UTF-16BE");
  EXPECT_EQ(decoded("10 \x80", "t.csv").utf8, "10 \u20AC");  // in Windows-1252, not in Latin-1
}

TEST(TextEncoding, EndsOfLinesAreOne) {
  for (const std::string end : {"\n", "\r\n", "\r"})
    EXPECT_EQ(decoded("a" + end + "b" + end + end + "c", "t.csv").utf8, "a\nb\n\nc");
}

TEST(TextEncoding, WhatIsNoTextIsNamed) {
  const auto refused = [](const std::string& bytes, const std::vector<std::string>& fragments) {
    expect_refusal([&] { decoded(bytes, "t.csv"); }, fragments);
  };
  refused("PK\x03\x04rest", {"t.csv", ".xlsx"});
  refused("\xD0\xCF\x11\xE0\xA1", {"workbook of Excel (.xls)"});
  refused("\x89PNG\r\n", {"picture (PNG)"});
  refused("a,b\n1,\0002\n"s, {"line 2", "a byte 0"});
  refused("a,b\n\xC2\xB5,2\n\xB5,3\n", {"line 3", "0xB5", "UTF-8"});  // two files in one
  refused("a\n\x81\xB5\n", {"line 2", "0x81", "Windows-1252", "UTF-8"});
  refused("\xFF\xFE\x00\xD8"s + wide("a", true), {"UTF-16LE"});  // half of a pair
}

TEST(TextEncoding, TerminalsGetNoInvalidBytesAndNoControls) {
  EXPECT_EQ(for_terminal("a\xB5\x1B[2J\tb\n\u00B5\u009B"), "a\uFFFD?[2J b\n\u00B5?");
}

}  // namespace
}  // namespace powderlink::analysis
