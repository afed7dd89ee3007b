// SPDX-License-Identifier: GPL-3.0-or-later
/// \file adhesive_contact.h
/// One contact with memory: JKR, made rough or rate-dependent by the effects that are switched on.
///
/// The only memory is s = sqrt(a): 0 is "not in contact", anything else a live contact, in overlap
/// or in the neck. The same class advances a contact in LIGGGHTS and in the reduced model.
///
/// Rate dependence: the edge recedes with v = -da/dt such that its energy release rate equals
/// Gamma phi(v). Taken implicitly over the time step (backward Euler, first order, stable for any
/// ratio of step to edge speed); an edge that would advance follows the equilibrium at once.
/// Source: JkrLaw and the effects' own headers.
/// Tests: tests/models/adhesive_contact_test.cpp
#pragma once

#include <cmath>
#include <vector>

#include "models/effect.h"
#include "models/jkr_law.h"

namespace powderlink::models {

class AdhesiveContact {
 public:
  AdhesiveContact() = default;
  /// \param effects switched on; not owned, must outlive this object
  AdhesiveContact(const JkrLaw& smooth, const std::vector<const Effect*>& effects) : smooth_(smooth) {
    for (const Effect* e : effects) {
      effects_.push_back(e);
      rate_dependent_ = rate_dependent_ || e->rate_dependent();
    }
  }

  /// The law at reduced radius R*, Gamma reduced by roughness.
  JkrLaw law(double radius) const {
    double factor = 1.0;
    for (const Effect* e : effects_) factor *= e->adhesion_factor(radius);
    if (factor == 1.0) return smooth_;
    return JkrLaw(smooth_.effective_modulus_Pa(), factor * smooth_.work_of_adhesion_J_m2());
  }

  bool rate_dependent() const { return rate_dependent_; }

  /// New sqrt(a) at the given overlap, 0 when the contact ends; dt = 0 leaves a live edge in place.
  double advance(const JkrLaw& law, double overlap, double radius, double root, double dt) const {
    if (root == 0.0) return overlap >= 0.0 ? law.first_root(overlap, radius) : 0.0;
    if (rate_dependent_) {
      const double a = root * root;
      if (law.energy_release_rate_J_m2(a, overlap, radius) > law.work_of_adhesion_J_m2()) {
        return recede(law, overlap, radius, root, dt);
      }
      return law.torn(overlap, radius) ? root : law.first_root(overlap, radius);
    }
    return law.torn(overlap, radius) ? 0.0 : law.next_root(overlap, radius, root);
  }

  /// Force at the state that advance() returned [N].
  double force_N(const JkrLaw& law, double overlap, double radius, double root) const {
    return rate_dependent_ ? law.force_off_equilibrium_N(root * root, overlap, radius)
                           : law.force_N(root, radius);
  }

 private:
  /// Solves G(a) = Gamma phi((a_old - a)/dt) for a < a_old. On the stable branch the difference
  /// grows with a; when it stays positive down to a vanishing contact the edge has run through.
  double recede(const JkrLaw& law, double overlap, double radius, double root, double dt) const {
    const double a_old = root * root;
    if (dt <= 0.0) return root;
    const double gamma = law.work_of_adhesion_J_m2();
    const auto excess = [&](double a) {
      const double speed = (a_old - a) / dt;
      double factor = 1.0;
      for (const Effect* e : effects_) factor *= e->fracture_energy_factor(speed);
      return law.energy_release_rate_J_m2(a, overlap, radius) - gamma * factor;
    };
    const double floor = kSmallestContactFraction * std::cbrt(kTouchSlope * gamma * radius * radius /
                                                              law.effective_modulus_Pa());
    // March down until the sign changes (the largest root is the physical one), then bisect.
    double high = a_old;
    double low = a_old;
    double step = kFirstStepFraction * a_old;
    do {
      high = low;
      low = high - step;
      step *= 2.0;
      if (low <= floor) {
        if (floor >= high || excess(floor) > 0.0) return 0.0;
        low = floor;
        break;
      }
    } while (excess(low) > 0.0);
    return std::sqrt(bisect(excess, low, high));
  }

  template <class Function>
  static double bisect(const Function& f, double low, double high) {
    // Regula falsi with the Illinois weight: bracketed and superlinear.
    double f_low = f(low);
    double f_high = f(high);
    double x = high;
    int side = 0;
    for (int i = 0; i < 60 && (high - low) > 1e-12 * high; ++i) {
      x = (f_low * high - f_high * low) / (f_low - f_high);
      const double f_x = f(x);
      if (f_x > 0.0) {
        if (side == 1) f_low *= 0.5;
        high = x, f_high = f_x, side = 1;
      } else {
        if (side == -1) f_high *= 0.5;
        low = x, f_low = f_x, side = -1;
      }
      if (f_x == 0.0) break;
    }
    return x;
  }

  static constexpr double kTouchSlope = 6.283185307179586;       // a at first touch: (2 pi Gamma R^2/E*)^(1/3)
  static constexpr double kSmallestContactFraction = 0.02;       // of the first-touch radius
  static constexpr double kFirstStepFraction = 1e-3;
  JkrLaw smooth_;
  std::vector<const Effect*> effects_;
  bool rate_dependent_ = false;
};

}  // namespace powderlink::models
