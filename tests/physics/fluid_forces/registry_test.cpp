// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every force of the list: an analytic check, the symmetries of space, no force
// without a cause, dissipation, and errors that say what to do.
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/physics/fluid_forces/force_cases.h"
#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using forces::FluidState;
using forces::force_registry;
using forces::ForceEntry;
using forces::ForceKind;
using forces::ForceSettings;
using forces::ForceTerms;
using forces::MomentumModel;
using forces::norm;
using forces::ParticleState;
using forces::Vec3;
using test::argon;
using test::busy_fluid;
using test::busy_particle;
using test::kRounding;
using test::make_force;
using test::refuses;

TEST(ForceRegistry, EveryForceHasAnAnalyticCheckAndPassesIt) {
  test::AnalyticChecks checks = test::drag_checks();
  checks.merge(test::other_force_checks());
  std::set<std::string> registered;
  for (const ForceEntry& entry : force_registry()) {
    const std::string& name = entry.info->name;
    SCOPED_TRACE(name);
    EXPECT_TRUE(registered.insert(name).second) << "is there twice";
    const auto check = checks.find(name);
    if (check == checks.end()) {
      ADD_FAILURE() << "no check against a closed form; write one in tests/physics/fluid_forces";
    } else {
      check->second();
    }
  }
  for (const auto& [name, check] : checks) {
    EXPECT_EQ(registered.count(name), 1U) << "a check for '" << name << "', not in forces.def";
  }
}

TEST(ForceRegistry, InfosAreComplete) {
  const std::set<std::string> fields = {"velocity_curl_1_s", "pressure_gradient_Pa_m",
                                        "viscous_stress_divergence_N_m3", "acceleration_m_s2",
                                        "gravity_m_s2"};
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    EXPECT_EQ(entry.info->name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos);
    EXPECT_FALSE(entry.info->law.empty());
    EXPECT_FALSE(entry.info->validity.empty());
    EXPECT_FALSE(entry.info->source.empty());
    for (const std::string& field : entry.info->fields) EXPECT_EQ(fields.count(field), 1U) << field;
    EXPECT_EQ(entry.info->kind == ForceKind::drag, entry.info->fields.empty());
  }
}

/// Clears every field that the force does not name.
FluidState only_named(const ForceEntry& entry, const FluidState& f) {
  FluidState g = f;
  g.velocity_curl_1_s = g.pressure_gradient_Pa_m = g.viscous_stress_divergence_N_m3 =
      g.acceleration_m_s2 = g.gravity_m_s2 = Vec3{};
  for (const std::string& field : entry.info->fields) {
    if (field == "velocity_curl_1_s") g.velocity_curl_1_s = f.velocity_curl_1_s;
    if (field == "pressure_gradient_Pa_m") g.pressure_gradient_Pa_m = f.pressure_gradient_Pa_m;
    if (field == "viscous_stress_divergence_N_m3") {
      g.viscous_stress_divergence_N_m3 = f.viscous_stress_divergence_N_m3;
    }
    if (field == "acceleration_m_s2") g.acceleration_m_s2 = f.acceleration_m_s2;
    if (field == "gravity_m_s2") g.gravity_m_s2 = f.gravity_m_s2;
  }
  return g;
}

void expect_same(const ForceTerms& a, const ForceTerms& b, double relative) {
  EXPECT_NEAR(a.drag_kg_s, b.drag_kg_s, relative * b.drag_kg_s);
  EXPECT_NEAR(a.rotational_drag_Nms, b.rotational_drag_Nms, relative * b.rotational_drag_Nms);
  EXPECT_NEAR(a.added_mass_kg, b.added_mass_kg, relative * b.added_mass_kg);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.force_N[i], b.force_N[i], relative * norm(b.force_N));
    EXPECT_NEAR(a.torque_Nm[i], b.torque_Nm[i], relative * norm(b.torque_Nm));
  }
}

TEST(EveryForce, UsesTheFieldsThatItNamesAndNoOther) {
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    const auto force = entry.make({});
    expect_same(force->evaluate(only_named(entry, busy_fluid()), busy_particle()),
                force->evaluate(busy_fluid(), busy_particle()), 0.0);
  }
}

