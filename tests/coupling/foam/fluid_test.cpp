// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of the fluid at the particles, and the forces that follow from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "fixedGradientFvPatchFields.H"
#include "fluidForces.H"
#include "fluidInterpolation.H"
#include "foam_case.h"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "mathematicalConstants.H"
#include "physics/fluid_forces/force_registry.h"
#include "viscousStress.H"

using namespace powderlink::foam_test;
namespace forces = powderlink::forces;
using Foam::label;
using Foam::volScalarField;
using Foam::volVectorField;

namespace {
// Differences of fields over one cell, values of order one.
constexpr double kRoundOff = 1e-9;

template <class Type, class Function>
auto field_of(const char* name, const Foam::dimensionSet& dimensions, Function value) {
  using FieldType = Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>;
  auto field = std::make_unique<FieldType>(
      Foam::IOobject(name, mesh().time().timeName(), mesh(), Foam::IOobject::NO_READ,
                     Foam::IOobject::NO_WRITE, false),
      mesh(), Foam::dimensioned<Type>(name, dimensions, Foam::Zero));
  forAll(*field, c)(*field)[c] = value(mesh().C()[c]);
  forAll(mesh().boundary(), b) {
    auto& patch = field->boundaryFieldRef()[b];
    if (patch.coupled()) continue;
    forAll(patch, i) patch[i] = value(mesh().Cf().boundaryField()[b][i]);
  }
  field->correctBoundaryConditions();
  return field;
}

// u = u0 + r.G with trace zero, in m/s; p = p0 + b.r in m2/s2.
const Foam::vector kU0(1.5, -0.4, 0.7);
const Foam::tensor kGradU(20, -300, 150, 80, 40, 30, 250, -70, -60);
const Foam::vector kGradP(700, -200, 90);
Foam::vector linear_velocity(const Foam::point& r) { return kU0 + (r & kGradU); }
double linear_pressure(const Foam::point& r) { return 3.0 + (kGradP & r); }

/// Those at least `cells` cells away from the boundary.
Particles away_from_walls(const Particles& p, double cells) {
  Particles some;
  Foam::boundBox box(mesh().bounds());
  box.min() += Foam::vector::uniform(cells * cell_size());
  box.max() -= Foam::vector::uniform(cells * cell_size());
  forAll(p.positions, i) {
    if (!box.contains(p.positions[i])) continue;
    some.positions.append(p.positions[i]);
    some.radii.append(p.radii[i]);
    some.cells.append(p.cells[i]);
    some.vectors.append(p.vectors[i]);
  }
  return some;
}

Foam::autoPtr<Foam::fluidInterpolation> interpolation(const std::string& type) {
  return Foam::fluidInterpolation::New(mesh(), dictionary_of("interpolation " + type + ";"));
}

constexpr double kRho = 1.6355;
constexpr double kNu = 1.383e-5;
constexpr double kAlpha = 0.85;  // off the 0.8 at which gidaspow changes
const Foam::vector kG(0, 0, -9.81);
const Foam::vector kDdtU(40, 20, -10);

Foam::fluidForces::fluidProperties properties(bool model_a) { return {kRho, kNu, kG, model_a}; }

forces::Vec3 vec3(const Foam::vector& v) { return {v.x(), v.y(), v.z()}; }
void expect_near(const Foam::vector& a, const forces::Vec3& b, double scale) {
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(a[d], b[d], kRoundOff * scale);
}
std::string error_of_forces(const std::string& entries) {
  return error_of([&] { Foam::fluidForces(dictionary_of(entries), properties(true)); });
}
}  // namespace

TEST(FluidInterpolation, CellGivesTheValueOfTheCell) {
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, linear_velocity);
  const auto p = field_of<double>("p", Foam::dimless, linear_pressure);
  const Particles some = random_particles(500, cell_size(), 9);
  auto at = interpolation("cell");
  at->set(some.positions, some.cells);
  const Foam::vectorField u(at->interpolate(*U));
  const Foam::scalarField q(at->interpolate(*p));
  forAll(some.cells, i) {
    EXPECT_EQ(u[i], (*U)[some.cells[i]]);
    EXPECT_EQ(q[i], (*p)[some.cells[i]]);
  }
}

