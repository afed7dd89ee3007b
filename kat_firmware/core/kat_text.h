// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_text.h
/// The few functions on text that the core needs, so that it links without a C library.
/// Tests: tests/kat_firmware/line_test.cpp
#ifndef KAT_TEXT_H
#define KAT_TEXT_H

#include <stdint.h>

namespace kat {

bool same_text(const char* a, const char* b);

/// A whole decimal number below 2^32, digits only; false (and `value` as it was) for anything else.
bool parse_u32(const char* text, uint32_t& value);

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF; 0x29B1 for "123456789".
uint16_t crc16(const char* text, uint16_t length);

}  // namespace kat

#endif
