// SPDX-License-Identifier: GPL-3.0-or-later
/// \file units.h
/// The unit that a name carries as its suffix: "tau_s" -> "s", "v_star_m_s" -> "m/s".
/// A name without one, such as "exponent", has "-".
/// Tests: tests/analysis/program/commands_test.cpp
#pragma once

#include <string>
#include <utility>

namespace powderlink {

/// The name without its unit, and the unit.
inline std::pair<std::string, std::string> split_unit(const std::string& name) {
  // Longest first: "_m_s" ends in "_s".
  static constexpr std::pair<const char*, const char*> units[] = {
      {"_kg_m3", "kg/m^3"}, {"_J_m2", "J/m^2"}, {"_C_m2", "C/m^2"}, {"_N_m", "N/m"},
      {"_m_s", "m/s"},      {"_Pa", "Pa"},      {"_um", "um"},      {"_us", "us"},
      {"_ns", "ns"},        {"_ms", "ms"},      {"_nm", "nm"},      {"_mm", "mm"},
      {"_s", "s"},          {"_m", "m"},        {"_N", "N"}};
  for (const auto& [suffix, unit] : units) {
    const std::string end(suffix);
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
      return {name.substr(0, name.size() - end.size()), unit};
  }
  return {name, "-"};
}

inline std::string unit_of(const std::string& name) { return split_unit(name).second; }
inline std::string without_unit(const std::string& name) { return split_unit(name).first; }

}  // namespace powderlink
