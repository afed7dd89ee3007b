// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"
#include "base/text/units.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

nlohmann::ordered_json number(double value) {
  if (std::isfinite(value)) return value;
  return "infinity";
}

nlohmann::ordered_json json_of_registry() {
  nlohmann::ordered_json effects = nlohmann::ordered_json::array();
  for (const physics::EffectEntry& entry : physics::effect_registry()) {
    nlohmann::ordered_json e;
    e["name"] = entry.info->name;
    e["mechanism"] = entry.info->mechanism;
    e["signature"] = entry.info->signature;
    e["parameters"] = nlohmann::ordered_json::array();
    for (const physics::EffectParameter& p : entry.info->parameters) {
      e["parameters"].push_back({{"name", p.name},
                                 {"unit", unit_of(p.name)},
                                 {"off", number(p.off)},
                                 {"typical", number(p.typical)},
                                 {"lower", number(p.lower)},
                                 {"upper", number(p.upper)},
                                 {"plausible_lower", number(p.plausible_lower)},
                                 {"plausible_upper", number(p.plausible_upper)},
                                 {"source", p.source}});
    }
    effects.push_back(e);
  }
  return {{"effects", effects}};
}

void run(const std::string& json) {
  if (!json.empty()) write_file(json, json_of_registry().dump(1) + "\n");
  for (const physics::EffectEntry& entry : physics::effect_registry()) {
    fmt::print("{}\n  mechanism  {}\n  signature  {}\n", entry.info->name, entry.info->mechanism,
               entry.info->signature);
    TextTable t({"  parameter", "unit", "off", "typical", "bounds", "plausible",
                 "source of the plausible range"});
    t.flush_left(1);
    t.flush_left(6);
    const auto range = [](double a, double b) { return fmt::format("{:g} .. {:g}", a, b); };
    for (const physics::EffectParameter& p : entry.info->parameters) {
      t.add({"  " + p.name, unit_of(p.name), fmt::format("{:g}", p.off),
             fmt::format("{:g}", p.typical), range(p.lower, p.upper),
             range(p.plausible_lower, p.plausible_upper), p.source});
    }
    fmt::print("{}\n", t.text());
  }
  fmt::print(
      "In a study: [model] effects = [\"NAME\"] "
      "and, for other values, [effect.NAME] PARAMETER = VALUE.\n"
      "In a LIGGGHTS script: fix ID all adhesion/effect NAME [values in this order].\n");
}

}  // namespace

void add_effects_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand("effects", "the physical effects that a study may switch on");
  auto json = std::make_shared<std::string>();
  c->add_option("--json", *json, "write the list to this file too");
  c->callback([json] { run(*json); });
}

}  // namespace powderlink::analysis
