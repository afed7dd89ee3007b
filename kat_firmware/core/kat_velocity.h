// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_velocity.h
/// Impact velocity from the beam, in whole numbers.
///
///   The carrier of height h blocks the beam for t; under gravity g its mean speed h/t is its speed at
///   half that time, so it enters with u = h/t - g t/2, and strikes the anvil, L below the beam, with
///       v^2 = u^2 + 2 g L
///   It leaves the beam with w = h/t + g t/2 and flies L - h = w T + g T^2/2 to the anvil:
///       T = 2 (L - h) / (w + v)
///
/// Symbols: h carrier_um, L beam_um from the beam to the anvil [um], t, T [us], u, v, w [um/s].
/// Validity: free fall, h <= L, u >= 0. Source: h/t at the beam and gravity over the rest of the drop,
/// L. Pedrolli, doctoral thesis, University of Deusto; half time and flight time are worked out here.
/// Rounding: below 1e-5 of v for t above 100 us. Tests: tests/kat_firmware/parts_test.cpp
#ifndef KAT_VELOCITY_H
#define KAT_VELOCITY_H

#include <stdint.h>

namespace kat {

enum : uint32_t { kGravity_um_s2 = 9806650 };

struct Fall {
  uint32_t velocity_um_s;  ///< at the anvil; 0: these times are no free fall
  uint32_t flight_us;      ///< from leaving the beam to the anvil
};

Fall free_fall(uint32_t carrier_um, uint32_t beam_um, uint32_t blocked_us);

/// Largest whole number whose square is not above `value`.
uint32_t square_root(uint64_t value);

/// Within `permille` of the expected flight and 50 us for the edges themselves.
bool flight_agrees(uint32_t measured_us, uint32_t expected_us, uint32_t permille);

}  // namespace kat

#endif
