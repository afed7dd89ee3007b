// SPDX-License-Identifier: GPL-3.0-or-later
/// \file effect_registry.h
/// All effects by name: what `powderlink effects` prints and what studies and scripts may switch
/// on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/effect.h"
#include "models/effects.def"

namespace powderlink::models {

struct EffectEntry {
  const EffectInfo* info;
  std::function<std::unique_ptr<Effect>(const std::vector<double>& parameters)> make;
};

inline const std::vector<EffectEntry>& effect_registry() {
  static const std::vector<EffectEntry> entries = {
#define POWDERLINK_EFFECT(NAME, CLASS)                                           \
  {&CLASS::info(), [](const std::vector<double>& p) -> std::unique_ptr<Effect> { \
     return std::make_unique<CLASS>(p);                                          \
   }},
#include "models/effects.def"
#undef POWDERLINK_EFFECT
  };
  return entries;
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

}  // namespace powderlink::models
