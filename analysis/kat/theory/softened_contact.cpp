// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/theory/softened_contact.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/kat/study/checks.h"
#include "physics/contact/hertz_collision.h"
#include "physics/contact/rayleigh_time.h"
#include "physics/contact/softened_adhesion.h"
#include "physics/contact/spring_slider_dashpot.h"
#include "physics/contact/tabor_parameter.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

using physics::JkrLaw;
using physics::Material;

namespace {

constexpr double kPrintedRestitution = 0.005;  // tables give two digits
constexpr double kPrintedModulus = 0.005;      // relative: three digits
constexpr double kGravity_m_s2 = 9.81;
constexpr double kLargestSpeed_m_s = 1000.0;

/// The contact at one modulus.
struct State {
  Material particle;
  double effective_modulus_Pa;
  std::optional<double> adhesive_energy_J_m2;
};

bool finite_positive(double value) { return value > 0.0 && std::isfinite(value); }

void require(bool good, const std::string& what, double given, const std::string& unit,
             const std::string& allowed, const std::string& to_do) {
  if (!good) throw InvalidInput(what, number_text(given) + " " + unit, allowed, to_do);
}

/// E'/E of the two options; nothing without either.
std::optional<double> softening(const SoftenedContactInput& in, double effective_modulus_Pa) {
  const double modulus = in.particle.youngs_modulus_Pa;
  const auto factor = [](const std::optional<double>& softened, double real, const char* option) {
    std::optional<double> ratio;
    if (softened) {
      require(finite_positive(*softened) && *softened <= real, std::string("contact: ") + option,
              *softened, "Pa", "above 0, at most the real one of " + number_text(real) + " Pa",
              "give a lower modulus in Pa; the real one is that of --particle and --substrate");
      ratio = *softened / real;
    }
    return ratio;
  };
  const auto by_modulus = factor(in.softened_modulus_Pa, modulus, "--softened-modulus");
  const auto by_effective = factor(in.softened_effective_modulus_Pa, effective_modulus_Pa,
                                   "--softened-effective-modulus");
  if (by_modulus && by_effective &&
      std::fabs(*by_modulus / *by_effective - 1.0) > kPrintedModulus) {
    throw InvalidInput(
        "contact: Young's modulus E and effective modulus E*",
        fmt::format("E {:g} Pa, which makes E* {:.4g} Pa, and E* {:g} Pa, which makes E {:.4g} Pa",
                    *in.softened_modulus_Pa, *by_modulus * effective_modulus_Pa,
                    *in.softened_effective_modulus_Pa, *by_effective * modulus),
        "one of the two, or a pair that agrees within 0.5 %",
        "keep --softened-modulus or --softened-effective-modulus");
  }
  return by_modulus ? by_modulus : by_effective;
}

std::vector<SoftenedQuantity> quantities_of(const SoftenedContactInput& in, const State& s) {
  const bool plate = in.substrate.has_value();
  const double radius = 0.5e-6 * in.diameter_um;
  const double mass = physics::sphere_mass_kg(radius, s.particle.density_kg_m3);
  const physics::HertzCollision collision{s.effective_modulus_Pa, plate ? radius : 0.5 * radius,
                                          plate ? mass : 0.5 * mass, in.speed_m_s,
                                          physics::damping_ratio_of_alpha(in.damping.alpha)};
  const double rayleigh = physics::rayleigh_time_s(radius, s.particle);
  const double step = in.rayleigh_fraction * rayleigh;
  const double duration = collision.duration_s();
  const double overlap = collision.greatest_overlap_m();
  std::vector<SoftenedQuantity> q;
  const auto add = [&q](const char* name, const char* label, const char* unit, double value) {
    q.push_back({name, label, unit, value, {}});
  };
  add("youngs_modulus_Pa", "Young's modulus of the grain E", "Pa", s.particle.youngs_modulus_Pa);
  add("effective_modulus_Pa", "effective modulus E*", "Pa", s.effective_modulus_Pa);
  add("rayleigh_time_s", "Rayleigh time", "s", rayleigh);
  add("time_step_s", "time step", "s", step);
  add("collision_time_s", "duration of the collision", "s", duration);
  add("steps_per_collision", "steps in it", "", duration / step);
  add("cloud_collision_time_s", "what OpenFOAM's clouds take for it", "s",
      physics::spring_slider_dashpot_time_s(collision.radius_m, s.particle.density_kg_m3,
                                            s.effective_modulus_Pa, in.speed_m_s));
  add("greatest_overlap_um", "greatest overlap", "um", 1e6 * overlap);
  add("greatest_overlap_percent", "  of the diameter", "%", 50.0 * overlap / radius);
  add("weight_speed_change_percent", "speed by weight meanwhile, of the impact's", "%",
      100.0 * kGravity_m_s2 * duration / in.speed_m_s);
  if (s.adhesive_energy_J_m2) {
    const JkrLaw jkr(s.effective_modulus_Pa, *s.adhesive_energy_J_m2);
    const double pull_off = jkr.pull_off_force_N(collision.radius_m);
    add("adhesive_energy_J_m2", "work of adhesion Gamma", "J/m^2", *s.adhesive_energy_J_m2);
    add("sticking_speed_m_s", "sticks up to (without damping)", "m/s",
        std::sqrt(2.0 * physics::touch_and_go_work_J(jkr, collision.radius_m) / collision.mass_kg));
    add("pull_off_N", "pull-off force", "N", pull_off);
    add("pull_off_over_weight", "  over the grain's weight", "", pull_off / (mass * kGravity_m_s2));
    add("neck_um", "neck at tear-off", "um", -1e6 * jkr.tear_off_overlap_m(collision.radius_m));
    add("tabor_parameter", "Tabor parameter", "",
        physics::tabor_parameter(collision.radius_m, *s.adhesive_energy_J_m2,
                                 s.effective_modulus_Pa));
  }
  return q;
}

std::vector<SoftenedError> errors_of(const std::vector<SoftenedQuantity>& quantities,
                                     double factor) {
  const auto find = [&](const std::string& name) -> const SoftenedQuantity* {
    for (const SoftenedQuantity& q : quantities) {
      if (q.name == name) return &q;
    }
    return nullptr;
  };
  const auto ratio = [&](const char* name) {
    const SoftenedQuantity& q = *find(name);
    return *q.softened / q.real;
  };
  const auto change = [&](const char* name) {
    const SoftenedQuantity& q = *find(name);
    return *q.softened - q.real;
  };
  std::vector<SoftenedError> e;
  const auto add = [&e](const char* name, const char* format, double value) {
    e.push_back({name, fmt::format(fmt::runtime(format), value), value});
  };
  add("time_step_factor", "{:.4g} times the time step", ratio("time_step_s"));
  add("collision_time_factor", "a collision lasts {:.4g} times as long", ratio("collision_time_s"));
  add("overlap_percent_of_diameter", "a grain sinks in deeper by {:.3g} % of its diameter",
      change("greatest_overlap_percent"));
  add("weight_speed_percent",
      "weight changes the speed in a collision by {:.2g} % of the impact's more",
      change("weight_speed_change_percent"));
  if (find("adhesive_energy_J_m2") != nullptr) {
    add("sticking_speed_percent",
        "with Gamma lowered as above the speed of sticking changes by {:.1g} %",
        100.0 * (ratio("sticking_speed_m_s") - 1.0));
    add("sticking_speed_factor_unchanged_adhesion",
        "with Gamma as it was it would be {:.3g} times as high", std::cbrt(1.0 / factor));
    add("pull_off_factor", "pull-off, the static force of adhesion, is {:.3g} of the real one",
        ratio("pull_off_N"));
    const SoftenedQuantity& tabor = *find("tabor_parameter");
    e.push_back({"tabor_factor",
                 fmt::format("the theory of adhesion that holds: "
                             "{} at the real modulus, {} at the lowered one",
                             physics::adhesion_theory(tabor.real),
                             physics::adhesion_theory(*tabor.softened)),
                 ratio("tabor_parameter")});
  }
  return e;
}

}  // namespace