TEST(FluidInterpolation, CellPointIsExactForLinearFields) {
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, linear_velocity);
  const auto p = field_of<double>("p", Foam::dimless, linear_pressure);
  Particles some = random_particles(2000, cell_size(), 10);
  // Points of the boundary take the mean of their faces, exact on flat sides away from edges.
  if (on_cube()) some = away_from_walls(some, 1.0);
  auto at = interpolation("cellPoint");
  at->set(some.positions, some.cells);
  const Foam::vectorField u(at->interpolate(*U));
  const Foam::scalarField q(at->interpolate(*p));
  // The pipe's cells are not equal: what inverse distances miss there is a part of the change over
  // a cell, and far less than the value of the cell does (half of it).
  const double change = mag(kGradU) * cell_size();
  const double tolerance = on_cube() ? kRoundOff : 0.25 * change;
  EXPECT_GT(Foam::returnReduce(some.cells.size(), Foam::sumOp<label>()), 1000);
  forAll(some.cells, i) {
    EXPECT_LT(mag(u[i] - linear_velocity(some.positions[i])), tolerance);
    EXPECT_NEAR(q[i], linear_pressure(some.positions[i]),
                on_cube() ? kRoundOff : 0.25 * mag(kGradP) * cell_size());
  }
}

TEST(FluidInterpolation, RefusesUnknownNames) {
  EXPECT_NE(error_of([] { interpolation("linear"); }).find("(cell cellPoint)"), std::string::npos);
}

TEST(FluidForces, AreThoseOfTheLawsAtTheFieldsOfTheFluid) {
  if (!on_cube()) GTEST_SKIP() << "exact fields need equal cells";
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, linear_velocity);
  const auto p = field_of<double>("p", Foam::dimless, linear_pressure);
  const auto alphaf = field_of<double>("alphaf", Foam::dimless, [](const auto&) { return kAlpha; });
  const auto nu = field_of<double>("nuEff", Foam::dimViscosity, [](const auto&) { return kNu; });
  const auto ddtU =
      field_of<Foam::vector>("ddtU", Foam::dimAcceleration, [](const auto&) { return kDdtU; });
  const Particles some = away_from_walls(random_particles(400, 50e-6, 11), 3.0);
  const Foam::vectorField spin(some.cells.size(), Foam::vector(30, -500, 200));
  const Foam::scalarField density(some.cells.size(), 7950.0);
  auto at = interpolation("cellPoint");
  at->set(some.positions, some.cells);

  const Foam::vector curl(-(kGradU.zy() - kGradU.yz()), -(kGradU.xz() - kGradU.zx()),
                          -(kGradU.yx() - kGradU.xy()));
  for (const bool model_a : {true, false}) {
    const std::vector<std::string> names{"gidaspow", "pressure_gradient", "viscous_stress",
                                         "buoyancy", "virtual_mass",      "saffman_mei",
                                         "magnus",   "rotational_drag"};
    std::string list;
    for (const std::string& name : names) list += name + " ";
    Foam::fluidForces all(dictionary_of("forces (" + list + ");"), properties(model_a));
    EXPECT_TRUE(all.hasTorque());
    EXPECT_TRUE(all.hasAddedMass());
    EXPECT_EQ(all.needsViscousStress(), model_a);
    EXPECT_TRUE(all.needsAcceleration());
    Foam::fluidForces::forceRows rows;
    all.evaluate(all.interpolate({*U, *p, *alphaf, nu.get(), ddtU.get()}, at(), 0.2),
                 {some.vectors, spin, some.radii, density}, rows);

    forces::ForceSettings settings;
    settings.model = model_a ? forces::MomentumModel::A : forces::MomentumModel::B;
    settings.weight_in_dem = true;
    forAll(some.cells, i) {
      const Foam::vector u(linear_velocity(some.positions[i]));
      forces::FluidState f;
      f.velocity_m_s = vec3(u);
      f.density_kg_m3 = kRho;
      f.kinematic_viscosity_m2_s = kNu;
      f.fluid_fraction = kAlpha;
      f.velocity_curl_1_s = vec3(curl);
      f.pressure_gradient_Pa_m = vec3(kRho * kGradP);
      f.acceleration_m_s2 = vec3(kDdtU + (u & kGradU));
      f.gravity_m_s2 = vec3(kG);
      forces::ParticleState s;
      s.velocity_m_s = vec3(some.vectors[i]);
      s.spin_rad_s = vec3(spin[i]);
      s.diameter_m = 2.0 * some.radii[i];
      s.density_kg_m3 = density[i];
      forces::ForceTerms reacting, pressure, sum;
      for (const std::string& name : names) {
        const auto& entry = forces::find_force(name);
        const forces::ForceTerms terms = entry.make(settings)->evaluate(f, s);
        (entry.info->reacts_on_fluid ? reacting : pressure) += terms;
        sum += terms;
      }
      EXPECT_NEAR(rows.fluidFraction[i], kAlpha, kRoundOff);
      EXPECT_LT(mag(rows.fluidVelocity[i] - u), kRoundOff);
      EXPECT_NEAR(rows.dragCoefficient[i], sum.drag_kg_s, kRoundOff * sum.drag_kg_s);
      expect_near(rows.reactingForce[i], reacting.force_N, forces::norm(reacting.force_N));
      expect_near(rows.pressureForce[i], pressure.force_N, forces::norm(pressure.force_N));
      EXPECT_GT(sum.rotational_drag_Nms, 0.0);
      expect_near(rows.fluidTorque[i], sum.torque_Nm, forces::norm(sum.torque_Nm));
      EXPECT_NEAR(rows.rotationalDrag[i], sum.rotational_drag_Nms,
                  kRoundOff * sum.rotational_drag_Nms);
      EXPECT_NEAR(rows.addedMass[i], sum.added_mass_kg, kRoundOff * sum.added_mass_kg);
      EXPECT_LT(mag(rows.fluidSpin[i] - 0.5 * curl), kRoundOff * mag(curl));
    }
  }
}

