// SPDX-License-Identifier: GPL-3.0-or-later
/// \file adhesive_contact.h
/// One contact with memory: JKR, made rough or rate-dependent by the effects that are switched on.
///
///   Gamma_eff = Gamma x the effects' adhesion and flattening factors
///   G(a, delta) = Gamma_eff phi(v),   v = -da/dt > 0        (rate dependence, edge receding)
///
/// The only memory is s = sqrt(a): 0 is "not in contact", anything else a live contact, in overlap
/// or in the neck. The same class advances a contact in LIGGGHTS and in the reduced model.
///
/// v is taken implicitly over the time step (backward Euler, first order, stable for any ratio of
/// step to edge speed); an edge that would advance follows the equilibrium at once.
/// Symbols: a contact radius [m], delta overlap [m], < 0 in the neck; Gamma work of adhesion
/// [J/m^2]; G energy release rate [J/m^2] (jkr_edge.h); phi fracture energy over Gamma_eff [-].
/// Sign: forces > 0 push apart. Validity: that of JKR and of the effects that are switched on.
/// Source: jkr_law.h, jkr_edge.h and the effects' own headers.
/// Tests: tests/physics/adhesive_contact_test.cpp
#pragma once

#include <cmath>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>

#include "physics/contact/jkr_edge.h"
#include "physics/contact/jkr_law.h"
#include "physics/effects/effect.h"

namespace powderlink::physics {

class AdhesiveContact {
 public:
  AdhesiveContact() = default;
  /// \param effects switched on; not owned, must outlive this object
  AdhesiveContact(const JkrLaw& smooth, const std::vector<const Effect*>& effects)
      : smooth_(smooth) {
    for (const Effect* e : effects) {
      effects_.push_back(e);
      rate_dependent_ = rate_dependent_ || e->rate_dependent();
    }
  }

  /// The law at reduced radius R*, with the Gamma that roughness and yield leave.
  JkrLaw law(double radius) const {
    double factor = 1.0;
    for (const Effect* e : effects_) {
      factor *= e->adhesion_factor(radius) * e->flattening_factor(smooth_, radius);
    }
    if (factor == 1.0) return smooth_;
    return JkrLaw(smooth_.effective_modulus_Pa(), factor * smooth_.work_of_adhesion_J_m2());
  }

  bool rate_dependent() const { return rate_dependent_; }

  /// New sqrt(a) at the given overlap, 0 when the contact ends; dt = 0 holds an edge that recedes.
  double advance(const JkrLaw& law, double overlap, double radius, double root, double dt) const {
    if (root == 0.0) return overlap >= 0.0 ? law.first_root(overlap, radius) : 0.0;
    if (rate_dependent_ && law.adhesive()) {
      const double a = root * root;
      // Deeper than a contact of this radius reaches, the edge is closed, not opened, however large
      // the energy release rate.
      const bool opened = a * a > overlap * radius;
      if (opened &&
          energy_release_rate_J_m2(law, a, overlap, radius) > law.work_of_adhesion_J_m2()) {
        return recede(law, overlap, radius, root, dt);
      }
      return law.torn(overlap, radius) ? root : law.first_root(overlap, radius);
    }
    return law.torn(overlap, radius) ? 0.0 : law.next_root(overlap, radius, root);
  }

  /// Force at the state that advance() returned [N].
  double force_N(const JkrLaw& law, double overlap, double radius, double root) const {
    return rate_dependent_ ? force_off_equilibrium_N(law, root * root, overlap, radius)
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
      return energy_release_rate_J_m2(law, a, overlap, radius) - gamma * factor;
    };
    const double floor = kSmallestContactFraction * std::cbrt(kTouchSlope * gamma * radius *
                                                              radius / law.effective_modulus_Pa());
    // March down until the sign changes (the largest root is the physical one).
    double high = a_old;
    double low = a_old;
    double at_high = excess(a_old);
    double at_low = at_high;
    double step = kFirstStepFraction * a_old;
    while (at_low > 0.0) {
      if (low <= floor) return 0.0;
      high = low;
      at_high = at_low;
      low = std::fmax(high - step, floor);
      at_low = excess(low);
      step *= 2.0;
    }
    if (low == high) return root;  // not above Gamma by more than rounding
    const auto close = [](double x, double y) { return y - x <= kRelativeError * y; };
    boost::uintmax_t turns = kMaxTurns;
    const auto edge =
        boost::math::tools::toms748_solve(excess, low, high, at_low, at_high, close, turns);
    return std::sqrt(0.5 * (edge.first + edge.second));
  }

  static constexpr double kTouchSlope =
      6.283185307179586;  // a at first touch: (2 pi Gamma R^2/E*)^(1/3)
  static constexpr double kSmallestContactFraction = 0.02;  // of the first-touch radius
  static constexpr double kFirstStepFraction = 1e-3;
  static constexpr double kRelativeError = 1e-12;  // of a
  static constexpr boost::uintmax_t kMaxTurns = 60;
  JkrLaw smooth_;
  std::vector<const Effect*> effects_;
  bool rate_dependent_ = false;
};

}  // namespace powderlink::physics