TEST(EveryForce, IsTheSameInAMovingFrame) {
  const Vec3 boost = {7.0, -3.0, 11.0};
  constexpr double cancellation = 1e-13;  // u - v loses the digits that 13 m/s take from 3 m/s
  FluidState f = busy_fluid();
  ParticleState p = busy_particle();
  f.velocity_m_s = forces::sum(f.velocity_m_s, boost);
  p.velocity_m_s = forces::sum(p.velocity_m_s, boost);
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    const auto force = entry.make({});
    expect_same(force->evaluate(f, p), force->evaluate(busy_fluid(), busy_particle()),
                10 * cancellation);
  }
}

/// An orthogonal map; axial vectors (curl, spin, torque) take its determinant as well.
struct Turn {
  std::array<Vec3, 3> rows;
  double determinant;
  Vec3 polar(const Vec3& a) const {
    return {forces::dot(rows[0], a), forces::dot(rows[1], a), forces::dot(rows[2], a)};
  }
  Vec3 axial(const Vec3& a) const { return forces::scaled(determinant, polar(a)); }
};

TEST(EveryForce, TurnsAndMirrorsWithItsCauses) {
  const double c = std::cos(0.7), s = std::sin(0.7), e = std::cos(2.1), g = std::sin(2.1);
  const Turn rotation{{Vec3{c * e, -s, c * g}, Vec3{s * e, c, s * g}, Vec3{-g, 0.0, e}}, 1.0};
  const Turn mirror{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, -1.0};
  for (const Turn& turn : {rotation, mirror}) {
    FluidState f = busy_fluid();
    ParticleState p = busy_particle();
    for (Vec3* a : {&f.velocity_m_s, &f.pressure_gradient_Pa_m, &f.viscous_stress_divergence_N_m3,
                    &f.acceleration_m_s2, &f.gravity_m_s2, &p.velocity_m_s}) {
      *a = turn.polar(*a);
    }
    for (Vec3* a : {&f.velocity_curl_1_s, &p.spin_rad_s}) *a = turn.axial(*a);
    for (const ForceEntry& entry : force_registry()) {
      SCOPED_TRACE(entry.info->name);
      const auto force = entry.make({});
      ForceTerms expected = force->evaluate(busy_fluid(), busy_particle());
      expected.force_N = turn.polar(expected.force_N);
      expected.torque_Nm = turn.axial(expected.torque_Nm);
      expect_same(force->evaluate(f, p), expected, kRounding);
    }
  }
}

TEST(EveryForce, IsZeroWithoutACause) {
  FluidState f = argon();
  f.gravity_m_s2 = Vec3{};
  ParticleState p = test::steel();
  f.velocity_m_s = p.velocity_m_s = {3.0, -1.0, 0.5};
  f.velocity_curl_1_s = {200.0, 10.0, -40.0};
  p.spin_rad_s = forces::scaled(0.5, f.velocity_curl_1_s);  // carried along, turning along
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    const ForceTerms t = entry.make({})->evaluate(f, p);
    EXPECT_EQ(norm(test::total_force_N(t, f, p)), 0.0);
    EXPECT_EQ(norm(test::total_torque_Nm(t, f, p)), 0.0);
  }
}

TEST(EveryForce, OnlyDissipatesAndStaysFinite) {
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    const auto force = entry.make({});
    for (const double speed : {0.0, 1e-300, 1e-9, 1.0, 1e4}) {
      for (const double fluid_fraction : {1.0, 1 - 1e-16, 0.8, 0.6, 0.05}) {
        for (const double diameter : {1e-9, 1e-4, 1.0}) {
          FluidState f = busy_fluid();
          f.fluid_fraction = fluid_fraction;
          ParticleState p = busy_particle();
          p.diameter_m = diameter;
          p.velocity_m_s = forces::sum(f.velocity_m_s, {speed, 0, 0});
          const ForceTerms t = force->evaluate(f, p);
          EXPECT_TRUE(std::isfinite(t.drag_kg_s) && std::isfinite(t.rotational_drag_Nms));
          EXPECT_TRUE(forces::finite(t.force_N) && forces::finite(t.torque_Nm));
          EXPECT_GE(t.drag_kg_s, 0.0);
          EXPECT_GE(t.rotational_drag_Nms, 0.0);
          EXPECT_GE(t.added_mass_kg, 0.0);
          EXPECT_EQ(entry.info->kind == ForceKind::drag, t.drag_kg_s > 0.0);
        }
      }
    }
  }
}

