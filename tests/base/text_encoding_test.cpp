// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of other programs and countries; the letters are known by their code points.
#include "base/text/text_encoding.h"

#include <gtest/gtest.h>

#include "base/csv/csv_table.h"
#include "tests/base/test_files.h"

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

/// Names of pictures in the letters of a country stand beside numbers that are the same in all encodings.
TEST(TextEncoding, OtherPagesKeepTheirNumbers) {
  EXPECT_EQ(decoded("a,b\n\xC2\xB5,2\n\xB5,3\n", "t.csv").utf8, "a,b\n\u00B5,2\n\u00B5,3\n");
  const TestFolder folder;
  for (const char* label : {"\xD4\xB2\xB6\xC8",                  // GBK
                            "\x83\x65\x83\x58\x83\x67\x83\x5C",  // Shift JIS
                            "\xEE\xE1\xF0\xE0\xE7\xE5\xF6",      // Windows-1251
                            "\xC2\xB5 and \xB5"}) {              // two files in one
    const CsvTable t = read_csv(folder.write(
        "t.csv", "Label,Area\n" + std::string(label) + ".tif,1385\n" + label + ",12.5\n"));
    ASSERT_EQ(t.rows.size(), 2U) << label;
    EXPECT_EQ(t.number(t.rows[0], 1), 1385.0);
    EXPECT_EQ(t.number(t.rows[1], 1), 12.5);
    EXPECT_EQ(for_terminal(t.rows[0].cells[0]), t.rows[0].cells[0]) << "valid UTF-8";
  }
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
  refused("\xFF\xFE\x00\xD8"s + wide("a", true), {"UTF-16LE"});  // half of a pair
}

TEST(TextEncoding, TerminalsGetNoInvalidBytesAndNoControls) {
  EXPECT_EQ(for_terminal("a\xB5\x1B[2J\tb\n\u00B5\u009B"), "a\uFFFD?[2J b\n\u00B5?");
}

}  // namespace
}  // namespace powderlink::analysis
