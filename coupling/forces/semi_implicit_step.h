// SPDX-License-Identifier: GPL-3.0-or-later
/// \file semi_implicit_step.h
/// One time step of a velocity (or spin) that relaxes towards the fluid's.
///
///   M dv/dt = F + K (u - v),   K and F of the step held, x = K dt / M
///
///   implicit_euler_velocity   v' = (M v + dt (F + K u)) / (M + dt K)
///   exponential_velocity      v' = v + phi(x) dt (F + K (u - v)) / M,  phi(x) = (1 - e^-x) / x
///
/// Symbols: M mass with added mass [kg] or moment of inertia [kg m^2], v velocity [m/s] or spin
/// [rad/s], u that of the fluid, K drag coefficient [kg/s] or [N m s], F explicit force [N] or
/// torque [N m].
/// Validity: any dt: both tend to the terminal value u + F/K for x -> infinity and never overshoot
/// it. With K taken at v the error is of first order for both; the exponential form is exact for
/// constant K, and of second order when K is taken anew at the velocity of half a step.
/// Source: E. Hairer, G. Wanner, Solving ODEs II, Section IV.3 (implicit Euler); M. Hochbruck, A.
/// Ostermann, Acta Numerica 19 (2010) 209 (exponential Euler).
/// Tests: tests/forces/settling_test.cpp
#pragma once

#include <cmath>

#include "coupling/forces/vec3.h"

namespace powderlink::forces {

inline Vec3 implicit_euler_velocity(const Vec3& v, const Vec3& fluid, double k, const Vec3& force,
                                    double mass, double dt) {
  const Vec3 pull = sum(force, scaled(k, difference(fluid, v)));
  return sum(v, scaled(dt / (mass + dt * k), pull));
}

/// phi(x) = (1 - e^-x) / x: the mean of e^(-x s) over s in [0, 1], 1 at x = 0.
inline double relaxation_mean(double x) { return x > 0.0 ? -std::expm1(-x) / x : 1.0; }

inline Vec3 exponential_velocity(const Vec3& v, const Vec3& fluid, double k, const Vec3& force,
                                 double mass, double dt) {
  const double x = k * dt / mass;
  const double phi = relaxation_mean(x);
  const Vec3 pull = sum(force, scaled(k, difference(fluid, v)));
  return sum(v, scaled(phi * dt / mass, pull));
}

}  // namespace powderlink::forces