TEST(EveryForce, ModelBChangesOnlyDragAndPressureForces) {
  ForceSettings b;
  b.model = MomentumModel::B;
  const FluidState f = busy_fluid();
  for (const ForceEntry& entry : force_registry()) {
    SCOPED_TRACE(entry.info->name);
    const ForceTerms in_a = entry.make({})->evaluate(f, busy_particle());
    const ForceTerms in_b = entry.make(b)->evaluate(f, busy_particle());
    if (entry.info->kind == ForceKind::drag) {
      EXPECT_NEAR(in_b.drag_kg_s * f.fluid_fraction, in_a.drag_kg_s, kRounding * in_a.drag_kg_s);
    } else if (entry.info->kind == ForceKind::pressure) {
      expect_same(in_b, ForceTerms{}, 0.0);
    } else {
      expect_same(in_b, in_a, 0.0);
    }
  }
}

TEST(ForceTermsSum, AddsEveryMember) {
  ForceTerms all;
  for (const ForceEntry& entry : force_registry()) {
    all += entry.make({})->evaluate(busy_fluid(), busy_particle());
  }
  const ForceTerms once = all;
  all += once;
  EXPECT_GT(once.drag_kg_s * once.rotational_drag_Nms * once.added_mass_kg * norm(once.force_N), 0);
  expect_same(
      all,
      {2 * once.drag_kg_s, forces::scaled(2, once.force_N), forces::scaled(2, once.torque_Nm),
       2 * once.rotational_drag_Nms, 2 * once.added_mass_kg},
      kRounding);
}

TEST(ForceRegistry, RefusesUnknownNames) {
  EXPECT_TRUE(refuses([] { make_force("ergun"); }, "force", "ergun"));
  try {
    make_force("ergun");
  } catch (const InvalidInput& e) {
    for (const ForceEntry& entry : force_registry()) {
      EXPECT_NE(std::string(e.what()).find(entry.info->name), std::string::npos);
    }
  }
}

TEST(EveryForce, RefusesStatesThatAreNotPhysical) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    std::string what;
    std::function<void(FluidState&, ParticleState&)> spoil;
  };
  const std::vector<Case> cases = {
      {"fluid density_kg_m3", [](auto& f, auto&) { f.density_kg_m3 = 0.0; }},
      {"kinematic_viscosity_m2_s", [](auto& f, auto&) { f.kinematic_viscosity_m2_s = -1e-5; }},
      {"fluid_fraction", [](auto& f, auto&) { f.fluid_fraction = 0.0; }},
      {"fluid_fraction", [](auto& f, auto&) { f.fluid_fraction = 1.01; }},
      {"fluid_fraction", [=](auto& f, auto&) { f.fluid_fraction = nan; }},
      {"diameter_m", [](auto&, auto& p) { p.diameter_m = -1e-6; }},
      {"particle density_kg_m3", [](auto&, auto& p) { p.density_kg_m3 = INFINITY; }},
      {"sphericity", [](auto&, auto& p) { p.sphericity = 1.2; }},
      {"fluid velocity_m_s", [=](auto& f, auto&) { f.velocity_m_s[1] = nan; }},
      {"particle velocity_m_s", [=](auto&, auto& p) { p.velocity_m_s[2] = nan; }},
      {"particle spin_rad_s", [](auto&, auto& p) { p.spin_rad_s[0] = INFINITY; }},
      {"velocity_curl_1_s", [=](auto& f, auto&) { f.velocity_curl_1_s[0] = nan; }},
      {"pressure_gradient_Pa_m", [=](auto& f, auto&) { f.pressure_gradient_Pa_m[0] = nan; }},
      {"viscous_stress", [=](auto& f, auto&) { f.viscous_stress_divergence_N_m3[0] = nan; }},
      {"acceleration_m_s2", [=](auto& f, auto&) { f.acceleration_m_s2[0] = nan; }},
      {"gravity_m_s2", [=](auto& f, auto&) { f.gravity_m_s2[0] = nan; }}};
  for (const ForceEntry& entry : force_registry()) {
    const auto force = entry.make({});
    for (const Case& c : cases) {
      FluidState f = busy_fluid();
      ParticleState p = busy_particle();
      c.spoil(f, p);
      EXPECT_TRUE(refuses([&] { force->evaluate(f, p); }, c.what)) << entry.info->name;
    }
  }
}

}  // namespace
}  // namespace powderlink