Damping require_damping(std::optional<double> alpha, std::optional<double> restitution) {
  if (!alpha) {
    const double e = restitution.value_or(1.0);
    return {physics::alpha_of_restitution(e), e};
  }
  const double e = physics::restitution_of_alpha(*alpha);
  if (restitution) {
    const double other_alpha = physics::alpha_of_restitution(*restitution);
    if (std::fabs(e - *restitution) > kPrintedRestitution) {
      throw InvalidInput(
          "contact: alpha and restitution",
          fmt::format("alpha {:g}, which is a restitution of {:.4g}, "
                      "and restitution {:g}, which is an alpha of {:.4g}",
                      *alpha, e, *restitution, other_alpha),
          "one of the two, or a pair whose restitutions agree within 0.005",
          "keep --alpha, which OpenFOAM reads, or --restitution, which LIGGGHTS reads");
    }
  }
  return {*alpha, e};
}

SoftenedContact softened_contact(const SoftenedContactInput& in) {
  in.particle.validate();
  const Material& partner = in.substrate ? *in.substrate : in.particle;
  partner.validate();
  require_diameter_um(in.diameter_um, "contact");
  require(finite_positive(in.speed_m_s) && in.speed_m_s < kLargestSpeed_m_s, "contact: --velocity",
          in.speed_m_s, "m/s", "above 0 and below 1000 m/s", "give the speed of approach in m/s");
  require(finite_positive(in.rayleigh_fraction) &&
              in.rayleigh_fraction <= physics::kLargestRayleighFraction,
          "contact: --rayleigh-fraction", in.rayleigh_fraction, "Rayleigh times",
          "above 0, at most " + number_text(physics::kLargestRayleighFraction),
          "0.1 to 0.2 is usual");
  if (in.adhesive_energy_J_m2) require_adhesive_energy_J_m2(*in.adhesive_energy_J_m2, "contact");

  const double modulus = physics::effective_youngs_modulus_Pa(in.particle, partner);
  const std::optional<double> factor = softening(in, modulus);
  SoftenedContact out;
  out.quantities = quantities_of(in, {in.particle, modulus, in.adhesive_energy_J_m2});
  if (!factor) return out;

  State soft{in.particle, *factor * modulus, in.adhesive_energy_J_m2};
  soft.particle.youngs_modulus_Pa *= *factor;
  if (soft.adhesive_energy_J_m2) {
    soft.adhesive_energy_J_m2 = physics::softened_adhesion_J_m2(*soft.adhesive_energy_J_m2, modulus,
                                                                soft.effective_modulus_Pa);
  }
  out.softened_particle = soft.particle;
  if (in.substrate) {
    out.softened_substrate = in.substrate;
    out.softened_substrate->youngs_modulus_Pa *= *factor;
  }
  const auto softened = quantities_of(in, soft);
  for (std::size_t i = 0; i < softened.size(); ++i) out.quantities[i].softened = softened[i].real;
  out.errors = errors_of(out.quantities, *factor);
  return out;
}

}  // namespace powderlink::analysis
