// SPDX-License-Identifier: GPL-3.0-or-later
/// \file rate_dependent_adhesion.h
/// The fracture energy of the interface grows with the speed of the contact edge.
///
///   Gamma(v) = Gamma (1 + (v/v*)^n),   v = -da/dt > 0 (edge receding)
///
/// The edge moves so that the energy release rate equals Gamma(v). An edge that advances follows
/// the equilibrium: dissipation only holds back an opening crack here.
/// Symbols: Gamma work of adhesion at rest [J/m^2], a contact radius [m], v* speed at which the
/// fracture energy has doubled [m/s], n exponent [-].
/// Validity: dissipation confined to the edge; da/dt well below the Rayleigh speed.
/// Source: D. Maugis, M. Barquins, J. Phys. D 11 (1978) 1989; K. Kendall, J. Adhesion 5 (1973) 179.
/// Tests: tests/physics/effects_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(rate_dependent_adhesion, RateDependentAdhesion)
#else
#ifndef POWDERLINK_PHYSICS_EFFECTS_RATE_DEPENDENT_ADHESION_H
#define POWDERLINK_PHYSICS_EFFECTS_RATE_DEPENDENT_ADHESION_H

#include <cmath>
#include <memory>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class RateDependentAdhesion : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{
        "rate_dependent_adhesion",
        "the fracture energy of the interface grows with the speed of the contact edge",
        "slope between -1.2 and about -0.9, the same at all v",
        {{"v_star_m_s", std::numeric_limits<double>::infinity(), 1.0, 1e-6, 1e6, 1e-6, 1e3,
          "elastomers 1e-6, rigid polymers and oxides up to the sound speed"},
         {"exponent", 0.0, 0.6, 0.05, 2.0, 0.1, 1.0, "Maugis and Barquins 1978: 0.6"}},
        "another temperature or a polymer plate changes it, a stiffer anvil does not"};
    return i;
  }

  explicit RateDependentAdhesion(const std::vector<double>& p)
      : v_star_(p.at(0)), exponent_(p.at(1)) {
    for (std::size_t i = 0; i < 2; ++i) require_range(info(), i, p[i]);
  }

  /// For tables of this law: any v* > 0 and n > 0, not only those that a fit may take.
  static std::shared_ptr<const Effect> unbounded(double v_star_m_s, double exponent) {
    const auto e = std::make_shared<RateDependentAdhesion>(std::vector<double>{1.0, 1.0});
    e->v_star_ = v_star_m_s;
    e->exponent_ = exponent;
    return e;
  }

  double v_star_m_s() const { return v_star_; }
  double exponent() const { return exponent_; }

  bool rate_dependent() const override { return std::isfinite(v_star_) && exponent_ > 0.0; }
  double fracture_energy_factor(double crack_speed) const override {
    if (!rate_dependent() || !(crack_speed > 0.0)) return 1.0;
    return 1.0 + std::pow(crack_speed / v_star_, exponent_);
  }

 private:
  double v_star_, exponent_;
};

}  // namespace powderlink::physics
#endif
#endif