TEST(FluidForces, ViscousStressOfAParabolicProfile) {
  if (!on_cube()) GTEST_SKIP() << "exact differences need equal cells";
  // u = (c y^2, 0, 0): div tau = 2 c mu, and the force is V times that. A pressure that balances it
  // takes it away again.
  const double c = 4e4;
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, [&](const Foam::point& r) {
    return Foam::vector(c * r.y() * r.y(), 0, 0);
  });
  const auto nu = field_of<double>("nuEff", Foam::dimViscosity, [](const auto&) { return kNu; });
  const auto one = field_of<double>("alphaf", Foam::dimless, [](const auto&) { return 1.0; });
  const auto p = field_of<double>("p", Foam::dimless,
                                  [&](const Foam::point& r) { return 2.0 * c * kNu * r.x(); });
  const Particles some = away_from_walls(random_particles(400, 50e-6, 12), 3.0);
  const Foam::vectorField zero(some.cells.size(), Foam::vector::zero);
  const Foam::scalarField density(some.cells.size(), 7950.0);
  auto at = interpolation("cell");
  at->set(some.positions, some.cells);
  for (const bool balanced : {false, true}) {
    Foam::fluidForces stress(dictionary_of(balanced ? "forces (viscous_stress pressure_gradient);"
                                                    : "forces (viscous_stress);"),
                             properties(true));
    EXPECT_FALSE(stress.needsAcceleration());
    Foam::fluidForces::forceRows rows;
    stress.evaluate(stress.interpolate({*U, *p, *one, nu.get(), nullptr}, at(), 0.2),
                    {zero, zero, some.radii, density}, rows);
    forAll(some.cells, i) {
      const double volume = 4.0 / 3.0 * M_PI * Foam::pow3(some.radii[i]);
      const double force = 2.0 * c * kNu * kRho * volume;
      expect_near(rows.pressureForce[i], {balanced ? 0.0 : force, 0.0, 0.0}, force);
      EXPECT_EQ(rows.dragCoefficient[i], 0.0);
      EXPECT_EQ(mag(rows.reactingForce[i]), 0.0);
    }
    EXPECT_EQ(rows.fluidSpin.size(), 0);
    EXPECT_EQ(rows.addedMass.size(), 0);
  }
}

