// SPDX-License-Identifier: GPL-3.0-or-later
// Tests on a real mesh: coupling_foam_test [gtest options] -case DIR [-parallel]
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "foam_case.h"
// argList and Time after the rest: the first defines a function of every program.
#include "Time.H"
#include "argList.H"
#include "mathematicalConstants.H"

namespace powderlink::foam_test {
namespace {
const Foam::fvMesh* the_mesh = nullptr;
const Foam::cellLocator* the_locator = nullptr;
double the_cell_size = 0.0;

}  // namespace

const Foam::fvMesh& mesh() { return *the_mesh; }
const Foam::cellLocator& locator() { return *the_locator; }
bool on_cube() { return mesh().time().globalCaseName() == "cube"; }

bool on_box() { return mesh().time().globalCaseName() == "box"; }

double cell_size() { return the_cell_size; }

Foam::pointField random_points(int n, int seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Foam::boundBox& box = mesh().bounds();
  Foam::pointField points(n);
  for (Foam::point& p : points) {
    for (int d = 0; d < 3; ++d) p[d] = box.min()[d] + uniform(random) * box.span()[d];
  }
  return points;
}

Particles particles_at(const Foam::pointField& positions, const Foam::scalarField& radii) {
  // Row i first goes to rank i mod n, as if the sender knew nothing.
  Foam::DynamicList<Foam::label> mine;
  Foam::scalarField values(positions.size());
  Foam::vectorField vectors(positions.size());
  forAll(positions, i) {
    values[i] = 1.0 + 0.37 * (i % 11);
    vectors[i] = Foam::vector(1.0 + i % 5, -2.0 + i % 7, 0.25 * (i % 3));
    if (i % Foam::Pstream::nProcs() == Foam::Pstream::myProcNo()) mine.append(i);
  }
  Foam::particleOwnership ownership(locator());
  ownership.update(Foam::pointField(positions, mine));
  Particles p;
  ownership.toOwner(Foam::pointField(positions, mine), p.positions);
  ownership.toOwner(Foam::scalarField(radii, mine), p.radii);
  ownership.toOwner(Foam::scalarField(values, mine), p.values);
  ownership.toOwner(Foam::vectorField(vectors, mine), p.vectors);
  p.cells = ownership.cells();
  p.total_volume = Foam::gSum(4.0 / 3.0 * Foam::constant::mathematical::pi * pow3(p.radii));
  p.total_value = Foam::gSum(p.values);
  p.total_vector = Foam::gSum(p.vectors);
  return p;
}

Particles random_particles(int n, double largest, int seed) {
  std::mt19937_64 random(seed + 1000);
  std::uniform_real_distribution<double> uniform(0.2, 1.0);
  Foam::scalarField radii(n);
  for (double& r : radii) r = largest * uniform(random);
  return particles_at(random_points(n, seed), radii);
}

Particles one_particle(const Foam::point& position, double radius) {
  return particles_at(Foam::pointField(1, position), Foam::scalarField(1, radius));
}

Foam::dictionary dictionary_of(const std::string& entries) {
  return Foam::dictionary(Foam::IStringStream(entries)());
}
}  // namespace powderlink::foam_test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  Foam::argList::noFunctionObjects();
  Foam::argList args(argc, argv);
  Foam::Time time(Foam::Time::controlDictName, args);
  Foam::fvMesh mesh(Foam::IOobject(Foam::fvMesh::defaultRegion, time.timeName(), time,
                                   Foam::IOobject::MUST_READ));
  powderlink::foam_test::the_mesh = &mesh;
  powderlink::foam_test::the_cell_size =
      std::cbrt(Foam::gSum(mesh.V().field()) / mesh.globalData().nTotalCells());
  Foam::cellLocator locator(mesh);
  powderlink::foam_test::the_locator = &locator;
  const int failed = RUN_ALL_TESTS();
  // The destructor of argList would end a parallel run with status 0.
  Foam::UPstream::exit(Foam::returnReduce(failed, Foam::maxOp<int>()));
}
