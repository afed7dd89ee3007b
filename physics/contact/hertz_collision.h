// SPDX-License-Identifier: GPL-3.0-or-later
/// \file hertz_collision.h
/// Depth and duration of a head-on collision of two spheres, or of a sphere and a plate, with
/// Hertz's force and a damping with which the restitution is the same at any speed.
///
///   m* d2(delta)/dt2 = -k delta^(3/2) - 2 zeta sqrt(5/4 m* k) delta^(1/4) d(delta)/dt
///   k = 4/3 E* sqrt(R*),   w = sqrt(5 k/(4 m*)),   q = sqrt(1 - zeta^2)
///
///   depth     delta_m = (15 m* v^2/(16 E* sqrt(R*)))^(2/5) exp(-4/5 zeta arccos(zeta)/q)
///   duration  t_c = (5 v/4)^(-1/5) (w q)^(-4/5) I(zeta/(5 q)),
///             I(p) = integral of exp(p x) sin(x)^(-1/5) dx, x = 0 .. pi
///   zeta = 0  t_c = 2.94327518432 delta_m/v, the factor: 4/5 sqrt(pi) Gamma(2/5)/Gamma(9/10)
///
/// They follow from the linear oscillator of spring_slider_dashpot.h: s = delta^(5/4), and
/// dt = s^(-1/5) d(tau) along s ~ exp(-zeta w tau) sin(q w tau).
/// Symbols: delta overlap, > 0 in contact [m], v speed of approach [m/s], zeta damping ratio [-],
/// 0 <= zeta < 1: -beta of normal_damping.h; R*, m* reduced radius [m] and mass [kg] (plate: the
/// sphere's own), E* effective modulus [Pa], k [N/m^(3/2)].
/// Validity: delta_m << R*, v far below the solid's speed of sound, no plastic flow, no adhesion.
/// Source: H. Hertz (1881), Johnson, Contact Mechanics, Section 11.4; D. Antypov and J. A. Elliott,
/// EPL 94 (2011) 50004.
/// Tests: tests/physics/collision_test.cpp
#pragma once

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

namespace powderlink::physics {

struct HertzCollision {
  double modulus_Pa;   ///< E*
  double radius_m;     ///< R*
  double mass_kg;      ///< m*
  double speed_m_s;    ///< of approach, > 0
  double damping = 0;  ///< zeta

  double greatest_overlap_m() const {
    const double undamped = std::pow(
        15.0 * mass_kg * speed_m_s * speed_m_s / (16.0 * modulus_Pa * std::sqrt(radius_m)), 0.4);
    return undamped * std::exp(-0.8 * damping * std::acos(damping) / root());
  }

  double duration_s() const {
    constexpr double pi = 3.14159265358979323846;
    const double stiffness = 4.0 / 3.0 * modulus_Pa * std::sqrt(radius_m);
    const double frequency = std::sqrt(1.25 * stiffness / mass_kg) * root();
    const double p = damping / (5.0 * root());
    // The second half of the range runs backwards, so that both ends of it are at x = 0.
    const auto integrand = [p](double x) {
      return (std::exp(p * x) + std::exp(p * (pi - x))) * std::pow(std::sin(x), -0.2);
    };
    const double integral =
        boost::math::quadrature::tanh_sinh<double>().integrate(integrand, 0.0, 0.5 * pi);
    return integral * std::pow(1.25 * speed_m_s, -0.2) * std::pow(frequency, -0.8);
  }

 private:
  double root() const { return std::sqrt((1.0 - damping) * (1.0 + damping)); }
};

}  // namespace powderlink::physics
