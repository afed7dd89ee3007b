// SPDX-License-Identifier: GPL-3.0-or-later
/// \file effect_registry.h
/// All effects by name: what `powderlink effects` prints and what studies and scripts may switch
/// on. No two effects share a name, and no two parameters: fits, tables and JSON call them by it.
/// Tests: tests/physics/effects_test.cpp
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "physics/effects/effect.h"
#include "physics/effects/effects.def"

namespace powderlink::physics {

struct EffectEntry {
  const EffectInfo* info;
  std::function<std::unique_ptr<Effect>(const std::vector<double>& parameters)> make;
};

/// Throws InvalidInput for a name that is taken.
inline const std::vector<EffectEntry>& require_distinct_names(
    const std::vector<EffectEntry>& entries) {
  std::map<std::string, std::string> owner = {{"adhesive_energy_J_m2", "the interface"}};
  const auto take = [&](const std::string& name, const std::string& effect) {
    const auto [taken, is_new] = owner.emplace(name, effect);
    if (is_new) return;
    throw InvalidInput("effect " + effect + " of physics/effects/effects.def",
                       "the name '" + name + "', which " + taken->second + " has",
                       "names that no other effect or parameter has",
                       "rename it in its header, such as '" + effect + "_" + name + "'");
  };
  for (const EffectEntry& e : entries) take(e.info->name, e.info->name);
  for (const EffectEntry& e : entries) {
    for (const EffectParameter& p : e.info->parameters) take(p.name, e.info->name);
  }
  return entries;
}

inline const std::vector<EffectEntry>& effect_registry() {
  static const std::vector<EffectEntry> entries = {
#define POWDERLINK_EFFECT(NAME, CLASS)                                           \
  {&CLASS::info(), [](const std::vector<double>& p) -> std::unique_ptr<Effect> { \
     return std::make_unique<CLASS>(p);                                          \
   }},
#include "physics/effects/effects.def"
#undef POWDERLINK_EFFECT
  };
  static const std::vector<EffectEntry>& checked = require_distinct_names(entries);
  return checked;
}

/// Throws InvalidInput that lists the valid names.
inline const EffectEntry& find_effect(const std::string& name) {
  std::string names;
  for (const EffectEntry& e : effect_registry()) {
    if (e.info->name == name) return e;
    names += (names.empty() ? "" : ", ") + e.info->name;
  }
  throw InvalidInput("effect", "'" + name + "'", names, "see 'powderlink effects'");
}

/// Parameters must be given for all or for none (then the typical values are used).
inline std::unique_ptr<Effect> make_effect(const std::string& name,
                                           std::vector<double> parameters) {
  const EffectEntry& entry = find_effect(name);
  const auto& wanted = entry.info->parameters;
  if (parameters.empty()) {
    for (const EffectParameter& p : wanted) parameters.push_back(p.typical);
  }
  if (parameters.size() != wanted.size()) {
    std::string list;
    for (const EffectParameter& p : wanted) list += (list.empty() ? "" : " ") + p.name;
    throw InvalidInput(
        "effect " + name + ": number of parameters", std::to_string(parameters.size()),
        std::to_string(wanted.size()) + " (" + list + ")", "give all, in this order");
  }
  return entry.make(parameters);
}

}  // namespace powderlink::physics
