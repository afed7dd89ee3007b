// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/study_material.h"
#include "analysis/kat/theory/softened_contact.h"
#include "analysis/program/commands.h"
#include "base/files/write_file.h"
#include "base/text/text_table.h"

namespace powderlink::analysis {

namespace {

struct Options {
  std::string particle, substrate, json;
  std::optional<double> alpha, restitution, diameter, velocity, modulus, effective_modulus, energy;
  double fraction = 0.2;
};

/// The collision, when it is asked for: then it needs grain, diameter and velocity.
std::optional<SoftenedContactInput> collision_of(const Options& o, const Damping& damping) {
  const bool grain = !o.particle.empty();
  if (!grain && o.substrate.empty() && !o.diameter && !o.velocity && !o.modulus &&
      !o.effective_modulus && !o.energy)
    return std::nullopt;
  if (!grain || !o.diameter || !o.velocity) {
    std::string missing;
    for (const auto& [there, name] :
         {std::pair(grain, "--particle"), std::pair(o.diameter.has_value(), "--diameter"),
          std::pair(o.velocity.has_value(), "--velocity")}) {
      if (!there) missing += std::string(missing.empty() ? "" : ", ") + name;
    }
    throw InvalidInput("contact: a collision", "no " + missing,
                       "--particle, --diameter and --velocity together", "add " + missing);
  }
  SoftenedContactInput in{material_option(o.particle, "particle")};
  if (!o.substrate.empty()) in.substrate = material_option(o.substrate, "substrate");
  in.diameter_um = *o.diameter;
  in.speed_m_s = *o.velocity;
  in.damping = damping;
  in.softened_modulus_Pa = o.modulus;
  in.softened_effective_modulus_Pa = o.effective_modulus;
  in.adhesive_energy_J_m2 = o.energy;
  in.rayleigh_fraction = o.fraction;
  return in;
}

nlohmann::ordered_json json_of(const Damping& damping,
                               const std::optional<SoftenedContactInput>& in,
                               const SoftenedContact& contact) {
  nlohmann::ordered_json j;
  j["alpha"] = damping.alpha;
  j["restitution"] = damping.restitution;
  if (!in) return j;
  j["particle"] = in->particle.name;
  j["substrate"] = in->substrate ? nlohmann::ordered_json(in->substrate->name) : nullptr;
  j["diameter_um"] = in->diameter_um;
  j["velocity_m_s"] = in->speed_m_s;
  for (const SoftenedQuantity& q : contact.quantities) {
    j["real"][q.name] = q.real;
    if (q.softened) j["softened"][q.name] = *q.softened;
  }
  for (const SoftenedError& e : contact.errors) j["change"][e.name] = e.value;
  return j;
}

void print(const SoftenedContactInput& in, const SoftenedContact& contact) {
  const bool soft = contact.softened_particle.has_value();
  fmt::print("\n{}, {:g} um, at {:g} m/s against {}\n", in.particle.name, in.diameter_um,
             in.speed_m_s,
             in.substrate ? "a plate of " + in.substrate->name : std::string("its like"));
  TextTable t(soft ? std::vector<std::string>{"", "real", "softened", "softened/real", "unit"}
                   : std::vector<std::string>{"", "real", "unit"});
  t.flush_left(soft ? 4 : 2);
  for (const SoftenedQuantity& q : contact.quantities) {
    std::vector<std::string> row = {q.label, fmt::format("{:.4g}", q.real)};
    if (q.softened) {
      row.push_back(fmt::format("{:.4g}", *q.softened));
      row.push_back(fmt::format("{:.4g}", *q.softened / q.real));
    }
    row.push_back(q.unit);
    t.add(row);
  }
  fmt::print("{}", t.text());
  if (!soft) return;
  fmt::print("\nwhat the lowered modulus changes:\n  restitution: nothing\n");
  for (const SoftenedError& e : contact.errors) fmt::print("  {}\n", e.text);
  fmt::print("\nboth bodies by the same factor: youngsModulus {:.4g} Pa of the grain",
             contact.softened_particle->youngs_modulus_Pa);
  if (contact.softened_substrate) {
    fmt::print(", {:.4g} Pa of the plate", contact.softened_substrate->youngs_modulus_Pa);
  }
  fmt::print("\n");
}

void run(const Options& o) {
  const Damping damping = require_damping(o.alpha, o.restitution);
  const std::optional<SoftenedContactInput> in = collision_of(o, damping);
  if (!in && !o.alpha && !o.restitution) {
    throw InvalidInput("contact", "neither a damping nor a collision",
                       "--alpha or --restitution; --particle, --diameter and --velocity; or both",
                       "powderlink contact --alpha 0.12");
  }
  const SoftenedContact contact = in ? softened_contact(*in) : SoftenedContact{};
  if (!o.json.empty()) write_file(o.json, json_of(damping, in, contact).dump(1) + "\n");

  fmt::print("OpenFOAM's spring-slider-dashpot: alpha {:.4g} (b 1.5)\n", damping.alpha);
  fmt::print("LIGGGHTS's hertz: coefficientRestitution {:.4g}\n", damping.restitution);
  if (in) print(*in, contact);
  if (o.energy) {
    const std::string warning = adhesive_energy_warning(*o.energy, "--adhesive-energy");
    if (!warning.empty()) fmt::print(stderr, "powderlink: {}\n", warning);
  }
}

}  // namespace

void add_contact_command(CLI::App& app) {
  CLI::App* c = app.add_subcommand(
      "contact", "OpenFOAM's contact beside LIGGGHTS's, and what a lowered modulus changes");
  auto o = std::make_shared<Options>();
  const std::string names = material_option_help();
  c->add_option("--alpha", o->alpha, "damping of OpenFOAM's spring-slider-dashpot");
  c->add_option("--restitution", o->restitution, "coefficient of restitution of LIGGGHTS's hertz");
  c->add_option("--particle", o->particle, names);
  c->add_option("--substrate", o->substrate, names + "; a plate of it (default: an equal grain)");
  c->add_option("--diameter", o->diameter, "of the grain [um]");
  c->add_option("--velocity", o->velocity, "speed of approach [m/s]");
  c->add_option("--softened-modulus", o->modulus, "lowered Young's modulus of the grain [Pa]");
  c->add_option("--softened-effective-modulus", o->effective_modulus,
                "lowered effective modulus E* [Pa]");
  c->add_option("--adhesive-energy", o->energy,
                "work of adhesion of the interface at the real modulus [J/m^2]");
  c->add_option("--rayleigh-fraction", o->fraction, "time step over Rayleigh time (0.2)");
  c->add_option("--json", o->json, "write the numbers to this file too");
  c->callback([o] { run(*o); });
}

}  // namespace powderlink::analysis
