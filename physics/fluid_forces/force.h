// SPDX-License-Identifier: GPL-3.0-or-later
/// \file force.h
/// One fluid-particle force: what it hands back, what is known about it, and how the two forms of
/// the volume-averaged equations share the pressure.
///
/// On one particle (m mass, I moment of inertia, V volume):
///
///   (m + m_a) dv/dt     = sum F + (sum K) (u - v)
///   I         domega/dt = sum T + (sum K_r) (curl u / 2 - omega)
///
/// K and K_r are handed back instead of K (u - v), so that the host can take the current v and
/// omega (semi_implicit_step.h). Both are never negative: they only dissipate.
///
/// Model A (pressure shared): the fluid feels -alpha_f grad p + alpha_f div tau, the particle
/// V (-grad p + div tau) by `pressure_gradient` and `viscous_stress`, and drag K_A (u - v).
/// Model B (pressure in the fluid only): the fluid feels -grad p + div tau, the particle only drag
/// K_B (u - v), and these two forces are zero. In steady uniform flow n K (u - v) = -alpha_f grad p
/// in A and -grad p in B, with n particles per volume, so that
///
///   K_B = K_A / alpha_f
///
/// Every drag law here is written as K_A; DragLaw divides once, when the settings say B.
/// What the fluid gets back is minus the particle's F + K (u - v) of drag, lift and virtual mass;
/// not `pressure_gradient` and `viscous_stress` (in A the fluid's alpha_f has counted them), and
/// not `buoyancy` (the dynamic pressure and the weight have).
/// Source: D. Gidaspow, Multiphase Flow and Fluidization (1994), Chapter 2 (A and B); Z.Y. Zhou,
/// S.B. Kuang, K.W. Chu, A.B. Yu, J. Fluid Mech. 661 (2010) 482, sets II (A) and III (B).
/// Tests: tests/physics/fluid_forces/registry_test.cpp, tests/physics/fluid_forces/packed_bed_test.cpp
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "physics/fluid_forces/states.h"

namespace powderlink::forces {

struct ForceTerms {
  double drag_kg_s = 0.0;        ///< K
  Vec3 force_N{};                ///< F, explicit
  Vec3 torque_Nm{};              ///< T, explicit
  double rotational_drag_Nms{};  ///< K_r
  double added_mass_kg = 0.0;    ///< m_a
};

inline ForceTerms& operator+=(ForceTerms& a, const ForceTerms& b) {
  a.drag_kg_s += b.drag_kg_s;
  a.force_N = sum(a.force_N, b.force_N);
  a.torque_Nm = sum(a.torque_Nm, b.torque_Nm);
  a.rotational_drag_Nms += b.rotational_drag_Nms;
  a.added_mass_kg += b.added_mass_kg;
  return a;
}

enum class MomentumModel { A, B };

struct ForceSettings {
  MomentumModel model = MomentumModel::A;
  /// True when the DEM code applies m g itself (fix gravity): `buoyancy` is then -rho_f V g only.
  bool weight_in_dem = false;
  double virtual_mass_coefficient = 0.5;  ///< C_vm, of a sphere 1/2
};

enum class ForceKind { drag, pressure, body, inertia, lift, rotation };

struct ForceInfo {
  std::string name;
  ForceKind kind;
  std::string law;                  ///< one line
  std::string validity;             ///< one line
  std::string source;               ///< one line
  std::vector<std::string> fields;  ///< members of FluidState beyond velocity and properties
  bool reacts_on_fluid;             ///< its opposite is a source of the fluid's momentum
};

class Force {
 public:
  virtual ~Force() = default;
  /// Throws InvalidInput when the states are not physical.
  ForceTerms evaluate(const FluidState& f, const ParticleState& p) const {
    require_valid(f, p);
    return terms(f, p);
  }
  /// For states that have passed require_valid: several laws of one particle need that once.
  ForceTerms evaluate_valid(const FluidState& f, const ParticleState& p) const {
    return terms(f, p);
  }

 protected:
  virtual ForceTerms terms(const FluidState& f, const ParticleState& p) const = 0;
};

/// A drag law gives only the factor over Stokes: K_A = 3 pi mu d * stokes_factor.
class DragLaw : public Force {
 public:
  explicit DragLaw(const ForceSettings& s) : model_(s.model) {}
  /// \param reynolds Re_p = alpha_f d |u - v| / nu, \param fluid_fraction alpha_f
  virtual double stokes_factor(double reynolds, double fluid_fraction, double sphericity) const = 0;

 protected:
  ForceTerms terms(const FluidState& f, const ParticleState& p) const override {
    ForceTerms t;
    t.drag_kg_s = 3.0 * kPi * dynamic_viscosity_Pa_s(f) * p.diameter_m *
                  stokes_factor(particle_reynolds(f, p), f.fluid_fraction, p.sphericity);
    if (model_ == MomentumModel::B) t.drag_kg_s /= f.fluid_fraction;
    return t;
  }

 private:
  MomentumModel model_;
};

}  // namespace powderlink::forces
