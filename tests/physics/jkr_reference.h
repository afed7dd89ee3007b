// SPDX-License-Identifier: GPL-3.0-or-later
/// \file jkr_reference.h
/// JKR by another way than the law's Newton iteration: the universal form in x = a/a0,
///   x^2 - 2/3 sqrt(x) = y = delta R*/a0^2,   F = 6 pi Gamma R* (x^3 - x^(3/2)),
/// whose stable root is the closed form of a quartic in sqrt(x), here with 50 digits.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

namespace powderlink::test {

using Real = boost::multiprecision::cpp_dec_float_50;

inline Real cube_root(const Real& v) { return pow(v, Real(1) / 3); }

/// x on the stable branch, y > -0.2751606 (Ferrari's solution of s^4 - 2/3 s - y = 0, s = sqrt(x)).
inline Real universal_radius(const Real& y) {
  const Real discriminant = Real(1) / 1296 + y * y * y / 27;
  const Real u = cube_root(Real(1) / 36 + sqrt(discriminant));
  const Real m = u - y / (3 * u);  // root of the resolvent m^3 + y m - 1/18 = 0
  const Real p = sqrt(2 * m);
  const Real s = (p + sqrt(4 / (3 * p) - 2 * m)) / 2;
  return s * s;
}

/// One contact of given double values, evaluated without rounding.
struct JkrReference {
  Real modulus, gamma, radius;
  JkrReference(double modulus_Pa, double work_of_adhesion_J_m2, double radius_m)
      : modulus(modulus_Pa), gamma(work_of_adhesion_J_m2), radius(radius_m) {}

  static Real pi() { return boost::math::constants::pi<Real>(); }
  Real equilibrium_radius() const {
    return cube_root(9 * pi() * gamma * radius * radius / (2 * modulus));
  }
  Real unit_overlap() const {
    const Real a0 = equilibrium_radius();
    return a0 * a0 / radius;
  }
  Real pull_off() const { return 3 * pi() * gamma * radius / 2; }
  Real x(double overlap) const { return universal_radius(Real(overlap) / unit_overlap()); }
  Real contact_radius(double overlap) const { return x(overlap) * equilibrium_radius(); }
  Real force(double overlap) const {
    const Real q = x(overlap);
    return 6 * pi() * gamma * radius * (q * q * q - q * sqrt(q));
  }
  /// -0.2751606 a0^2/R*: -3 (1/36)^(2/3) in the universal form.
  Real tear_off() const { return -3 * cube_root(Real(1) / 1296) * unit_overlap(); }
};

}  // namespace powderlink::test
