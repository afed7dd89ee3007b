// SPDX-License-Identifier: GPL-3.0-or-later
/// \file owner_mark.h
/// A number that stands for the ID of a fix or region where only numbers are kept.
#pragma once

#include <cstdint>
#include <string>

namespace powderlink::host {

/// FNV-1a, 32 bits: a double holds it.
inline double mark_of(const std::string& owner) {
  std::uint32_t hash = 2166136261u;
  for (const char c : owner) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

}  // namespace powderlink::host
