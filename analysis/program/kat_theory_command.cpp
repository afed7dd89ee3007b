// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/study_material.h"
#include "analysis/kat/theory/kat_theory_report.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

struct Options {
  std::string particle, substrate, json;
  double velocity = 0.0, diameter = 0.0, energy = 0.0;
};

std::string table(const std::string& title, const std::vector<Quantity>& quantities) {
  TextTable t({title, "value", "unit", ""});
  t.flush_left(2);
  t.flush_left(3);
  for (const Quantity& q : quantities)
    t.add({q.label, fmt::format("{:.4g}", q.value), q.unit, q.note});
  return t.text();
}

nlohmann::ordered_json json_of(const KatTheoryReport& report, const KatTheoryInput& input,
                               const Options& o) {
  nlohmann::ordered_json j;
  j["particle"] = input.particle.name;
  j["substrate"] = input.substrate.name;
  j["impact_velocity_m_s"] = o.velocity;
  for (const auto* list : {&report.contact, &report.answers}) {
    for (const Quantity& q : *list) j[q.name] = q.value;
  }
  j["adhesion_theory"] = report.adhesion_theory;
  if (report.thesis != nullptr) {
    j["thesis"] = {{"printed_J_m2", report.thesis->printed_energy_J_m2},
                   {"recomputed_J_m2", report.answers.front().value},
                   {"difference", report.thesis->difference}};
  }
  return j;
}

void run(const CLI::App& command, const Options& o) {
  KatTheoryInput input{material_option(o.particle, "particle"),
                       material_option(o.substrate, "substrate"), o.velocity};
  if (command.count("--diameter") > 0) input.critical_diameter_um = o.diameter;
  if (command.count("--adhesive-energy") > 0) input.adhesive_energy_J_m2 = o.energy;
  const KatTheoryReport report = kat_theory_report(input);
  if (!o.json.empty()) write_file(o.json, json_of(report, input, o).dump(1) + "\n");

  fmt::print("{} on {}, impact at {:g} m/s\n\n", input.particle.name, input.substrate.name,
             o.velocity);
  fmt::print("{}\n",
             table(input.critical_diameter_um ? "adhesive energy Gamma by" : "critical diameter by",
                   report.answers));
  fmt::print("{}", table("contact", report.contact));
  if (report.thesis != nullptr) {
    const double recomputed = report.answers.front().value;
    fmt::print(
        "\nthe thesis prints {:.2f} J/m^2 for this drop, "
        "recomputed from its inputs {:.2f} J/m^2 ({:+.1f} %):\n{}\n",
        report.thesis->printed_energy_J_m2, recomputed,
        100.0 * (recomputed / report.thesis->printed_energy_J_m2 - 1.0), report.thesis->difference);
  }
  const std::string warning = adhesive_energy_warning(o.energy, "--adhesive-energy");
  if (!warning.empty()) fmt::print(stderr, "powderlink: {}\n", warning);
}

}  // namespace

void add_kat_theory_command(CLI::App& kat) {
  CLI::App* c = kat.add_subcommand(
      "theory",
      "closed forms of one drop: adhesive energy from a critical diameter, or the reverse");
  auto o = std::make_shared<Options>();
  const std::string names = material_option_help();
  c->add_option("--particle", o->particle, names)->required();
  c->add_option("--substrate", o->substrate, names)->required();
  c->add_option("--velocity", o->velocity, "impact velocity [m/s]")->required();
  CLI::Option* diameter = c->add_option("--diameter", o->diameter, "critical diameter [um]");
  c->add_option("--adhesive-energy", o->energy, "work of adhesion of the interface [J/m^2]")
      ->excludes(diameter);
  c->add_option("--json", o->json, "write the numbers to this file too");
  c->callback([c, o] { run(*c, *o); });
}

}  // namespace powderlink::analysis
