// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_drop.h
/// What was measured of one drop, with its uncertainty: what the methods for Gamma start from.
#pragma once

#include <optional>
#include <vector>

#include "physics/contact/material.h"

namespace powderlink::analysis {

/// A grain at rest under the microscope.
struct ContactRadius {
  double contact_radius_m = 0.0;  ///< edge of the contact, read from the first ring
  double radius_m = 0.0;          ///< of the grain
  double wavelength_m = 0.0;      ///< of the light
};

struct KatDrop {
  physics::Material particle, substrate;
  double impact_velocity_m_s = 0.0;
  double critical_diameter_m = 0.0;
  std::optional<double> contact_time_s{};  ///< measured contact of carrier and anvil
  double plate_rebound = 0.0;              ///< speed of the plate after the stop over that before
  std::optional<double> deceleration_m_s2{};   ///< measured peak of the plate
  std::vector<ContactRadius> contact_radii{};  ///< of grains of the same powder on the same plate

  double radius_m() const { return 0.5 * critical_diameter_m; }
  double modulus_Pa() const { return physics::effective_youngs_modulus_Pa(particle, substrate); }
};

struct UncertainDrop {
  KatDrop best;
  /// The drop with one of its values at the low and at the high end of that value's 95 % interval.
  struct Ends {
    KatDrop low, high;
  };
  std::vector<Ends> ends;
};

}  // namespace powderlink::analysis
