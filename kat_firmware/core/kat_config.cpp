// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_config.h"

#include "kat_line.h"
#include "kat_text.h"

namespace kat {

namespace {

const ConfigKey kKeys[kConfigKeys] = {
#define KAT_KEY(name, initial, smallest, largest) {#name, &Config::name, smallest, largest},
#include "kat_config.def"
#undef KAT_KEY
};

Code set_one(Config& config, const char* key, const char* text) {
  for (uint8_t i = 0; i < kConfigKeys; ++i) {
    if (!same_text(kKeys[i].name, key)) continue;
    uint32_t value = 0;
    if (!parse_u32(text, value)) return Code::bad_value;
    if (value < kKeys[i].smallest || value > kKeys[i].largest) return Code::out_of_range;
    config.*kKeys[i].value = value;
    return Code::none;
  }
  return Code::unknown_key;
}

}  // namespace

const ConfigKey& config_key(uint8_t i) { return kKeys[i]; }

Code set_config(Config& config, const Line& line) {
  if (line.fields() == 0) return Code::bad_value;
  Config changed = config;
  for (uint8_t i = 0; i < line.fields(); ++i) {
    const Code code = set_one(changed, line.key(i), line.value(i));
    if (code != Code::none) return code;
  }
  if (changed.beam_um < changed.carrier_um) return Code::beam_below_carrier;
  config = changed;
  return Code::none;
}

}  // namespace kat
