// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_line.h
/// One line of the protocol, for both ends of it:
///
///   KAT1 WORD key=value key=value*HHHH
///
/// KAT and the version, a word, at most ten fields, and the CRC-16 of all before the asterisk as four
/// hexadecimal digits (capitals). Lines end in \n; \r is allowed before it. `-` is a value that was
/// not measured. Printable ASCII only, 159 characters at most.
/// Tests: tests/kat_firmware/line_test.cpp
#ifndef KAT_LINE_H
#define KAT_LINE_H

#include <stdint.h>

#include "kat_codes.h"

namespace kat {

enum : uint16_t { kLineLimit = 159 };
enum : uint8_t { kFieldLimit = 10, kChecksumLength = 5 };  // with its asterisk

/// Stands for a number that was not measured; written `-`.
enum : uint32_t { kNoValue = UINT32_MAX };

/// Writes a line field by field. What does not fit makes fits() false; fields of this project's
/// lines always fit, a test holds that.
class LineWriter {
 public:
  explicit LineWriter(const char* word);
  LineWriter& text(const char* key, const char* value);
  LineWriter& number(const char* key, uint32_t value);
  /// Adds the checksum and \n. The pointer is valid while the writer is.
  const char* finish();
  uint16_t length() const { return length_; }
  bool fits() const { return fits_; }

 private:
  void put(char c);
  void put(const char* text);

  char text_[kLineLimit + 3];
  uint16_t length_;
  bool fits_;
};

/// Reads a line without its end. A line that is refused has no word and no fields.
class Line {
 public:
  Line() : fields_(0) { text_[0] = '\0'; }
  Code parse(const char* text, uint16_t length);

  const char* word() const { return text_; }
  uint8_t fields() const { return fields_; }
  const char* key(uint8_t i) const { return text_ + keys_[i]; }
  const char* value(uint8_t i) const { return text_ + values_[i]; }
  /// nullptr when there is no such key.
  const char* find(const char* key) const;
  /// False when the key is absent or its value no number; `-` gives kNoValue.
  bool number(const char* key, uint32_t& value) const;

 private:
  Code split(const char* text, uint16_t length);

  char text_[kLineLimit + 1];  // the word, then keys and values, each ended by a zero
  uint8_t keys_[kFieldLimit], values_[kFieldLimit];
  uint8_t fields_;
};

/// Puts bytes together to lines.
class LineReader {
 public:
  LineReader() : length_(0), trouble_(Code::none) {}
  /// True at the end of a line that is not empty: text(), length() and trouble() then tell of it
  /// until the next byte. trouble() is none, noise or too_long.
  bool take(char c);
  const char* text() const { return text_; }
  uint16_t length() const { return done_; }
  Code trouble() const { return told_; }

 private:
  char text_[kLineLimit + 1];
  uint16_t length_, done_ = 0;
  Code trouble_, told_ = Code::none;
};

}  // namespace kat

#endif
