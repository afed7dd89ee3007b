// SPDX-License-Identifier: GPL-3.0-or-later
/// \file semi_implicit_step.h
/// Mean of a velocity that relaxes towards the fluid's over one time step.
///
///   M dv/dt = F + K (u - v),   K and F of the step held, x = K dt / M
///   v' = v + phi(x) dt (F + K (u - v)) / M,   phi(x) = (1 - e^-x) / x
///
/// phi(x) is the mean of e^(-x s) over s in [0, 1]: the share of the impulse of the start's force that
/// the particle takes.
/// Symbols: M mass with added mass [kg] or moment of inertia [kg m^2], v velocity [m/s] or spin
/// [rad/s], u that of the fluid, K drag coefficient [kg/s] or [N m s], F explicit force [N] or
/// torque [N m].
/// Validity: any x >= 0; 1 at 0. The step is exact for constant K and tends to the terminal value
/// u + F/K for x -> infinity. With K taken at v the error is of first order, of second when K is taken
/// anew at the velocity of half a step.
/// Source: M. Hochbruck, A. Ostermann, Acta Numerica 19 (2010) 209 (exponential Euler).
/// Tests: tests/physics/fluid_forces/settling_test.cpp, tests/liggghts_styles/fluid_relaxation_test.cpp
#pragma once

#include <cmath>

namespace powderlink::forces {

inline double relaxation_mean(double x) { return x > 0.0 ? -std::expm1(-x) / x : 1.0; }

}  // namespace powderlink::forces
