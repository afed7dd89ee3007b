// SPDX-License-Identifier: GPL-3.0-or-later
/// \file foam_case.h
/// The mesh that the program was started on, and particles in it that are the same on any number of
/// ranks.
#pragma once

#include "cellLocator.H"
#include "globalMeshData.H"
#include "particleOwnership.H"
#include "volFields.H"

namespace powderlink::foam_test {

const Foam::fvMesh& mesh();
const Foam::cellLocator& locator();
/// The case is the cube of 24 x 24 x 24 cells of 1 mm, periodic in z; the box of 6 x 8 x 10
/// cells of 1 mm, periodic in all directions; else it is the pipe with its O-grid.
bool on_cube();
bool on_box();

/// Cube root of the mean volume of a cell [m].
double cell_size();

/// n points in the bounding box of the whole mesh, the same on every rank.
Foam::pointField random_points(int n, int seed);

/// Particles on the ranks that own them: the same ones for any decomposition.
struct Particles {
  Foam::pointField positions;
  Foam::scalarField radii;
  Foam::scalarField values;  ///< some number, different for each
  Foam::vectorField vectors;
  Foam::labelList cells;
  double total_volume = 0.0;  ///< over all ranks, and so on
  double total_value = 0.0;
  Foam::vector total_vector{0, 0, 0};
};
/// \param largest  radii go from a fifth of this one to this one [m]
Particles random_particles(int n, double largest, int seed);
/// \param radii  one per position
Particles particles_at(const Foam::pointField& positions, const Foam::scalarField& radii);
Particles one_particle(const Foam::point& position, double radius);

/// A dictionary from its text.
Foam::dictionary dictionary_of(const std::string& entries);

/// Text of the OpenFOAM error that the call stops with; empty if it does not.
template <class Call>
std::string error_of(Call call) {
  const bool before = Foam::FatalError.throwExceptions();
  const bool before_io = Foam::FatalIOError.throwExceptions();
  std::string text;
  try {
    call();
  } catch (const Foam::error& e) {
    text = e.message();
  }
  Foam::FatalError.throwExceptions(before);
  Foam::FatalIOError.throwExceptions(before_io);
  return text;
}

}  // namespace powderlink::foam_test
