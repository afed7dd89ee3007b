// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_codes.h
/// Names of faults, refusals, damaged lines and states. Tests: tests/kat_firmware/line_test.cpp
#ifndef KAT_CODES_H
#define KAT_CODES_H

#include <stdint.h>

namespace kat {

enum class Code : uint8_t {
#define KAT_CODE(name, advice) name,
#include "kat_codes.def"
#undef KAT_CODE
  count
};

enum class State : uint8_t {
  idle,           ///< nothing powered
  self_test,      ///< sensors warm up, then are read once
  armed,          ///< magnet holds, sensors on
  released,       ///< magnet off, falling towards the beam
  beam_entered,   ///< the carrier blocks the beam
  beam_left,      ///< falling towards the anvil
  impact,         ///< struck: the contact is closed, or is waited for
  contact_ended,  ///< open again; more bounces may follow
  report,         ///< measured, lines on their way
  fault,          ///< safe; waits for the command clear
  count
};

const char* code_name(Code code);
const char* state_name(State state);

/// What to do, for people; in a file of its own so that the device need not keep it.
const char* code_advice(Code code);

/// Code::count and State::count for a name that is none.
Code find_code(const char* name);
State find_state(const char* name);

}  // namespace kat

#endif
