// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_velocity.h"

namespace kat {

namespace {

const uint32_t kEdges_us = 50;
const uint32_t kLongest_us = 1000000;  // a carrier that takes a second is stuck, not falling

}  // namespace

uint32_t square_root(uint64_t value) {
  uint32_t root = 0;
  for (uint32_t bit = 0x80000000U; bit != 0; bit >>= 1) {
    const uint64_t tried = root | bit;
    if (tried * tried <= value) root |= bit;
  }
  return root;
}

Fall free_fall(uint32_t carrier_um, uint32_t beam_um, uint32_t blocked_us) {
  const Fall none = {0, 0};
  if (carrier_um == 0 || beam_um < carrier_um) return none;
  if (blocked_us == 0 || blocked_us > kLongest_us) return none;
  const uint64_t mean = (uint64_t(carrier_um) * 1000000U + blocked_us / 2U) / blocked_us;
  const uint64_t gained = (uint64_t(kGravity_um_s2) * blocked_us + 1000000U) / 2000000U;
  if (mean < gained || mean > UINT32_MAX / 2U) return none;
  const uint64_t enters = mean - gained;
  const uint32_t v = square_root(enters * enters + 2U * uint64_t(kGravity_um_s2) * beam_um);
  const uint64_t flight = 2U * uint64_t(beam_um - carrier_um) * 1000000U / (mean + gained + v);
  return {v, static_cast<uint32_t>(flight)};
}

bool flight_agrees(uint32_t measured_us, uint32_t expected_us, uint32_t permille) {
  const uint32_t off =
      measured_us > expected_us ? measured_us - expected_us : expected_us - measured_us;
  return off <= kEdges_us + static_cast<uint32_t>(uint64_t(expected_us) * permille / 1000U);
}

}  // namespace kat
