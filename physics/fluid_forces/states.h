// SPDX-License-Identifier: GPL-3.0-or-later
/// \file states.h
/// What a force may look at: the fluid around one particle, and the particle.
///
/// All fluid values are those of the undisturbed fluid, interpolated to the particle's centre.
/// Pressure is in Pa (a kinematic pressure of the solver times the fluid's density) and *dynamic*:
/// without the hydrostatic part rho_f g.x, which the force `buoyancy` accounts for. A solver whose
/// pressure holds that part hands over grad p - rho_f g.
/// Velocities are interstitial (not superficial) and refer to any common inertial frame.
/// Tests: tests/physics/fluid_forces/registry_test.cpp
#pragma once

#include <cmath>
#include <string>

#include "base/invalid_input.h"
#include "physics/fluid_forces/vec3.h"

namespace powderlink::forces {

constexpr double kPi = 3.14159265358979323846;

struct FluidState {
  Vec3 velocity_m_s{};                    ///< u, interstitial
  double density_kg_m3 = 0.0;             ///< rho_f
  double kinematic_viscosity_m2_s = 0.0;  ///< nu, molecular (not turbulent)
  double fluid_fraction = 1.0;            ///< alpha_f, volume of fluid per volume, (0, 1]
  Vec3 velocity_curl_1_s{};               ///< curl u
  Vec3 pressure_gradient_Pa_m{};          ///< grad p, p dynamic
  Vec3 viscous_stress_divergence_N_m3{};  ///< div tau, tau = mu (grad u + grad u^T) - ...
  Vec3 acceleration_m_s2{};               ///< Du/Dt, following the fluid
  Vec3 gravity_m_s2{};                    ///< g
};

struct ParticleState {
  Vec3 velocity_m_s{};         ///< v
  Vec3 spin_rad_s{};           ///< omega
  double diameter_m = 0.0;     ///< d; of the sphere of equal volume if not a sphere
  double density_kg_m3 = 0.0;  ///< rho_p
  double sphericity = 1.0;     ///< surface of the sphere of equal volume over its own, (0, 1]
};

inline double dynamic_viscosity_Pa_s(const FluidState& f) {
  return f.density_kg_m3 * f.kinematic_viscosity_m2_s;
}
inline double volume_m3(const ParticleState& p) {
  return kPi / 6.0 * p.diameter_m * p.diameter_m * p.diameter_m;
}
/// u - v [m/s].
inline Vec3 slip_velocity_m_s(const FluidState& f, const ParticleState& p) {
  return difference(f.velocity_m_s, p.velocity_m_s);
}
/// Omega = curl u / 2 - omega: rotation of the fluid relative to the particle [rad/s].
inline Vec3 slip_spin_rad_s(const FluidState& f, const ParticleState& p) {
  return difference(scaled(0.5, f.velocity_curl_1_s), p.spin_rad_s);
}
/// Re_p = alpha_f d |u - v| / nu [-].
inline double particle_reynolds(const FluidState& f, const ParticleState& p) {
  return f.fluid_fraction * p.diameter_m * norm(slip_velocity_m_s(f, p)) /
         f.kinematic_viscosity_m2_s;
}
/// Re_w = rho |curl u| d^2 / mu [-].
inline double shear_reynolds(const FluidState& f, const ParticleState& p) {
  return norm(f.velocity_curl_1_s) * p.diameter_m * p.diameter_m / f.kinematic_viscosity_m2_s;
}
/// Re_r = rho |Omega| d^2 / mu [-].
inline double rotation_reynolds(const FluidState& f, const ParticleState& p) {
  return norm(slip_spin_rad_s(f, p)) * p.diameter_m * p.diameter_m / f.kinematic_viscosity_m2_s;
}

namespace detail {
inline void require(bool holds, const char* what, double given, const char* allowed,
                    const char* to_do) {
  if (!holds)
    throw InvalidInput(std::string("fluid force: ") + what, number_text(given), allowed, to_do);
}
inline void require_positive(const char* what, double value) {
  require(value > 0.0 && std::isfinite(value), what, value, "> 0 and finite",
          "check the properties that the two codes exchange");
}
inline void require_share(const char* what, double value, const char* to_do) {
  require(value > 0.0 && value <= 1.0, what, value, "0 < value <= 1", to_do);
}
inline void require_finite(const char* what, const Vec3& value) {
  if (!finite(value))
    require(false, what, norm(value), "finite components",
            "the solution has diverged: lower the time step or the coupling interval");
}
}  // namespace detail

/// Throws InvalidInput for values with which no law makes sense.
inline void require_valid(const FluidState& f, const ParticleState& p) {
  detail::require_positive("fluid density_kg_m3", f.density_kg_m3);
  detail::require_positive("kinematic_viscosity_m2_s", f.kinematic_viscosity_m2_s);
  detail::require_share("fluid_fraction", f.fluid_fraction,
                        "smooth the fluid fraction or bound it from below");
  detail::require_positive("particle diameter_m", p.diameter_m);
  detail::require_positive("particle density_kg_m3", p.density_kg_m3);
  detail::require_share("sphericity", p.sphericity, "1 is a sphere");
  detail::require_finite("fluid velocity_m_s", f.velocity_m_s);
  detail::require_finite("particle velocity_m_s", p.velocity_m_s);
  detail::require_finite("particle spin_rad_s", p.spin_rad_s);
  detail::require_finite("velocity_curl_1_s", f.velocity_curl_1_s);
  detail::require_finite("pressure_gradient_Pa_m", f.pressure_gradient_Pa_m);
  detail::require_finite("viscous_stress_divergence_N_m3", f.viscous_stress_divergence_N_m3);
  detail::require_finite("acceleration_m_s2", f.acceleration_m_s2);
  detail::require_finite("gravity_m_s2", f.gravity_m_s2);
}

}  // namespace powderlink::forces
