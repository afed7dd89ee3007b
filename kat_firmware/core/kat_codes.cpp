// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_codes.h"

#include "kat_text.h"

namespace kat {

namespace {

const char* const kCodes[] = {
#define KAT_CODE(name, advice) #name,
#include "kat_codes.def"
#undef KAT_CODE
};

const char* const kStates[] = {"idle",         "self_test", "armed",  "released",
                               "beam_entered", "beam_left", "impact", "contact_ended",
                               "report",       "fault"};

static_assert(sizeof(kStates) / sizeof(kStates[0]) == static_cast<unsigned>(State::count),
              "every state has a name");

uint8_t find(const char* const* names, uint8_t count, const char* name) {
  uint8_t i = 0;
  while (i < count && !same_text(names[i], name)) ++i;
  return i;
}

}  // namespace

const char* code_name(Code code) { return kCodes[static_cast<uint8_t>(code)]; }

const char* state_name(State state) { return kStates[static_cast<uint8_t>(state)]; }

Code find_code(const char* name) {
  return static_cast<Code>(find(kCodes, static_cast<uint8_t>(Code::count), name));
}

State find_state(const char* name) {
  return static_cast<State>(find(kStates, static_cast<uint8_t>(State::count), name));
}

}  // namespace kat
