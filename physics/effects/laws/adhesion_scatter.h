// SPDX-License-Identifier: GPL-3.0-or-later
/// \file adhesion_scatter.h
/// Gamma differs from grain to grain: lognormal around the Gamma of the study.
///
///   ln(Gamma_i/Gamma) ~ N(0, s^2)
///   retained share of diameter d = P(Gamma_i > Gamma_c(d)) = Phi(ln(Gamma/Gamma_c(d))/s)
///
/// Gamma_c(d) is the Gamma at which d is the critical diameter. The median grain has Gamma, so d_c
/// as the 50 % point does not change; only the retained share over d widens.
/// Symbols: Gamma work of adhesion [J/m^2], of grain i Gamma_i; s standard deviation of ln Gamma [-],
/// Phi normal distribution function, d_c critical diameter [m].
/// Validity: grains independent of each other. DEM has one Gamma per pair of types and refuses it.
/// Source: M. Gotzinger, W. Peukert, Powder Technol. 130 (2003) 102 (spread of adhesion forces).
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(adhesion_scatter, AdhesionScatter)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_ADHESION_SCATTER_H
#define POWDERLINK_PHYSICS_EFFECTS_ADHESION_SCATTER_H

#include "physics/effects/effect.h"

namespace powderlink::physics {

class AdhesionScatter : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{"adhesion_scatter",
                              "Gamma differs from grain to grain (lognormal)",
                              "none in d_c; widens the retained share over d",
                              {{"log_std", 0.0, 0.3, 0.01, 3.0, 0.01, 1.5,
                                "adhesion forces of powders spread by 2 to 5 times"}},
                              "count what stays in every size class (kat_retention)"};
    return i;
  }

  explicit AdhesionScatter(const std::vector<double>& p) : log_std_(p.at(0)) {
    require_range(info(), 0, p[0]);
  }

  bool of_measurement() const override { return true; }
  double adhesion_log_std() const override { return log_std_; }

 private:
  double log_std_;
};

}  // namespace powderlink::physics
#endif
#endif
