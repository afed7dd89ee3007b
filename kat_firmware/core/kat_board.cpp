// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_board.h"

#include "kat_line.h"

namespace kat {

namespace {

/// Half the way to the neighbours; between 0 and 12 V, and above 18 V, 2 V to either side.
const struct {
  uint32_t from_mV, to_mV, closed;
} kBands[] = {{0, 2000, 0}, {10000, 14000, 1}, {14000, 17000, 2}, {17000, 20000, 3}};

}  // namespace

uint32_t closed_switches(uint32_t switch_mV) {
  for (const auto& band : kBands) {
    if (switch_mV >= band.from_mV && switch_mV < band.to_mV) return band.closed;
  }
  return kNoValue;
}

}  // namespace kat
