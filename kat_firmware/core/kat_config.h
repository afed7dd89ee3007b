// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_config.h
/// What a user may set, with limits; times are below 2^31 us so that differences of a 32-bit clock
/// tell before from after. Kept in memory only: the computer sends it, and every report repeats the
/// geometry. One line in kat_config.def per key. Tests: tests/kat_firmware/parts_test.cpp
#ifndef KAT_CONFIG_H
#define KAT_CONFIG_H

#include <stdint.h>

#include "kat_codes.h"

namespace kat {

class Line;

struct Config {
#define KAT_KEY(name, initial, smallest, largest) uint32_t name = initial;
#include "kat_config.def"
#undef KAT_KEY
};

struct ConfigKey {
  const char* name;
  uint32_t Config::*value;
  uint32_t smallest, largest;
};

enum : uint8_t {
#define KAT_KEY(name, initial, smallest, largest) kKeyOf_##name,
#include "kat_config.def"
#undef KAT_KEY
  kConfigKeys
};

const ConfigKey& config_key(uint8_t i);

/// All fields of the line or none of them.
Code set_config(Config& config, const Line& line);

}  // namespace kat

#endif
