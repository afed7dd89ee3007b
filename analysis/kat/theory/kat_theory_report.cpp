// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/theory/kat_theory_report.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/kat/study/checks.h"
#include "physics/contact/tabor_parameter.h"
#include "physics/kat/kat_theory.h"
#include "physics/kat/stop_pulse.h"

namespace powderlink::analysis {

using physics::JkrLaw;

namespace {

const double kStops_us[] = {50.0, 100.0, 200.0};  // the device's carrier-anvil contact times

std::string with_theory(const std::string& note, double radius, double energy, double modulus) {
  const double tabor = physics::tabor_parameter(radius, energy, modulus);
  return fmt::format("{}; Tabor {:.3g}: {}", note, tabor, physics::adhesion_theory(tabor));
}

}  // namespace

KatTheoryReport kat_theory_report(const KatTheoryInput& in) {
  const double v = require_velocity_m_s(in.impact_velocity_m_s, "kat theory");
  if (in.critical_diameter_um.has_value() == in.adhesive_energy_J_m2.has_value()) {
    throw InvalidInput("kat theory",
                       in.critical_diameter_um ? "a diameter and an adhesive energy"
                                               : "neither diameter nor adhesive energy",
                       "one of --diameter and --adhesive-energy", "give the one that you know");
  }
  in.particle.validate();
  in.substrate.validate();
  const double density = in.particle.density_kg_m3;
  const double modulus = physics::effective_youngs_modulus_Pa(in.particle, in.substrate);
  const bool from_diameter = in.critical_diameter_um.has_value();

  KatTheoryReport report;
  double radius = 0.0;
  double energy = 0.0;
  if (from_diameter) {
    const double d = require_diameter_um(*in.critical_diameter_um, "kat theory") * 1e-6;
    radius = 0.5 * d;
    energy = physics::adhesive_energy_instant_J_m2(modulus, density, v, d);
    const auto add = [&](const std::string& name, const std::string& label, double value,
                         const std::string& note) {
      report.answers.push_back(
          {name + "_J_m2", label, value, "J/m^2", with_theory(note, radius, value, modulus)});
    };
    add("adhesive_energy_instant", "instant stop", energy, "Eq. 4.5");
    add("adhesive_energy_rebound", "rebound time",
        physics::adhesive_energy_rebound_J_m2(modulus, density, v, d),
        fmt::format("Eq. 4.10, rebound of {:.4g} ns",
                    1e9 * physics::rebound_time_s(modulus, density, radius, v)));
    for (const double tau : kStops_us) {
      const double peak = physics::StopPulse::half_sine(tau * 1e-6).peak_deceleration_m_s2(v);
      add(fmt::format("adhesive_energy_slow_{:g}us", tau),
          fmt::format("half-sine stop of {:g} us", tau),
          physics::adhesive_energy_slow_J_m2(density, peak, d),
          fmt::format("slow limit, peak {:.3g} m/s^2", peak));
    }
    report.thesis =
        find_thesis_value(in.particle.name, in.substrate.name, v, *in.critical_diameter_um);
  } else {
    energy = require_adhesive_energy_J_m2(*in.adhesive_energy_J_m2, "kat theory");
    const JkrLaw law(modulus, energy);
    const auto add = [&](const std::string& name, const std::string& label, double metres,
                         const std::string& note) {
      report.answers.push_back({name + "_um", label, metres * 1e6, "um",
                                with_theory(note, 0.5 * metres, energy, modulus)});
    };
    const double d = physics::critical_diameter_instant_m(law, density, v);
    radius = 0.5 * d;
    add("critical_diameter_instant", "instant stop", d, "Eq. 4.5");
    // Gamma of Eq. 4.10 is proportional to the diameter.
    add("critical_diameter_rebound", "rebound time",
        d * energy / physics::adhesive_energy_rebound_J_m2(modulus, density, v, d), "Eq. 4.10");
    for (const double tau : kStops_us) {
      const double peak = physics::StopPulse::half_sine(tau * 1e-6).peak_deceleration_m_s2(v);
      add(fmt::format("critical_diameter_slow_{:g}us", tau),
          fmt::format("half-sine stop of {:g} us", tau),
          physics::critical_diameter_slow_m(energy, density, peak),
          fmt::format("slow limit, peak {:.3g} m/s^2", peak));
    }
  }

  const JkrLaw law(modulus, energy);
  const double mass = physics::sphere_mass_kg(radius, density);
  const double tabor = physics::tabor_parameter(radius, energy, modulus);
  const double period = 2.0 * JkrLaw::kPi * std::sqrt(mass / law.equilibrium_stiffness_N_m(radius));
  report.adhesion_theory = physics::adhesion_theory(tabor);
  report.contact = {
      {"effective_modulus_Pa", "effective modulus E*", modulus, "Pa", ""},
      {"k_Pa", "K = 4/3 E*", 4.0 / 3.0 * modulus, "Pa", ""},
      {"diameter_um", "diameter", 2e6 * radius, "um",
       from_diameter ? "given" : "d_c of the instant stop"},
      {"adhesive_energy_J_m2", "adhesive energy Gamma", energy, "J/m^2",
       from_diameter ? "of the instant stop" : "given"},
      {"mass_kg", "mass", mass, "kg", ""},
      {"pull_off_N", "pull-off force", law.pull_off_force_N(radius), "N", "1.5 pi Gamma R"},
      {"a0_um", "equilibrium contact radius a0", 1e6 * law.equilibrium_contact_radius_m(radius),
       "um", ""},
      {"period_s", "contact's own period", period, "s", "2 pi sqrt(m/k) at rest"},
      {"tabor_parameter", "Tabor parameter", tabor, "", report.adhesion_theory + " holds"},
  };
  return report;
}

}  // namespace powderlink::analysis
