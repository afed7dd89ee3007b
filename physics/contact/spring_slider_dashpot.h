// SPDX-License-Identifier: GPL-3.0-or-later
/// \file spring_slider_dashpot.h
/// The contact of OpenFOAM's colliding clouds (pairSpringSliderDashpot, wallSpringSliderDashpot),
/// and its damping alpha as a coefficient of restitution.
///
///   F_n = k delta^(3/2) + alpha sqrt(m* k) delta^(1/4) d(delta)/dt,   k = 4/3 E* sqrt(R*)
///
/// With s = delta^(5/4) and d(tau) = delta^(1/4) dt this is the linear oscillator
///   s'' + 2 zeta w s' + w^2 s = 0,   w^2 = 5 k/(4 m*),   zeta = alpha/sqrt 5
/// so that the restitution is that of the linear oscillator, at any speed, size and modulus:
///   e = exp(-pi zeta/sqrt(1 - zeta^2)),   alpha = -sqrt 5 ln e/sqrt(ln^2 e + pi^2)
/// The normal force is hence LIGGGHTS's hertz with coefficientRestitution e (normal_damping.h).
///
/// Tangentially both have Mindlin's spring k_t = 8 G* sqrt(R* delta), and the clouds damp it as they
/// do the normal direction. Where it exceeds mu |F_n| both slide with mu |F_n|; but the clouds then
/// empty the spring, and stick, with a dashpot that nothing limits, until it is full again, while
/// LIGGGHTS's history stays at the limit. At a steady slip v and load a cycle has n steps,
///   n = floor(mu |F_n|/(k_t v dt)) + 1,
///   mean F_t = (k_t v dt n (n - 1)/2 + (n - 1) eta v + mu |F_n|)/n
/// which is Coulomb's mu |F_n| for n = 1 and goes to mu |F_n|/2 + eta v as dt -> 0: the friction
/// of the clouds depends on their step, and grows with the speed.
///
/// Symbols: delta overlap, > 0 in contact [m], R* reduced radius [m], m* reduced mass [kg] (plate: the
/// sphere's own), E*, G* effective moduli [Pa], k [N/m^(3/2)], k_t [N/m], alpha, zeta, e [-], eta =
/// alpha sqrt(m* k) delta^(1/4) [kg/s], mu friction [-], v slip [m/s], dt the clouds' step [s].
/// Sign: F_n > 0 pushes apart; F_t acts against the slip.
/// Validity: exponent b = 1.5, no cohesionEnergyDensity; 0 <= alpha < sqrt 5, from where on grains do
/// not part.
/// Source: Y. Tsuji et al., Powder Technol. 71 (1992) 239; the oscillator: D. Antypov and J. A.
/// Elliott, EPL 94 (2011) 50004; the clouds: PairSpringSliderDashpot.C and
/// WallSpringSliderDashpot.C of OpenFOAM v1912.
/// Tests: tests/physics/collision_test.cpp, tests/liggghts_styles/slider_test.cpp (beside OpenFOAM itself)
#pragma once

#include <cmath>

#include "base/invalid_input.h"
#include "physics/contact/normal_damping.h"

namespace powderlink::physics {

inline constexpr double kSqrtFive = 2.2360679774997896964;

/// zeta of the clouds' alpha.
inline double damping_ratio_of_alpha(double alpha) {
  if (!(alpha >= 0.0 && alpha < kSqrtFive)) {
    throw InvalidInput("damping alpha of the spring-slider-dashpot contact", number_text(alpha),
                       "0 <= alpha < sqrt 5 = 2.23607, where grains stop to part",
                       "0.12 is a restitution of 0.845, 0 is no damping");
  }
  return alpha / kSqrtFive;
}

inline double restitution_of_alpha(double alpha) {
  constexpr double pi = 3.14159265358979323846;
  const double zeta = damping_ratio_of_alpha(alpha);
  return std::exp(-pi * zeta / std::sqrt((1.0 - zeta) * (1.0 + zeta)));
}

/// Refuses e outside 0 < e <= 1.
inline double alpha_of_restitution(double restitution) {
  return -kSqrtFive * damping_ratio(restitution);
}

/// F_n, > 0 pushes apart [N]; 0 without overlap.
inline double spring_slider_dashpot_force_N(double overlap_m, double overlap_rate_m_s,
                                            double modulus_Pa, double radius_m, double mass_kg,
                                            double alpha) {
  if (!(overlap_m > 0.0)) return 0.0;
  const double stiffness = 4.0 / 3.0 * modulus_Pa * std::sqrt(radius_m);
  return stiffness * overlap_m * std::sqrt(overlap_m) + alpha * std::sqrt(mass_kg * stiffness) *
                                                            std::sqrt(std::sqrt(overlap_m)) *
                                                            overlap_rate_m_s;
}

/// What the clouds take for the duration of a collision: collisionResolutionSteps divides it [s].
/// pi^(7/5) (5/4)^(2/5) R (rho/(E* sqrt v))^(2/5); pairs: R a quarter of the smallest diameter, v
/// twice the largest speed; walls: half of that diameter, and the largest speed.
inline double spring_slider_dashpot_time_s(double radius_m, double density_kg_m3, double modulus_Pa,
                                           double speed_m_s) {
  return 5.429675 * radius_m * std::pow(density_kg_m3 / (modulus_Pa * std::sqrt(speed_m_s)), 0.4);
}

/// What the tangential force of a contact depends on, during one step.
struct SliderLoad {
  double stiffness_N_m = 0.0;  ///< k_t
  double damping_kg_s = 0.0;   ///< eta
  double limit_N = 0.0;        ///< mu |F_n|
};

/// Advances the spring by a step at constant slip, in `parts` steps of the clouds.
/// \param slip_m_s  velocity of the contact point against the other body's, in the tangent plane
/// \param spring_m  in, out: what the spring has taken of the slip since it was last empty
/// \param force_N   out: mean force on the body over the step
inline void advance_slider(const SliderLoad& load, const double (&slip_m_s)[3], double step_s,
                           int parts, double (&spring_m)[3], double (&force_N)[3]) {
  const double part_s = step_s / parts;
  const double growth[3] = {slip_m_s[0] * part_s, slip_m_s[1] * part_s, slip_m_s[2] * part_s};
  const double full_m = load.limit_N / load.stiffness_N_m;
  double sum_m[3] = {0.0, 0.0, 0.0};  // of the springs that hold
  int slides = 0;
  for (int part = 0; part < parts; ++part) {
    double square = 0.0;
    for (int k = 0; k < 3; ++k) {
      spring_m[k] += growth[k];
      square += spring_m[k] * spring_m[k];
    }
    if (square > full_m * full_m) {
      ++slides;
      for (double& s : spring_m) s = 0.0;
    } else {
      for (int k = 0; k < 3; ++k) sum_m[k] += spring_m[k];
    }
  }
  const double speed =
      std::sqrt(slip_m_s[0] * slip_m_s[0] + slip_m_s[1] * slip_m_s[1] + slip_m_s[2] * slip_m_s[2]);
  const double drag =
      (parts - slides) * load.damping_kg_s + (speed > 0.0 ? slides * load.limit_N / speed : 0.0);
  for (int k = 0; k < 3; ++k) {
    force_N[k] = -(load.stiffness_N_m * sum_m[k] + drag * slip_m_s[k]) / parts;
  }
}

}  // namespace powderlink::physics
