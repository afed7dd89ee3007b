// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/host/last_error.h"

namespace powderlink::host {

namespace {

std::string& kept() {
  static auto* text = new std::string;  // errors come until the very end of the process
  return *text;
}

}  // namespace

void keep_error(const std::string& text) { kept() = text; }
const std::string& kept_error() { return kept(); }

}  // namespace powderlink::host
