// SPDX-License-Identifier: GPL-3.0-or-later
/// \file jkr_law.h
/// Adhesive elastic contact of Johnson, Kendall and Roberts (JKR), full law with neck.
///
///   delta = a^2/R* - sqrt(2 pi Gamma a / E*)
///   F     = 4 E* a^3 / (3 R*) - sqrt(8 pi Gamma E* a^3)          (> 0 pushes apart)
///
/// Symbols: a contact radius [m], delta overlap [m] (> 0 when the undeformed surfaces
/// interpenetrate), R* reduced radius [m], E* effective Young's modulus [Pa],
/// Gamma work of adhesion of the INTERFACE [J/m^2] (gamma1 + gamma2 - gamma12; twice the surface
/// energy for like solids), so the pull-off force is 1.5 pi Gamma R*.
///
/// With s = sqrt(a) and c = sqrt(2 pi Gamma/E*) the law is polynomial, delta = s^4/R* - c s, and
/// needs neither the equilibrium radius a0 nor a cube root while a contact lives: s of the last
/// step is the start of one Halley step and, where that is not enough, of a Newton iteration. The
/// curve is convex on the stable branch: Newton approaches the root from above and cannot miss it.
///
/// Hysteresis: a contact starts at delta >= 0 and lives until delta < tear_off_overlap_m().
/// Validity: Tabor parameter above about 5, a << R*. Gamma = 0 gives Hertz.
/// Source: thesis of L. Pedrolli, Eqs. 3.24-3.25 (with the errata of docs/theory.md);
/// Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301.
/// Tests: tests/physics/jkr_law_test.cpp
#pragma once

#include <cmath>

namespace powderlink::physics {

class JkrLaw {
 public:
  JkrLaw() = default;
  JkrLaw(double effective_modulus_Pa, double work_of_adhesion_J_m2)
      : modulus_(effective_modulus_Pa),
        c_(std::sqrt(2.0 * kPi * work_of_adhesion_J_m2 / modulus_)) {}

  double effective_modulus_Pa() const { return modulus_; }
  double work_of_adhesion_J_m2() const { return c_ * c_ * modulus_ / (2.0 * kPi); }
  bool adhesive() const { return c_ > 0.0; }

  /// delta at which the neck breaks under controlled displacement (negative) [m].
  double tear_off_overlap_m(double radius) const { return -0.75 * c_ * tear_off_root(radius); }
  double tear_off_root(double radius) const { return std::cbrt(c_ * radius / 4.0); }  ///< sqrt(a)

  /// True once the neck is broken. Free of roots: it is called for every live neck in every step.
  bool torn(double overlap, double radius) const {
    const double c2 = c_ * c_;
    return overlap < 0.0 && -overlap * overlap * overlap > 27.0 / 256.0 * c2 * c2 * radius;
  }

  /// sqrt(a) on the stable branch for a contact without memory (first touch, or placed there).
  double first_root(double overlap, double radius) const {
    // An upper bound of the root: both terms of the law are overestimated by the sum.
    const double above =
        std::cbrt(c_ * radius) + std::sqrt(std::sqrt(std::fmax(overlap, 0.0) * radius));
    return next_root(overlap, radius, above);
  }

  /// sqrt(a) on the stable branch, from the value of the step before. Not to be called once torn().
  double next_root(double overlap, double radius, double root) const {
    if (halley(overlap, radius, root) || newton(overlap, radius, root)) return root;
    // A neck that was at the tear-off point itself, where Newton's slope vanishes: start from
    // above.
    root = upper_bound(overlap, radius);
    return newton(overlap, radius, root) ? root : tear_off_root(radius);
  }

  /// Normal force [N] from s = sqrt(a); positive pushes apart.
  double force_N(double root, double radius) const {
    const double cube = root * root * root;
    return modulus_ * cube * (4.0 / 3.0 * cube / radius - 2.0 * c_);
  }

  /// Energy stored by contact and neck, zero for separated surfaces [J]: the integral of F
  /// d(delta).
  double energy_J(double root, double radius) const {
    const double s2 = root * root;
    const double s4 = s2 * s2;
    const double s3_over_radius = s2 * root / radius;
    return modulus_ * s4 *
           (8.0 / 15.0 * s3_over_radius * s3_over_radius - 4.0 / 3.0 * c_ * s3_over_radius +
            0.5 * c_ * c_);
  }

  double overlap_m(double root, double radius) const {
    const double s2 = root * root;
    return s2 * s2 / radius - c_ * root;
  }

  double pull_off_force_N(double radius) const { return 0.75 * c_ * c_ * modulus_ * radius; }
  double equilibrium_contact_radius_m(double radius) const {
    return std::cbrt(2.25 * c_ * c_ * radius * radius);
  }
  /// dF/d(delta) at the unloaded equilibrium: 6/5 E* a0 [N/m].
  double equilibrium_stiffness_N_m(double radius) const {
    return 1.2 * modulus_ * equilibrium_contact_radius_m(radius);
  }

  static constexpr double kPi = 3.14159265358979323846;

 private:
  /// Above the root on the stable branch: either term of the law alone gives less.
  double upper_bound(double overlap, double radius) const {
    return std::cbrt(c_ * radius) + std::sqrt(std::sqrt(std::fmax(overlap, 0.0) * radius));
  }

  /// One step of third order: enough for a contact that moves as little as it does in a time step
  /// of 0.1 Rayleigh times. False, with `root` improved or as it was, when that is not sure.
  bool halley(double overlap, double radius, double& root) const {
    // The law times R: that factor cancels in every ratio, and a division is saved.
    const double square = root * root;
    const double slope = 4.0 * square * root - c_ * radius;
    const double curvature = 12.0 * square;
    const double value = square * square - (c_ * root + overlap) * radius;
    // Kantorovich's condition: the root is near and the slope does not vanish before it.
    if (!(slope > 0.0 && std::fabs(value * curvature) < 0.1 * slope * slope)) return false;
    const double step = 2.0 * value * slope / (2.0 * slope * slope - value * curvature);
    root -= step;
    // Halley's error after this step is below (f''/(2 f'))^2 step^3.
    return 0.25 * curvature * curvature * std::fabs(step * step * step) <=
           kHalleyError * root * slope * slope;
  }

  /// Moves root to the solution; false when the slope vanishes or the turns do not suffice.
  bool newton(double overlap, double radius, double& root) const {
    const double inv_radius = 1.0 / radius;
    const double four_inv_radius = 4.0 * inv_radius;
    for (int i = 0; i < kMaxIterations; ++i) {
      const double cube = root * root * root;
      const double slope = four_inv_radius * cube - c_;
      if (!(slope > 0.0)) return false;
      const double step = (cube * root * inv_radius - c_ * root - overlap) / slope;
      // Newton's error after this step is |f''/(2 f')| step^2; near tear-off f' vanishes and the
      // same estimate asks for more turns.
      const double error_times_slope = 6.0 * inv_radius * root * root * step * step;
      root -= step;
      if (error_times_slope <= kRelativeError * root * slope) return true;
    }
    return false;
  }

  static constexpr int kMaxIterations = 60;        // near tear-off Newton only halves the error
  static constexpr double kHalleyError = 1e-11;    // of sqrt(a); 6e-11 of the force
  static constexpr double kRelativeError = 1e-13;  // of sqrt(a)
  double modulus_ = 1.0;
  double c_ = 0.0;  ///< sqrt(2 pi Gamma / E*) [m^(1/2)]
};

}  // namespace powderlink::physics
