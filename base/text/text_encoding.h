// SPDX-License-Identifier: GPL-3.0-or-later
/// \file text_encoding.h
/// Text as programs and countries write it, made UTF-8 with lines that end in '\n'.
///
///   UTF-8, UTF-16, UTF-32   with a byte order mark; UTF-8 and UTF-16 without one too
///   Windows-1252            bytes that are no UTF-8: it holds Latin-1, and the micro sign, the degree
///                           and the squares of Mac Roman's and Windows's western pages alike; of other
///                           pages only the ASCII is right, numbers and English names
///   ends of lines           "\n", "\r\n", and "\r" alone
///
/// What is no text (workbooks, pictures, archives) is InvalidInput that names what it is, and so is
/// damaged UTF-16 and UTF-32, with its line.
/// Source: WHATWG Encoding Standard for the order; conversion by iconv (POSIX), UTF-8 by UTF8-CPP.
/// Tests: tests/base/text_encoding_test.cpp
#pragma once

#include <filesystem>
#include <string>

namespace powderlink {

struct Text {
  std::string utf8;
  std::string encoding;  ///< "UTF-8", "UTF-16LE", "Windows-1252", ...
};

/// \param file  for messages
Text decoded(const std::string& bytes, const std::filesystem::path& file);

/// The same text for a terminal: valid UTF-8, no control characters but ends of lines.
std::string for_terminal(const std::string& text);

}  // namespace powderlink
