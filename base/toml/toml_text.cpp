// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/toml/toml_text.h"

#include <toml++/toml.h>

#include <sstream>

namespace powderlink {

std::string quoted(const std::string& text) {
  // Without flags: neither '...' nor """...""", which could have line breaks.
  const toml::value<std::string> value(text);
  std::ostringstream out;
  out << toml::default_formatter(value, toml::format_flags::none);
  return out.str();
}

}  // namespace powderlink
