// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_theory.h
/// Closed forms of the Kinetic Adhesion Test (KAT): critical diameter and adhesive energy.
///
///   instant stop       1/2 m v^2 = W(C->D), W = 1.0107 (9 pi^5 Gamma^5 R^4 / K^2)^(1/3)
///                      Gamma = v^(6/5) R_c (8 K^2 rho^3 / (3^5 pi^2 1.0107^3))^(1/5)  Eq. 4.5
///   slow stop          m a = 1.5 pi Gamma R, R_c^2 = 9 Gamma/(8 rho a), a: plate's deceleration
///   contact radius     Gamma = a0^3 K / (6 pi R^2)                                    Eq. 4.7
///   rebound time       Gamma = 8/9 rho R_c^2 v / t_d, t_d = t_r/2,
///                      t_r = 2.865 (m^2 / (R E*^2 v))^(1/5)                  Eqs. 2.4, 4.10
///   touch and go       1/2 m* v_s^2 = W(A->D)       (sticking speed of an undamped sphere)
///
/// Symbols: Gamma work of adhesion of the interface [J/m^2], K = 4/3 E* [Pa], R_c critical radius
/// [m], rho density of the sphere [kg/m^3], v impact speed [m/s], v_s sticking speed [m/s]; m mass
/// [kg], m* reduced mass (plate: the sphere's own); a0 contact radius at rest [m]; t_r duration of a
/// Hertzian rebound, t_d of the detachment [s]; a [m/s^2], W [J]. Points of the contact's curve:
/// A first touch, C equilibrium, D tear-off.
/// The factor 1.0107 is not rounded here: the energies come from JkrLaw.
/// Validity: JKR; instant: stop much shorter than the contact's period; slow: much longer.
/// Source: thesis of L. Pedrolli, Sections 2.1 and 4.2, with the errata of docs/theory.md.
/// Tests: tests/physics/kat_theory_test.cpp
#pragma once

#include <cmath>

#include "physics/contact/jkr_law.h"

namespace powderlink::physics {

inline double sphere_mass_kg(double radius_m, double density_kg_m3) {
  return 4.0 / 3.0 * JkrLaw::kPi * radius_m * radius_m * radius_m * density_kg_m3;
}

/// Work from the unloaded equilibrium to tear-off, 11.69 (Gamma^5 R*^4/E*^2)^(1/3) [J].
inline double detachment_work_J(const JkrLaw& law, double radius_m) {
  const double at_rest = std::sqrt(law.equilibrium_contact_radius_m(radius_m));
  const double at_tear_off = law.next_root(law.tear_off_overlap_m(radius_m), radius_m, at_rest);
  return law.energy_J(at_tear_off, radius_m) - law.energy_J(at_rest, radius_m);
}

/// Work lost in every touch and go, 7.09 (Gamma^5 R*^4/E*^2)^(1/3) [J].
inline double touch_and_go_work_J(const JkrLaw& law, double radius_m) {
  const double at_touch = law.first_root(0.0, radius_m);
  const double at_tear_off = law.next_root(law.tear_off_overlap_m(radius_m), radius_m, at_touch);
  return law.energy_J(at_tear_off, radius_m) - law.energy_J(at_touch, radius_m);
}

/// Impact speed that just detaches a sphere from an instantly stopped plate [m/s].
inline double critical_speed_instant_m_s(const JkrLaw& law, double radius_m, double density_kg_m3) {
  return std::sqrt(2.0 * detachment_work_J(law, radius_m) /
                   sphere_mass_kg(radius_m, density_kg_m3));
}

/// Critical diameter of the instant stop [m]. W ~ R^(4/3) and m ~ R^3, so d_c ~ v^(-6/5).
inline double critical_diameter_instant_m(const JkrLaw& law, double density_kg_m3,
                                          double speed_m_s) {
  const double v_of_unit_radius = critical_speed_instant_m_s(law, 1.0, density_kg_m3);
  return 2.0 * std::pow(v_of_unit_radius / speed_m_s, 1.2);
}

/// Eq. 4.5: Gamma from a critical diameter, instant stop [J/m^2]. W ~ Gamma^(5/3) for fixed R.
inline double adhesive_energy_instant_J_m2(double modulus_Pa, double density_kg_m3,
                                           double speed_m_s, double critical_diameter_m) {
  const double radius = 0.5 * critical_diameter_m;
  const double v_of_unit_energy =
      critical_speed_instant_m_s(JkrLaw(modulus_Pa, 1.0), radius, density_kg_m3);
  return std::pow(speed_m_s / v_of_unit_energy, 1.2);
}

/// Critical diameter of a stop that is slow for the contact, at plate deceleration a [m].
inline double critical_diameter_slow_m(double work_of_adhesion_J_m2, double density_kg_m3,
                                       double deceleration_m_s2) {
  return 2.0 * std::sqrt(9.0 * work_of_adhesion_J_m2 / (8.0 * density_kg_m3 * deceleration_m_s2));
}
inline double adhesive_energy_slow_J_m2(double density_kg_m3, double deceleration_m_s2,
                                        double critical_diameter_m) {
  const double radius = 0.5 * critical_diameter_m;
  return 8.0 / 9.0 * density_kg_m3 * radius * radius * deceleration_m_s2;
}

/// Eq. 4.7: Gamma from the contact radius of a resting sphere seen in the microscope [J/m^2].
inline double adhesive_energy_contact_radius_J_m2(double modulus_Pa, double radius_m,
                                                  double contact_radius_m) {
  return contact_radius_m * contact_radius_m * contact_radius_m * (4.0 / 3.0 * modulus_Pa) /
         (6.0 * JkrLaw::kPi * radius_m * radius_m);
}

/// Eq. 2.4: duration of a Hertzian rebound [s].
inline double rebound_time_s(double modulus_Pa, double density_kg_m3, double radius_m,
                             double speed_m_s) {
  const double m = sphere_mass_kg(radius_m, density_kg_m3);
  return 2.865 * std::pow(m * m / (radius_m * modulus_Pa * modulus_Pa * speed_m_s), 0.2);
}
/// Eq. 4.10: Gamma from the rebound time [J/m^2].
inline double adhesive_energy_rebound_J_m2(double modulus_Pa, double density_kg_m3,
                                           double speed_m_s, double critical_diameter_m) {
  const double radius = 0.5 * critical_diameter_m;
  const double detachment_time = 0.5 * rebound_time_s(modulus_Pa, density_kg_m3, radius, speed_m_s);
  return 8.0 / 9.0 * density_kg_m3 * radius * radius * speed_m_s / detachment_time;
}

}  // namespace powderlink::physics
