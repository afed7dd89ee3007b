// SPDX-License-Identifier: GPL-3.0-or-later
/// \file force_cases.h
/// The states that the tests of the forces share, and where their analytic checks are.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "physics/fluid_forces/force_registry.h"

namespace powderlink::test {

using AnalyticChecks = std::map<std::string, std::function<void()>>;
AnalyticChecks drag_checks();         // drag_test.cpp
AnalyticChecks other_force_checks();  // other_forces_test.cpp

/// Closed forms with a few powers: the last digits of a double.
constexpr double kRounding = 1e-12;

/// Argon at 20 C and 1 atm: the state that gives the terminal velocities of settling_test.cpp.
constexpr double kArgonDensity = 1.66;       // kg/m^3
constexpr double kArgonViscosity = 2.23e-5;  // Pa s
constexpr double kSteelDensity = 7950.0;     // kg/m^3
constexpr double kGravity = 9.81;            // m/s^2

inline std::unique_ptr<forces::Force> make_force(const std::string& name,
                                                 const forces::ForceSettings& settings = {}) {
  return forces::find_force(name).make(settings);
}

/// F + K (u - v) at the velocities given [N]; without the added mass's reaction.
inline forces::Vec3 total_force_N(const forces::ForceTerms& t, const forces::FluidState& f,
                                  const forces::ParticleState& p) {
  return forces::sum(t.force_N, forces::scaled(t.drag_kg_s, forces::slip_velocity_m_s(f, p)));
}
/// T + K_r Omega at the spins given [N m].
inline forces::Vec3 total_torque_Nm(const forces::ForceTerms& t, const forces::FluidState& f,
                                    const forces::ParticleState& p) {
  return forces::sum(t.torque_Nm,
                     forces::scaled(t.rotational_drag_Nms, forces::slip_spin_rad_s(f, p)));
}

inline forces::FluidState argon() {
  forces::FluidState f;
  f.density_kg_m3 = kArgonDensity;
  f.kinematic_viscosity_m2_s = kArgonViscosity / kArgonDensity;
  f.gravity_m_s2 = {0.0, 0.0, -kGravity};
  return f;
}

inline forces::ParticleState steel(double diameter_m = 75e-6) {
  forces::ParticleState p;
  p.diameter_m = diameter_m;
  p.density_kg_m3 = kSteelDensity;
  return p;
}

/// Argon that passes a particle at rest along x with the given Re_p and fluid fraction.
inline forces::FluidState flow_past(const forces::ParticleState& p, double reynolds,
                                    double fluid_fraction) {
  forces::FluidState f = argon();
  f.fluid_fraction = fluid_fraction;
  f.velocity_m_s = {reynolds * f.kinematic_viscosity_m2_s / (fluid_fraction * p.diameter_m), 0.0,
                    0.0};
  return f;
}

/// Every input of a force differs from zero and from every symmetry.
inline forces::FluidState busy_fluid() {
  forces::FluidState f = argon();
  f.fluid_fraction = 0.72;
  f.velocity_m_s = {1.3, -0.4, 2.1};
  f.velocity_curl_1_s = {900.0, 2100.0, -1500.0};
  f.pressure_gradient_Pa_m = {310.0, -120.0, 4633.0};
  f.viscous_stress_divergence_N_m3 = {-40.0, 15.0, 22.0};
  f.acceleration_m_s2 = {12.0, -7.0, 31.0};
  f.gravity_m_s2 = {1.1, -2.3, -9.1};
  return f;
}

inline forces::ParticleState busy_particle() {
  forces::ParticleState p = steel();
  p.velocity_m_s = {-0.6, 0.9, 0.2};
  p.spin_rad_s = {-300.0, 1200.0, 450.0};
  p.sphericity = 0.87;
  return p;
}

}  // namespace powderlink::test
