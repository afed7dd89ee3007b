// SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_radius.h
/// Gamma from the contact radius of grains at rest, seen under the microscope:
///
///   Gamma_i = a0^3 K/(6 pi R^2), Gamma their geometric mean; 95 % interval by Student's t of ln Gamma_i
///
/// The edge of the contact is read as the first ring between grain and plate. A sphere that does not
/// adhere at all shows rings too: the first bright one at sqrt(R lambda/2), the first dark one at
/// sqrt(R lambda). Where a0 agrees with one of them Gamma cannot be told from none.
/// Symbols: a0 contact radius [m], R radius of the grain [m], K = 4/3 E* [Pa], lambda wavelength [m].
/// Validity: JKR, no load, monochromatic light at normal incidence.
/// Source: thesis of L. Pedrolli, Eq. 4.7; rings: M. Born, E. Wolf, Principles of Optics, Section 7.5.
/// Tests: tests/analysis/kat/gamma_methods_test.cpp
#ifdef POWDERLINK_GAMMA_METHOD
POWDERLINK_GAMMA_METHOD(ContactRadiusAtRest)
#else
#ifndef POWDERLINK_ANALYSIS_LABORATORY_METHODS_CONTACT_RADIUS_H
#define POWDERLINK_ANALYSIS_LABORATORY_METHODS_CONTACT_RADIUS_H

#include <fmt/format.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/kat/experiment/gamma_method.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

inline double bright_ring_m(const ContactRadius& c) {
  return std::sqrt(0.5 * c.radius_m * c.wavelength_m);
}
inline double dark_ring_m(const ContactRadius& c) { return std::sqrt(c.radius_m * c.wavelength_m); }

struct ContactRadiusAtRest {
  static const GammaMethodInfo& info() {
    static const GammaMethodInfo i{
        "contact_radius",
        "contact radius",
        "Gamma = a0^3 K/(6 pi R^2)",
        "the first ring under the microscope is the edge of the contact",
        "JKR; a0 well apart from the rings of a sphere that does not adhere",
        "Pedrolli, Eq. 4.7",
        "--contact-radii"};
    return i;
  }

  static std::optional<GammaEstimate> estimate(const UncertainDrop& drop) {
    const auto& list = drop.best.contact_radii;
    if (list.empty()) return std::nullopt;
    const double n = static_cast<double>(list.size());
    double mean = 0.0, squares = 0.0, bright = 0.0, dark = 0.0;
    const auto log_gamma = [&](const ContactRadius& c) {
      return std::log(physics::adhesive_energy_contact_radius_J_m2(drop.best.modulus_Pa(),
                                                                   c.radius_m, c.contact_radius_m));
    };
    for (const ContactRadius& c : list) {
      mean += log_gamma(c) / n;
      bright += std::log(c.contact_radius_m / bright_ring_m(c)) / n;
      dark += std::log(c.contact_radius_m / dark_ring_m(c)) / n;
    }
    for (const ContactRadius& c : list) squares += std::pow(log_gamma(c) - mean, 2);
    GammaEstimate e;
    double half = 0.0;
    if (list.size() > 1) {
      const boost::math::students_t t(n - 1.0);
      half = boost::math::quantile(t, 0.975) * std::sqrt(squares / (n - 1.0) / n);
    } else {
      e.warnings.emplace_back(
          "contact radius: one grain only, so there is no interval; measure eight or more");
    }
    e.value = std::exp(mean);
    e.low = std::exp(mean - half);
    e.high = std::exp(mean + half);
    e.note = fmt::format(
        "{} grains; a0 is {:.3g} times the bright "
        "and {:.3g} times the dark ring of a sphere that does not adhere",
        list.size(), std::exp(bright), std::exp(dark));
    const auto judge = [&](double log_ratio, const char* ring) {
      if (std::fabs(log_ratio) > std::log1p(kReadingOfRing)) return;
      e.warnings.push_back(fmt::format(
          "contact radius: a0 agrees with the first {} ring of a sphere that does not adhere, "
          "to {:.2g} %; this Gamma cannot be told from none unless the rings are corrected for",
          ring, 100.0 * std::fabs(std::expm1(log_ratio))));
    };
    judge(bright, "bright");
    judge(dark, "dark");
    return e;
  }

  /// How well a ring is read: 0.3 um of resolution, 0.61 lambda/NA with a numerical aperture of 1, at
  /// rings of 3 um.
  static constexpr double kReadingOfRing = 0.1;
};

}  // namespace powderlink::analysis
#endif
#endif
