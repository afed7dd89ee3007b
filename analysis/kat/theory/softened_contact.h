// SPDX-License-Identifier: GPL-3.0-or-later
/// \file softened_contact.h
/// One contact as OpenFOAM's clouds and as LIGGGHTS describe it: damping alpha beside restitution,
/// and what a lowered modulus does to time step, collision and adhesion.
///
///   lowered   both bodies by the same factor f: E' = f E, E*' = f E*, Gamma' = Gamma f^(2/5)
///   partner   a plate where a substrate is given, else an equal grain (R* = R/2, m* = m/2)
///
/// Laws: physics/contact/spring_slider_dashpot.h, hertz_collision.h, softened_adhesion.h, rayleigh_time.h.
/// Tests: tests/analysis/kat/softened_contact_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/contact/material.h"

namespace powderlink::analysis {

struct Damping {
  double alpha;        ///< of OpenFOAM's spring-slider-dashpot
  double restitution;  ///< of LIGGGHTS's hertz
};

/// Of one of the two, or of both when they say the same; without either no damping. Throws
/// InvalidInput with both numbers when they contradict each other.
Damping require_damping(std::optional<double> alpha, std::optional<double> restitution);

struct SoftenedContactInput {
  physics::Material particle;
  std::optional<physics::Material> substrate{};  ///< the plate
  double diameter_um = 0.0;
  double speed_m_s = 0.0;  ///< of approach
  Damping damping{0.0, 1.0};
  std::optional<double> softened_modulus_Pa{};            ///< E' of the particle
  std::optional<double> softened_effective_modulus_Pa{};  ///< E*'; both only when they agree
  std::optional<double> adhesive_energy_J_m2{};           ///< Gamma at the real modulus
  double rayleigh_fraction = 0.2;                         ///< time step over Rayleigh time
};

struct SoftenedQuantity {
  std::string name;  ///< for JSON, with the unit as suffix
  std::string label, unit;
  double real;
  std::optional<double> softened;
};

struct SoftenedError {
  std::string name, text;
  double value;
};

struct SoftenedContact {
  std::optional<physics::Material> softened_particle, softened_substrate;
  std::vector<SoftenedQuantity> quantities;
  std::vector<SoftenedError> errors;  ///< what the lowered modulus changes; empty without one
};

/// Throws InvalidInput for what is not physical or contradicts itself.
SoftenedContact softened_contact(const SoftenedContactInput& input);

}  // namespace powderlink::analysis
