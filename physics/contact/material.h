// SPDX-License-Identifier: GPL-3.0-or-later
/// \file material.h
/// Elastic material of a sphere or plate, and the effective moduli of a pair.
///
///   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
///   1/G* = 2 (1 + nu1)(2 - nu1)/E1 + 2 (1 + nu2)(2 - nu2)/E2
///
/// Symbols: E Young's modulus [Pa], nu Poisson's ratio [-]; E*, G* effective moduli [Pa].
/// Validity: linear isotropic solids.
/// Source: Johnson, Contact Mechanics, Eqs. 4.20 and 7.43.
/// Tests: tests/physics/material_test.cpp
#pragma once

#include <cmath>
#include <string>

#include "base/invalid_input.h"

namespace powderlink::physics {

struct Material {
  std::string name;
  double density_kg_m3 = 0.0;
  double youngs_modulus_Pa = 0.0;
  double poissons_ratio = 0.0;

  /// Throws InvalidInput when a value is missing, negative or impossible.
  void validate() const {
    const auto require = [this](bool ok, const char* key, double value, const char* allowed) {
      if (!ok) {
        throw InvalidInput("material '" + name + "': " + key, number_text(value), allowed,
                           std::string("give ") + key + " in SI units");
      }
    };
    require(std::isfinite(density_kg_m3) && density_kg_m3 > 0, "density_kg_m3", density_kg_m3,
            "> 0 kg/m^3");
    require(std::isfinite(youngs_modulus_Pa) && youngs_modulus_Pa > 0, "youngs_modulus_Pa",
            youngs_modulus_Pa, "> 0 Pa");
    require(poissons_ratio > -1.0 && poissons_ratio <= 0.5, "poissons_ratio", poissons_ratio,
            "> -1 and <= 0.5");
  }

  double shear_modulus_Pa() const { return youngs_modulus_Pa / (2.0 * (1.0 + poissons_ratio)); }
};

inline double effective_youngs_modulus_Pa(const Material& a, const Material& b) {
  return 1.0 / ((1.0 - a.poissons_ratio * a.poissons_ratio) / a.youngs_modulus_Pa +
                (1.0 - b.poissons_ratio * b.poissons_ratio) / b.youngs_modulus_Pa);
}

inline double effective_shear_modulus_Pa(const Material& a, const Material& b) {
  return 1.0 / (2.0 * (1.0 + a.poissons_ratio) * (2.0 - a.poissons_ratio) / a.youngs_modulus_Pa +
                2.0 * (1.0 + b.poissons_ratio) * (2.0 - b.poissons_ratio) / b.youngs_modulus_Pa);
}

/// 1/R* = 1/R1 + 1/R2; for a plate R* is the sphere's own radius.
inline double reduced_radius_m(double r1_m, double r2_m) { return r1_m * r2_m / (r1_m + r2_m); }

}  // namespace powderlink::physics
