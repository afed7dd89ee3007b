// SPDX-License-Identifier: GPL-3.0-or-later
/// \file force_registry.h
/// All fluid-particle forces by name: what `constant/couplingProperties` may list.
/// Tests: tests/physics/fluid_forces/registry_test.cpp
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "physics/fluid_forces/force.h"
#include "physics/fluid_forces/forces.def"

namespace powderlink::forces {

struct ForceEntry {
  const ForceInfo* info;
  std::function<std::unique_ptr<Force>(const ForceSettings& settings)> make;
};

inline const std::vector<ForceEntry>& force_registry() {
  static const std::vector<ForceEntry> entries = {
#define POWDERLINK_FORCE(NAME, CLASS) \
  {&CLASS::info(),                    \
   [](const ForceSettings& s) -> std::unique_ptr<Force> { return std::make_unique<CLASS>(s); }},
#include "physics/fluid_forces/forces.def"
#undef POWDERLINK_FORCE
  };
  return entries;
}

/// Throws InvalidInput that lists the valid names.
inline const ForceEntry& find_force(const std::string& name) {
  std::string names;
  for (const ForceEntry& e : force_registry()) {
    if (e.info->name == name) return e;
    names += (names.empty() ? "" : ", ") + e.info->name;
  }
  throw InvalidInput("force", "'" + name + "'", names, "see docs/theory_coupling.md#forces");
}

}  // namespace powderlink::forces
