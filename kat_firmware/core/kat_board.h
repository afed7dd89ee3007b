// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_board.h
/// What the core needs of a board. Bound to pins by the sketch, to a simulated drop by the tests.
/// Tests: tests/kat_firmware/parts_test.cpp
#ifndef KAT_BOARD_H
#define KAT_BOARD_H

#include <stdint.h>

namespace kat {

class Board {
 public:
  virtual uint32_t now_us() = 0;  ///< wraps around after 71.6 minutes
  virtual void set_magnet(bool on) = 0;
  virtual void set_sensors(bool on) = 0;
  virtual bool beam_blocked() = 0;
  virtual bool contact_closed() = 0;
  /// Voltage of the switch chain, kNoValue where there is none.
  virtual uint32_t switch_mV() = 0;
  /// Magnitude of the anvil's acceleration in 0.001 g, kNoValue where there is no accelerometer.
  virtual uint32_t acceleration_mg() = 0;

 protected:
  ~Board() = default;  // never deleted through the interface: no heap
};

/// Closed switches of the chain: 18, 16, 12, 0 V for 3, 2, 1, 0; kNoValue for a voltage that is none
/// of them. Source: L. Pedrolli, doctoral thesis, University of Deusto.
uint32_t closed_switches(uint32_t switch_mV);

}  // namespace kat

#endif
