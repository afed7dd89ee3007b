// SPDX-License-Identifier: GPL-3.0-or-later
/// \file invalid_input.h
/// The one exception of the physics: a value that a user gave cannot be used.
/// Its text always has four parts, so that a message can be acted on without reading the source.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace powderlink {

/// A number as a user would write it: 1e-09, not 0.000000.
inline std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

class InvalidInput : public std::invalid_argument {
 public:
  /// \param what_failed  the quantity or step, e.g. "material 316L: density_kg_m3"
  /// \param given        the value as the user wrote it
  /// \param allowed      range or list of valid values
  /// \param to_do        the next thing to type
  InvalidInput(const std::string& what_failed, const std::string& given, const std::string& allowed,
               const std::string& to_do)
      : std::invalid_argument(what_failed + "; given: " + given + "; allowed: " + allowed +
                              "; to do: " + to_do) {}
};

}  // namespace powderlink
