// SPDX-License-Identifier: GPL-3.0-or-later
/// \file effect.h
/// What an effect may change in the Kinetic Adhesion Test, and what is known about its parameters.
///
/// The baseline is JKR with a constant Gamma, an instant stop, from equilibrium. An effect is one
/// physical mechanism that the baseline leaves out. It overrides the hooks that it needs; the DEM
/// styles and the reduced model call the same hooks, so both speak of the same physics.
/// To add one: a header in physics/effects/laws/ and a line in physics/effects/effects.def (CONTRIBUTING.md).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/invalid_input.h"
#include "physics/contact/jkr_law.h"
#include "physics/kat/stop_pulse.h"

namespace powderlink::physics {

struct EffectParameter {
  std::string name;     ///< with the unit as suffix, e.g. "tau_s"
  double off;           ///< value at which the effect vanishes (infinity allowed)
  double typical;       ///< start of a fit
  double lower, upper;  ///< bounds of a fit
  double plausible_lower, plausible_upper;  ///< outside: possible to fit, hard to believe
  std::string source;                       ///< of the plausible range
};

struct EffectInfo {
  std::string name;
  std::string mechanism;  ///< one line
  std::string signature;  ///< in d_c(v), one line
  std::vector<EffectParameter> parameters;
  std::string decisive_test{};  ///< what to change on the device to see this effect, one line
};

class Effect {
 public:
  virtual ~Effect() = default;

  /// Gamma_eff / Gamma of an interface with reduced radius R* [-].
  virtual double adhesion_factor(double /*reduced_radius_m*/) const { return 1.0; }

  /// Gamma_eff / Gamma of a contact that its own pressure flattens [-]; the law is the smooth one.
  virtual double flattening_factor(const JkrLaw& /*law*/, double /*reduced_radius_m*/) const {
    return 1.0;
  }

  /// Fracture energy of an edge that recedes at the given speed, over Gamma [-]; must grow with it.
  virtual double fracture_energy_factor(double /*crack_speed_m_s*/) const { return 1.0; }
  virtual bool rate_dependent() const { return false; }

  /// Attraction across the gap h >= 0 between sphere and plate, beside JKR [N]; 0 or negative.
  virtual double gap_force_N(double /*gap_m*/, double /*radius_m*/) const { return 0.0; }
  /// Its potential, zero where the attraction ends (or at infinity); 0 or negative [J].
  virtual double gap_energy_J(double /*gap_m*/, double /*radius_m*/) const { return 0.0; }
  /// Gap beyond which the attraction is zero [m]; infinity for a long-range force.
  virtual double range_m(double /*radius_m*/) const { return 0.0; }
  /// True if a touch must come first and leaving the range ends it (a liquid bridge).
  virtual bool formed_by_touch() const { return false; }

  /// The stop that replaces the instant one.
  virtual std::optional<StopPulse> stop() const { return std::nullopt; }

  /// True for what changes the observation and not the contact of one grain: studies apply it to
  /// the outcome, a LIGGGHTS script refuses it.
  virtual bool of_measurement() const { return false; }
  /// What is read as the critical diameter when the contact's own is the given one [m].
  virtual double observed_diameter_m(double critical_diameter_m) const {
    return critical_diameter_m;
  }
  /// Standard deviation of ln Gamma from grain to grain [-].
  virtual double adhesion_log_std() const { return 0.0; }

 protected:
  static void require_range(const EffectInfo& info, std::size_t i, double value) {
    const EffectParameter& p = info.parameters.at(i);
    if (!(value >= p.lower && value <= p.upper) && value != p.off) {
      throw InvalidInput("effect " + info.name + ": " + p.name, number_text(value),
                         "between " + number_text(p.lower) + " and " + number_text(p.upper),
                         "see 'powderlink effects'");
    }
  }
};

}  // namespace powderlink::physics
