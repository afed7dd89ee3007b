// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_drop.h
/// What one test gave, and the lines that carry it, for both ends of the protocol:
///
///   drop     n, fault, state (where it ended)
///   geometry n, carrier_um, beam_um, latency_us
///   beam     n, enter_us, leave_us                     since release
///   impact   n, touch_us, vibration_us, velocity_um_s, switches, peak_mg
///   contact  n, i, start_us, duration_us, chatter      one line per contact that was kept
///   end      n, contacts, finished, lines              how many lines came before: a cut report shows
///
/// Tests: tests/kat_firmware/drop_test.cpp
#ifndef KAT_DROP_H
#define KAT_DROP_H

#include <stdint.h>

#include "kat_codes.h"
#include "kat_contacts.h"
#include "kat_line.h"

namespace kat {

struct Drop {
  uint32_t number = 0;  ///< since the device was switched on; 0: none
  Code fault = Code::none;
  State state = State::idle;
  uint32_t carrier_um = 0, beam_um = 0, latency_us = 0;
  uint32_t enter_us = kNoValue, leave_us = kNoValue;  ///< since release
  uint32_t touch_us = kNoValue;                       ///< first contact
  uint32_t vibration_us = kNoValue;                   ///< the switch, latency included
  uint32_t velocity_um_s = kNoValue;  ///< at the anvil; only of a test without fault
  uint32_t switches = kNoValue;       ///< most that were closed since impact
  uint32_t peak_mg = kNoValue;
  Contacts contacts;

  uint8_t lines() const { return static_cast<uint8_t>(5 + contacts.kept()); }
};

/// Line i of drop.lines().
LineWriter drop_line(const Drop& drop, uint8_t i);

/// Puts a drop together from its lines.
class DropReader {
 public:
  enum class Result : uint8_t {
    other,   ///< no line of a drop
    more,    ///< taken
    whole,   ///< taken, and drop() is whole
    broken,  ///< a field is missing or wrong, or lines are missing or out of order
  };
  Result take(const Line& line);
  const Drop& drop() const { return drop_; }
  bool inside() const { return next_ > 0; }  ///< begun and not whole

 private:
  bool read(const Line& line, uint8_t kind);
  bool read_head(const Line& line);
  bool read_contact(const Line& line);
  bool read_end(const Line& line);

  Drop drop_;
  uint8_t next_ = 0;  // lines taken
  uint8_t contacts_ = 0;
};

}  // namespace kat

#endif
