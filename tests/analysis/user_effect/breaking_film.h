// SPDX-License-Identifier: GPL-3.0-or-later
/// \file breaking_film.h
/// An effect that is not in the catalogue: a film on the plate holds small grains harder; large ones
/// break it.
///
///   Gamma_eff = Gamma (1 + g / (1 + (R/R_b)^20))
///
/// Symbols: g surplus of the film [-], R_b radius above which it breaks [m]. Made up, as an example of
/// what a user adds: d_c(v) has a step that no other effect makes.
/// Source: none. Tests: tests/analysis/user_effect/user_effect_test.cpp
#ifdef POWDERLINK_EFFECT
POWDERLINK_EFFECT(breaking_film, BreakingFilm)
#else
#ifndef POWDERLINK_TESTS_BREAKING_FILM_H
#define POWDERLINK_TESTS_BREAKING_FILM_H

#include <cmath>

#include "physics/effects/effect.h"

namespace powderlink::physics {

class BreakingFilm : public Effect {
 public:
  static const EffectInfo& info() {
    static const EffectInfo i{"breaking_film",
                              "a film on the plate holds grains harder until they are large",
                              "a step in d_c",
                              {{"surplus", 0.0, 0.3, 0.01, 3.0, 0.0, 3.0, "made up"},
                               {"breaking_radius_m", 0.0, 2e-5, 1e-6, 1e-4, 1e-6, 1e-4, "made up"}},
                              "another plate"};
    return i;
  }
  explicit BreakingFilm(const std::vector<double>& p) : surplus_(p.at(0)), radius_(p.at(1)) {
    for (std::size_t i = 0; i < 2; ++i) require_range(info(), i, p[i]);
  }
  double adhesion_factor(double reduced_radius) const override {
    return 1.0 + surplus_ / (1.0 + std::pow(reduced_radius / radius_, 20.0));
  }

 private:
  double surplus_, radius_;
};

}  // namespace powderlink::physics
#endif
#endif
