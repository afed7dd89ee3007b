// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_text.h"

namespace kat {

bool same_text(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

bool parse_u32(const char* text, uint32_t& value) {
  if (*text == '\0') return false;
  uint32_t sum = 0;
  for (; *text != '\0'; ++text) {
    if (*text < '0' || *text > '9') return false;
    const uint32_t digit = static_cast<uint32_t>(*text - '0');
    if (sum > (UINT32_MAX - digit) / 10U) return false;
    sum = sum * 10U + digit;
  }
  value = sum;
  return true;
}

uint16_t crc16(const char* text, uint16_t length) {
  uint16_t crc = 0xFFFF;
  for (uint16_t i = 0; i < length; ++i) {
    crc = static_cast<uint16_t>(crc ^ (static_cast<uint16_t>(static_cast<uint8_t>(text[i])) << 8));
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const uint16_t carry = static_cast<uint16_t>(crc & 0x8000U);
      crc = static_cast<uint16_t>(crc << 1);
      if (carry != 0) crc = static_cast<uint16_t>(crc ^ 0x1021U);
    }
  }
  return crc;
}

}  // namespace kat
