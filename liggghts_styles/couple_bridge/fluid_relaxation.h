// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fluid_relaxation.h
/// What the fluid does to a velocity (or spin) in one DEM step, as v' = a v + d.
///
///   M dv/dt = F + K (u - v),  x = K dt/M,  a = e^-x,  d = (1 - a) u + phi(x) dt F/M,
///   phi(x) = (1 - e^-x)/x
///
/// Symbols: M mass with added mass [kg] or moment of inertia [kg m^2], v velocity [m/s] or spin
/// [rad/s], u that of the fluid, K drag coefficient [kg/s] or [N m s], F explicit force [N] or
/// torque [N m], dt DEM step [s].
/// Validity: exact for K, u and F constant over the step, at any x; never overshoots. It is one part
/// of an operator split: forces of the script (contacts, weight) act in the integrator beside it, so
/// a terminal velocity under weight in LIGGGHTS is x/2 (relative) above the exact one for small x.
/// a and d hold as long as K, u, F and M do, so they are made once per exchange.
/// Source: physics/fluid_forces/semi_implicit_step.h, the same step (exponential Euler).
/// Tests: tests/liggghts_styles/fluid_relaxation_test.cpp; on falling spheres tests/physics/fluid_forces/settling_test.cpp
#pragma once

#include <cmath>

#include "physics/fluid_forces/semi_implicit_step.h"

namespace powderlink::host {

struct FluidRelaxation {
  double a = 1.0;
  double d[3] = {0.0, 0.0, 0.0};
};

/// \param u, force  three components each; k, mass, dt as above, mass > 0
inline FluidRelaxation fluid_relaxation(double k, const double* u, const double* force, double mass,
                                        double dt) {
  FluidRelaxation step;
  const double x = k * dt / mass;
  const double gain = -std::expm1(-x);  // 1 - a
  const double phi = forces::relaxation_mean(x);
  step.a = std::exp(-x);
  for (int c = 0; c < 3; ++c) step.d[c] = gain * u[c] + phi * dt / mass * force[c];
  return step;
}

}  // namespace powderlink::host