TEST(ViscousStress, IsThatOfTheOperatorsOfTheMomentumEquation) {
  // Viscosity and velocity that vary, on curved, skewed and periodic meshes.
  const Foam::vector k(2.0 * Foam::constant::mathematical::pi / 6e-3 * Foam::vector(1.0, 0.5, 0.3));
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, [&](const Foam::point& r) {
    return Foam::vector(std::sin(k & r), std::cos(2.0 * (k & r)), std::sin(k & r) + 50.0 * r.x());
  });
  const auto nu = field_of<double>("nuEff", Foam::dimViscosity, [&](const Foam::point& r) {
    return 1e-5 * (2.0 + std::sin(0.7 * (k & r)));
  });
  const Foam::volTensorField gradient("gradU", Foam::fvc::grad(*U));
  const volVectorField fused(Foam::viscousStress::divergence(*U, gradient, *nu));
  const volVectorField separate(
      Foam::fvc::laplacian(*nu, *U, "laplacian(nuEff,U)") +
      Foam::fvc::div((*nu) * Foam::dev2(Foam::T(gradient)), "div((nuEff*dev2(T(grad(U)))))"));
  const double largest = Foam::gMax(Foam::mag(separate.primitiveField())());
  ASSERT_GT(largest, 0.0);
  EXPECT_LT(Foam::gMax(Foam::mag(fused.primitiveField() - separate.primitiveField())()),
            kRoundOff * largest);
  forAll(mesh().boundary(), b) {
    const Foam::vectorField difference(fused.boundaryField()[b] - separate.boundaryField()[b]);
    forAll(difference, i) EXPECT_LT(mag(difference[i]), kRoundOff * largest);
  }
}

TEST(FluidForces, TheFluidFractionAtAParticleIsBounded) {
  const auto U = field_of<Foam::vector>("U", Foam::dimVelocity, linear_velocity);
  const auto p = field_of<double>("p", Foam::dimless, linear_pressure);
  const auto dense = field_of<double>("alphaf", Foam::dimless, [](const auto&) { return 0.1; });
  const Particles some = random_particles(20, 50e-6, 13);
  const Foam::vectorField zero(some.cells.size(), Foam::vector::zero);
  const Foam::scalarField density(some.cells.size(), 7950.0);
  auto at = interpolation("cellPoint");
  at->set(some.positions, some.cells);
  Foam::fluidForces drag(dictionary_of("forces (beetstra);"), properties(true));
  Foam::fluidForces::forceRows rows;
  drag.evaluate(drag.interpolate({*U, *p, *dense, nullptr, nullptr}, at(), 0.3),
                {zero, zero, some.radii, density}, rows);
  forAll(some.cells, i) EXPECT_EQ(rows.fluidFraction[i], 0.3);
}

TEST(FluidForces, RefusesListsThatMakeNoSense) {
  EXPECT_EQ(error_of_forces("forces ();"), "");
  EXPECT_EQ(error_of_forces("forces (koch_hill);"), "");
  const std::string unknown = error_of_forces("forces (stokes);");
  for (const auto& entry : forces::force_registry()) {
    EXPECT_NE(unknown.find(entry.info->name), std::string::npos) << unknown;
  }
  EXPECT_NE(error_of_forces("forces (gidaspow beetstra);").find("one drag law or none"),
            std::string::npos);
  EXPECT_NE(error_of_forces("forces (magnus magnus);").find("more than once"), std::string::npos);
  EXPECT_NE(error_of_forces("forces (ganser); sphericity 1.5;").find("sphericity"),
            std::string::npos);
  EXPECT_NE(
      error_of_forces("forces (virtual_mass); virtualMassCoefficient -1;").find("coefficient"),
      std::string::npos);
}
