// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure drop of a fixed bed, summed over its particles, in both forms of the averaged equations.
//
// Momentum of the gas in the bed (steady, uniform): pressure drop times the whole cross-section is
// the sum of all forces on the particles.
//   A: drag K_A (u - v) and V (-grad p) on each particle;  B: drag K_B (u - v) only.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/physics/fluid_forces/force_cases.h"

namespace powderlink {
namespace {

using forces::FluidState;
using forces::ForceSettings;
using forces::ForceTerms;
using forces::MomentumModel;
using forces::ParticleState;
using test::kRounding;
using test::make_force;

constexpr double kVoid = 0.4513, kHeight = 15.6e-3, kFlux = 0.002;
constexpr double kDensity = 10.0, kKinematicViscosity = 1.5e-4, kDiameter = 1e-3;
constexpr double kPrintedDrop = 22.99;  // Pa
/// Half a digit of the void fraction (5e-5) moves Ergun's drop by 10.3 times that; and the print.
constexpr double kPrint = 10.3 * 5e-5 * kPrintedDrop + 0.005;

ParticleState bead() {
  ParticleState p;
  p.diameter_m = kDiameter;
  p.density_kg_m3 = 2500.0;
  return p;
}

FluidState gas(double flux = kFlux) {
  FluidState f;
  f.density_kg_m3 = kDensity;
  f.kinematic_viscosity_m2_s = kKinematicViscosity;
  f.fluid_fraction = kVoid;
  f.velocity_m_s = {0.0, 0.0, flux / kVoid};
  return f;
}

/// Particles per cross-section of the bed [1/m^2].
double particles_per_area() { return (1 - kVoid) * kHeight / forces::volume_m3(bead()); }

double drop_model_a(const std::string& law, double flux = kFlux) {
  const double drag = make_force(law)->evaluate(gas(flux), bead()).drag_kg_s * flux / kVoid;
  return particles_per_area() * drag / kVoid;  // the gas's own share of the drop is alpha_f
}

double drop_model_b(const std::string& law, double flux = kFlux) {
  ForceSettings b;
  b.model = MomentumModel::B;
  return particles_per_area() * make_force(law, b)->evaluate(gas(flux), bead()).drag_kg_s * flux /
         kVoid;
}

double ergun(double flux) {
  const double solid = 1 - kVoid, mu = kDensity * kKinematicViscosity;
  return kHeight * (150 * mu * solid * solid * flux / (std::pow(kVoid, 3) * kDiameter * kDiameter) +
                    1.75 * kDensity * solid * flux * flux / (std::pow(kVoid, 3) * kDiameter));
}

TEST(PackedBed, GidaspowGivesErgunInBothModels) {
  for (const double flux : {1e-4, kFlux, 0.0145, 1.0}) {
    EXPECT_NEAR(drop_model_a("gidaspow", flux), ergun(flux), kRounding * ergun(flux));
    EXPECT_NEAR(drop_model_b("gidaspow", flux), ergun(flux), kRounding * ergun(flux));
  }
  EXPECT_NEAR(drop_model_a("gidaspow"), kPrintedDrop, kPrint);
}

TEST(PackedBed, PressureDropTimesAreaIsTheSumOfTheForces) {
  for (const MomentumModel model : {MomentumModel::A, MomentumModel::B}) {
    ForceSettings s;
    s.model = model;
    FluidState f = gas();
    f.pressure_gradient_Pa_m = {0.0, 0.0, -ergun(kFlux) / kHeight};
    ForceTerms t = make_force("gidaspow", s)->evaluate(f, bead());
    t += make_force("pressure_gradient", s)->evaluate(f, bead());
    const double all = particles_per_area() * test::total_force_N(t, f, bead())[2];
    EXPECT_NEAR(all, ergun(kFlux), kRounding * ergun(kFlux));
  }
}

TEST(PackedBed, LatticeBoltzmannLawsGiveCarmanKozeny) {
  // 180 in place of Ergun's 150: 10 phi/(1 - phi)^3 at Re -> 0.
  const double solid = 1 - kVoid, mu = kDensity * kKinematicViscosity;
  const double flux = 1e-6;
  const double carman =
      kHeight * 180 * mu * solid * solid * flux / (std::pow(kVoid, 3) * kDiameter * kDiameter);
  constexpr double inertia = 1e-5;      // Re is 7e-6
  constexpr double dilute_term = 0.02;  // Beetstra's alpha_f^2 (1 + 1.5 phi^1/2) beside it
  EXPECT_NEAR(drop_model_a("koch_hill", flux), carman, inertia * carman);
  EXPECT_NEAR(drop_model_a("beetstra", flux), carman, dilute_term * carman);
}

TEST(PackedBed, AFluidisedBedIsCarriedInBothModels) {
  // Drag, dynamic pressure and net weight balance where the drop carries the net weight.
  const double g = test::kGravity;
  FluidState f = gas();
  f.gravity_m_s2 = {0.0, 0.0, -g};
  const double carried = (1 - kVoid) * (bead().density_kg_m3 - kDensity) * g;  // Pa/m
  f.pressure_gradient_Pa_m = {0.0, 0.0, -carried};
  double flux = kFlux;  // where Ergun gives this gradient: secant on a nearly linear law
  for (int i = 0; i < 100; ++i) flux *= carried * kHeight / ergun(flux);
  f.velocity_m_s[2] = flux / kVoid;
  for (const MomentumModel model : {MomentumModel::A, MomentumModel::B}) {
    ForceSettings s;
    s.model = model;
    ForceTerms t;
    for (const char* name : {"gidaspow", "pressure_gradient", "buoyancy"}) {
      t += make_force(name, s)->evaluate(f, bead());
    }
    const double weight = bead().density_kg_m3 * forces::volume_m3(bead()) * g;
    EXPECT_NEAR(test::total_force_N(t, f, bead())[2], 0.0, kRounding * weight);
  }
}

}  // namespace
}  // namespace powderlink
