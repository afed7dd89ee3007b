// SPDX-License-Identifier: GPL-3.0-or-later
// The shortcuts to d_c against the integration that they replace, and against closed forms.
#include "analysis/kat/reduced/critical_speed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/reduced/universal_tables.h"
#include "analysis/kat/study/material_library.h"
#include "physics/effects/effect_registry.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {
namespace {

using physics::StopPulse;

KatSetup glass(double energy, const std::string& effect = "",
               const std::vector<double>& parameters = {}) {
  KatSetup s;
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.work_of_adhesion_J_m2 = energy;
  if (!effect.empty()) s.effects = {physics::make_effect(effect, parameters)};
  return s;
}

// Interpolation in the tables and the bisection of either side; the edge of a rate-dependent contact
// is of first order in the step, which is not the same in both.
constexpr double kAccuracy = 1e-3;
constexpr double kAccuracyOfEdge = 5e-3;

TEST(CriticalSpeed, IsThatOfTheIntegration) {
  const struct {
    const char* effect;
    std::vector<double> parameters;
    double energy, velocity, tolerance;
  } cases[] = {{"", {}, 50.0, 3.0, kAccuracy},
               {"finite_stop_pulse", {1e-4, 0.3}, 0.09, 3.0, kAccuracy},
               {"finite_stop_pulse", {2e-6, 0.0}, 3.0, 3.0, kAccuracy},
               {"finite_stop_pulse", {5e-7, 0.0}, 20.0, 2.0, kAccuracy},
               {"finite_stop_pulse", {3e-3, 0.0}, 0.01, 1.0, kAccuracy},
               {"electrostatic_image_force", {1e-4}, 40.0, 3.0, kAccuracy},
               {"capillary_bridge", {0.0728, 0.05}, 0.001, 0.3, kAccuracy},
               {"capillary_bridge", {5.0, 0.05}, 5.0, 2.0, kAccuracy},
               {"surface_roughness", {1e-5}, 50.0, 2.0, kAccuracy},
               {"plastic_contact", {1e9}, 20.0, 3.0, kAccuracy},
               {"rate_dependent_adhesion", {1.0, 0.6}, 10.0, 2.0, kAccuracyOfEdge},
               {"rate_dependent_adhesion", {0.03, 1.3}, 3.0, 4.0, kAccuracyOfEdge}};
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.effect) + " " + std::to_string(c.energy));
    const ReducedModel model(glass(c.energy, c.effect, c.parameters));
    ASSERT_TRUE(CriticalSpeed(model).available());
    const CriticalDiameter quick = quick_critical_diameter(model, c.velocity);
    const CriticalDiameter integrated = critical_diameter(model, c.velocity);
    ASSERT_TRUE(quick.found() && integrated.found());
    EXPECT_NEAR(quick.diameter_m / integrated.diameter_m, 1.0, c.tolerance);
  }
}

TEST(CriticalSpeed, InstantStopIsTheClosedForm) {
  KatSetup s = glass(50.0);
  s.gravity_m_s2 = 0.0;
  const ReducedModel model(s);
  const double closed =
      physics::critical_speed_instant_m_s(model.smooth_law(), 30e-6, s.particle.density_kg_m3);
  constexpr double rounding = 1e-9;  // of the rest position, found to 45 bits
  EXPECT_NEAR(CriticalSpeed(model).speed_change_m_s(60e-6) / closed, 1.0, rounding);
}

TEST(CriticalSpeed, LimitsOfTheTables) {
  EXPECT_NEAR(slowness_factor(StopPulse::Shape::half_sine, 0.03), 1.0, 2e-3);
  // Slow limit: proportional to the duration, and the closed form joins the table.
  const double at_300 = slowness_factor(StopPulse::Shape::half_sine, 300.0);
  const double at_600 = slowness_factor(StopPulse::Shape::half_sine, 600.0);
  EXPECT_NEAR(at_600 / at_300, 2.0, 2.0 * kAccuracy);
  EXPECT_NEAR(moving_edge_factor(1e9, 1.0), 1.0, kAccuracy);
  // A moving edge that is fast for its v*: power law, doubling with n = 1 for each factor 4.
  EXPECT_NEAR(moving_edge_factor(1e-4, 1.0) / moving_edge_factor(4e-4, 1.0), 2.0, 0.02);
}

TEST(CriticalSpeed, SaysWhenItDoesNotKnow) {
  KatSetup damped = glass(50.0);
  damped.restitution = 0.9;
  EXPECT_FALSE(CriticalSpeed(ReducedModel(damped)).available());
  KatSetup two = glass(0.1, "finite_stop_pulse", {1e-4, 0.0});
  two.effects.push_back(physics::make_effect("electrostatic_image_force", {2e-5}));
  const ReducedModel both(two);
  EXPECT_FALSE(CriticalSpeed(both).available());
  EXPECT_TRUE(CriticalSpeed(both, true).available());
  // What pairs are searched with: works and forces added.
  constexpr double estimate = 0.1;
  EXPECT_NEAR(
      quick_critical_diameter(both, 3.0, true).diameter_m / critical_diameter(both, 3.0).diameter_m,
      1.0, estimate);
}

}  // namespace
}  // namespace powderlink::analysis
