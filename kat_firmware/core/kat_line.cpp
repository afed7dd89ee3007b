// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_line.h"

#include "kat_text.h"

namespace kat {

namespace {

const char kHeader[] = "KAT";
const char kVersion[] = "1";
const char kDigits[] = "0123456789ABCDEF";

char hex_digit(uint16_t crc, uint8_t place) { return kDigits[(crc >> (12 - 4 * place)) & 0xFU]; }

bool printable(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

LineWriter::LineWriter(const char* word) : length_(0), fits_(true) {
  put(kHeader);
  put(kVersion);
  put(' ');
  put(word);
}

void LineWriter::put(char c) {
  if (length_ >= kLineLimit - kChecksumLength) {
    fits_ = false;
    return;
  }
  text_[length_++] = c;
}

void LineWriter::put(const char* text) {
  for (; *text != '\0'; ++text) put(*text);
}

LineWriter& LineWriter::text(const char* key, const char* value) {
  put(' ');
  put(key);
  put('=');
  put(value);
  return *this;
}

LineWriter& LineWriter::number(const char* key, uint32_t value) {
  if (value == kNoValue) return text(key, "-");
  char digits[11];
  uint8_t i = 10;
  digits[i] = '\0';
  do {
    digits[--i] = static_cast<char>('0' + value % 10U);
    value /= 10U;
  } while (value != 0);
  return text(key, digits + i);
}

const char* LineWriter::finish() {
  const uint16_t crc = crc16(text_, length_);
  text_[length_++] = '*';
  for (uint8_t i = 0; i < 4; ++i) text_[length_++] = hex_digit(crc, i);
  text_[length_++] = '\n';
  text_[length_] = '\0';
  return text_;
}

Code Line::parse(const char* text, uint16_t length) {
  const Code code = split(text, length);
  if (code != Code::none) {
    fields_ = 0;
    text_[0] = '\0';
  }
  return code;
}

Code Line::split(const char* text, uint16_t length) {
  fields_ = 0;
  if (length > kLineLimit) return Code::too_long;
  uint16_t at = 0;
  for (; kHeader[at] != '\0'; ++at) {
    if (at == length || text[at] != kHeader[at]) return Code::not_a_line;
  }
  if (length < at + kChecksumLength || text[length - kChecksumLength] != '*')
    return Code::no_checksum;
  const uint16_t end = static_cast<uint16_t>(length - kChecksumLength);
  const uint16_t crc = crc16(text, end);
  for (uint8_t i = 0; i < 4; ++i) {
    if (text[end + 1 + i] != hex_digit(crc, i)) return Code::bad_checksum;
  }
  if (text[at] != kVersion[0] || text[at + 1] != ' ') return Code::wrong_version;
  at = static_cast<uint16_t>(at + 2);
  // Copied with zeros in place of spaces and equal signs: word, then key and value in turn.
  uint8_t out = 0;
  bool in_key = false;
  uint8_t part = 0;  // where the present part begins
  for (; at < end; ++at) {
    const char c = text[at];
    const bool part_ends = c == ' ' || (in_key && c == '=');
    if (!part_ends) {
      text_[out++] = c;
      continue;
    }
    // An empty part, a key without a value, or too many of them.
    if (out == part || (in_key && c == ' ')) return Code::bad_field;
    text_[out++] = '\0';
    part = out;
    if (c == '=') {
      values_[fields_++] = out;
      in_key = false;
    } else {
      if (fields_ == kFieldLimit) return Code::bad_field;
      keys_[fields_] = out;
      in_key = true;
    }
  }
  if (out == part || in_key) return Code::bad_field;
  text_[out] = '\0';
  return Code::none;
}

const char* Line::find(const char* key) const {
  for (uint8_t i = 0; i < fields_; ++i) {
    if (same_text(this->key(i), key)) return value(i);
  }
  return nullptr;
}

bool Line::number(const char* key, uint32_t& value) const {
  const char* text = find(key);
  if (text == nullptr) return false;
  if (same_text(text, "-")) {
    value = kNoValue;
    return true;
  }
  return parse_u32(text, value);
}

bool LineReader::take(char c) {
  if (c == '\r') return false;
  if (c == '\n') {
    done_ = length_;
    told_ = trouble_;
    text_[length_] = '\0';
    const bool something = length_ > 0 || trouble_ != Code::none;
    length_ = 0;
    trouble_ = Code::none;
    return something;
  }
  if (!printable(c)) {
    trouble_ = Code::noise;
  } else if (length_ == kLineLimit) {
    trouble_ = Code::too_long;
  } else {
    text_[length_++] = c;
  }
  return false;
}

}  // namespace kat
