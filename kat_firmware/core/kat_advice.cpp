// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_codes.h"

namespace kat {

namespace {

const char* const kAdvice[] = {
#define KAT_CODE(name, advice) advice,
#include "kat_codes.def"
#undef KAT_CODE
};

}  // namespace

const char* code_advice(Code code) { return kAdvice[static_cast<uint8_t>(code)]; }

}  // namespace kat
