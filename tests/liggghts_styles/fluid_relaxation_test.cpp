// SPDX-License-Identifier: GPL-3.0-or-later
// One step of the relaxation against the closed form, its limits and its composition.
#include "liggghts_styles/couple_bridge/fluid_relaxation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace powderlink::host {
namespace {

constexpr double kMass = 4e-9;
constexpr double kU[3] = {10.0, -2.0, 0.0};
constexpr double kForce[3] = {1e-8, 0.0, -4e-8};
constexpr double kRounding = 1e-14;  // a few operations in double

double moved(const FluidRelaxation& step, double v, int c) { return step.a * v + step.d[c]; }

TEST(FluidRelaxation, IsTheClosedFormAtAnyStiffness) {
  constexpr double v = 3.0;
  for (const double x : {1e-12, 1e-6, 1e-3, 1.0, 30.0, 1e4}) {
    const double dt = 1e-6;
    const double k = x * kMass / dt;
    const FluidRelaxation step = fluid_relaxation(k, kU, kForce, kMass, dt);
    for (int c = 0; c < 3; ++c) {
      const double end = kU[c] + kForce[c] / k;
      // v + (end - v)(1 - e^-x), arranged so that it keeps its digits for small x
      const double exact = v - std::expm1(-x) * (end - v);
      EXPECT_NEAR(moved(step, v, c), exact, kRounding * std::fabs(end - v) + kRounding * v) << x;
    }
  }
}

TEST(FluidRelaxation, WithoutDragAForceAccelerates) {
  const FluidRelaxation step = fluid_relaxation(0.0, kU, kForce, kMass, 1e-6);
  EXPECT_EQ(step.a, 1.0);
  EXPECT_DOUBLE_EQ(step.d[2], kForce[2] / kMass * 1e-6);
  const double none[3] = {0, 0, 0};
  const FluidRelaxation nothing = fluid_relaxation(0.0, kU, none, kMass, 1e-6);
  EXPECT_EQ(nothing.d[0], 0.0) << "no drag: the wind does not matter";
}

TEST(FluidRelaxation, TwoHalfStepsAreOneStep) {
  const double k = 2e-2;
  const FluidRelaxation whole = fluid_relaxation(k, kU, kForce, kMass, 1e-6);
  const FluidRelaxation half = fluid_relaxation(k, kU, kForce, kMass, 5e-7);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(moved(half, moved(half, 1.0, c), c), moved(whole, 1.0, c), 1e-13 * 10.0);
  }
}

TEST(FluidRelaxation, AStiffParticleTakesTheTerminalVelocityAndNothingOvershoots) {
  const double k = 1.0;
  const FluidRelaxation step = fluid_relaxation(k, kU, kForce, kMass, 1e-4);
  EXPECT_EQ(step.a, 0.0);
  EXPECT_NEAR(step.d[0], kU[0] + kForce[0] / k, kRounding * kU[0]);
}

}  // namespace
}  // namespace powderlink::host
