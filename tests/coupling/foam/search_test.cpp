// SPDX-License-Identifier: GPL-3.0-or-later
// cellLocator, rankMap and particleOwnership against OpenFOAM's own search.
#include <gtest/gtest.h>

#include <set>

#include "foam_case.h"
#include "processorCyclicPolyPatch.H"
#include "rankMap.H"

using namespace powderlink::foam_test;
using Foam::label;
using Foam::Pstream;

namespace {
int total(int here) { return Foam::returnReduce(here, Foam::sumOp<int>()); }

/// The other side of the patch is the same place on another rank.
bool is_between_ranks(const Foam::polyPatch& patch) {
  return Foam::isA<Foam::processorPolyPatch>(patch) &&
         !Foam::isA<Foam::processorCyclicPolyPatch>(patch);
}

/// Points of all ranks on every rank.
Foam::pointField everywhere(const Foam::pointField& here) {
  Foam::List<Foam::pointField> all(Pstream::nProcs());
  all[Pstream::myProcNo()] = here;
  Pstream::gatherList(all);
  Pstream::scatterList(all);
  Foam::DynamicList<Foam::point> points;
  for (const Foam::pointField& some : all) points.append(some);
  return Foam::pointField(std::move(points));
}
}  // namespace

TEST(CellLocator, AgreesWithOpenFoamOnRandomPoints) {
  int inside = 0;
  for (const Foam::point& p : random_points(3000, 1)) {
    const label expected = mesh().findCell(p);
    EXPECT_EQ(locator().find(p), expected) << p.x() << " " << p.y() << " " << p.z();
    if (expected >= 0) {
      ++inside;
      EXPECT_GT(locator().depth(p, expected), 0.0);
    }
  }
  // The random points fill the cube, and pi/4 of the pipe's box.
  EXPECT_GT(total(inside), 2000);
}

TEST(CellLocator, AnyHintFindsTheSameCell) {
  int hint = 7;
  for (const Foam::point& p : random_points(500, 2)) {
    hint = (hint * 7919) % mesh().nCells();
    EXPECT_EQ(locator().find(p, hint), locator().find(p));
  }
}

TEST(CellLocator, OutsideTheNearestCellIsThatOfTheNearestCentre) {
  const Foam::boundBox& box = mesh().bounds();
  for (const Foam::point& p : random_points(200, 3)) {
    // Half of them beyond the box.
    const Foam::point far = box.midpoint() + 2.0 * (p - box.midpoint());
    const label found = locator().nearest(far);
    if (locator().find(far) >= 0) {
      EXPECT_EQ(found, locator().find(far));
    } else {
      const label expected = mesh().findNearestCell(far);
      EXPECT_NEAR(mag(mesh().cellCentres()[found] - far), mag(mesh().cellCentres()[expected] - far),
                  1e-12 * box.mag());
    }
  }
}

TEST(CellLocator, CentresAreInTheirCells) {
  forAll(mesh().cellCentres(), i) EXPECT_EQ(locator().find(mesh().cellCentres()[i]), i);
}

TEST(CellLocator, OutsideIsOutside) {
  const Foam::boundBox& box = mesh().bounds();
  const double beyond = 1e-6 * cell_size();
  EXPECT_EQ(locator().find(box.max() + Foam::vector(beyond, 0, 0)), -1);
  EXPECT_EQ(locator().find(box.min() - Foam::vector(0, 0, beyond)), -1);
  EXPECT_EQ(locator().find(Foam::vector::uniform(1e300)), -1);
  EXPECT_EQ(locator().find(Foam::vector::uniform(std::nan(""))), -1);
  // The middle of a wall face lies inside of a curved wall: outwards of it there is no cell.
  for (const Foam::polyPatch& patch : mesh().boundaryMesh()) {
    if (patch.coupled()) continue;
    const Foam::vectorField normals(patch.faceNormals());
    forAll(patch, i) {
      const Foam::point centre(patch.faceCentres()[i]);
      EXPECT_EQ(locator().find(centre + beyond * normals[i]), -1);
      EXPECT_EQ(locator().find(centre - beyond * normals[i]), patch.faceCells()[i]);
    }
  }
}

TEST(CellLocator, PointsOnInnerFacesAreInOneOfTheTwoCells) {
  forAll(mesh().faceNeighbour(), facei) {
    const label cell = locator().find(mesh().faceCentres()[facei]);
    EXPECT_TRUE(cell == mesh().faceOwner()[facei] || cell == mesh().faceNeighbour()[facei]);
  }
}

// Where faces are bent their planes overlap at edges: the start of the search must not decide.
TEST(CellLocatorBentFaces, AnyHintFindsOpenFoamsCell) {
  int hint = 7;
  for (const Foam::point& p : random_points(4000, 6)) {
    const label expected = mesh().findCell(p);
    EXPECT_EQ(locator().find(p), expected);
    for (int again = 0; again < 8; ++again) {
      hint = (hint * 7919 + 1) % mesh().nCells();
      EXPECT_EQ(locator().find(p, hint), expected) << p.x() << " " << p.y() << " " << p.z();
    }
    if (expected >= 0) {
      EXPECT_EQ(locator().find(p, expected), expected);
      for (const label beside : mesh().cellCells()[expected]) {
        EXPECT_EQ(locator().find(p, beside), expected);
      }
    }
  }
}

TEST(RankMap, SendsNearlyEveryPointToItsOwner) {
  const Foam::rankMap map(locator());
  ASSERT_EQ(map.rank.size(), std::size_t(map.voxels[0]) * map.voxels[1] * map.voxels[2]);
  if (!Pstream::parRun()) {
    EXPECT_EQ(map.rank.size(), 1u);
  }
  int right = 0;
  const Foam::pointField points(random_points(4000, 3));
  int inside = 0;
  for (const Foam::point& p : points) {
    if (locator().find(p) < 0) continue;
    ++inside;
    label v[3];
    for (int d = 0; d < 3; ++d) {
      v[d] = std::min<label>(map.voxels[d] - 1, (p[d] - map.origin[d]) / map.spacing[d]);
    }
    const int rank = map.rank[(v[2] * map.voxels[1] + v[1]) * map.voxels[0] + v[0]];
    EXPECT_GE(rank, 0);
    right += rank == Pstream::myProcNo();
  }
  // Voxels of about a sixtieth of the box: only those across the two cuts can be wrong.
  EXPECT_GT(total(right), 0.96 * total(inside));
}

TEST(ParticleOwnership, EveryParticleHasOneOwnerAndResultsComeBack) {
  // Random points of a box that is larger than the mesh, given to ranks at random.
  Foam::pointField all(random_points(2000, 4));
  const Foam::point middle(mesh().bounds().midpoint());
  for (Foam::point& p : all) p = middle + 1.1 * (p - middle);
  Foam::DynamicList<Foam::point> here;
  Foam::DynamicList<std::int64_t> ids;
  forAll(all, i) {
    if ((i * 31) % Pstream::nProcs() != Pstream::myProcNo()) continue;
    here.append(all[i]);
    ids.append(5000000000 + i);
  }
  std::set<std::int64_t> outside;
  forAll(all, i) {
    if (total(mesh().findCell(all[i]) >= 0) == 0) outside.insert(5000000000 + i);
  }
  EXPECT_GT(outside.size(), 100u);

  Foam::particleOwnership ownership(locator());
  ownership.update(here);
  EXPECT_EQ(ownership.nReceived(), here.size());
  EXPECT_EQ(ownership.nOutsideGlobal(), label(outside.size()));
  EXPECT_EQ(total(ownership.nOwned()) + ownership.nOutsideGlobal(), all.size());
  if (Pstream::parRun()) {
    EXPECT_GT(ownership.nMovedGlobal(), 500);
  }

  Foam::List<std::int64_t> owned_ids, back_ids;
  Foam::List<Foam::vector> owned_positions, back;
  ownership.toOwner<std::int64_t>(ids, owned_ids);
  ownership.toOwner<Foam::vector>(here, owned_positions);
  forAll(owned_ids, i) {
    EXPECT_EQ(owned_positions[i], all[owned_ids[i] - 5000000000]);
    EXPECT_GE(locator().depth(owned_positions[i], ownership.cells()[i]), -locator().tolerance());
    owned_positions[i] *= 2.0;
  }
  ownership.toReceiver<std::int64_t>(owned_ids, back_ids, -1);
  ownership.toReceiver<Foam::vector>(owned_positions, back, Foam::vector::zero);
  int lost = 0;
  forAll(ids, i) {
    if (outside.count(ids[i])) {
      ++lost;
      EXPECT_EQ(back_ids[i], -1);
      EXPECT_EQ(back[i], Foam::vector::zero);
    } else {
      EXPECT_EQ(back_ids[i], ids[i]);
      EXPECT_EQ(back[i], 2.0 * here[i]);
    }
  }
  EXPECT_EQ(ownership.outsideRows().size(), lost);
  for (const label row : ownership.outsideRows()) EXPECT_EQ(outside.count(ids[row]), 1u);
}

TEST(ParticleOwnership, RowsThatArePassedOverHaveNoOwner) {
  const Foam::pointField points(random_points(40, 12));
  Foam::labelList passed;
  Foam::scalarField values(points.size());
  forAll(points, i) {
    values[i] = 1.0 + i;
    if (i % 3 == 0) passed.append(i);
  }
  Foam::particleOwnership ownership(locator());
  ownership.update(points, passed);
  Foam::List<double> owned, back;
  ownership.toOwner(values, owned);
  ownership.toReceiver(owned, back, -1.0);
  std::set<label> outside(ownership.outsideRows().begin(), ownership.outsideRows().end());
  forAll(points, i) {
    const bool ownerless = i % 3 == 0 || outside.count(i) != 0;
    EXPECT_EQ(back[i], ownerless ? -1.0 : values[i]) << i;
    EXPECT_FALSE(i % 3 == 0 && outside.count(i) != 0) << i;
  }
}

TEST(ParticleOwnership, PointsOnSharedFacesHaveOneOwnerWhoeverReceivesThem) {
  Foam::DynamicList<Foam::point> on_face;
  for (const Foam::polyPatch& patch : mesh().boundaryMesh()) {
    if (!is_between_ranks(patch)) continue;
    on_face.append(patch.localPoints());
    on_face.append(patch.faceCentres());
  }
  const Foam::pointField all(everywhere(Foam::pointField(on_face)));
  for (int turn = 0; turn < Pstream::nProcs(); ++turn) {
    Foam::pointField here;
    if (turn == Pstream::myProcNo()) here = all;
    Foam::particleOwnership ownership(locator());
    ownership.update(here);
    EXPECT_EQ(ownership.nOutsideGlobal(), 0);
    EXPECT_EQ(total(ownership.nOwned()), all.size());
  }
}

// Corners, edges and faces of cells, on patches, on cyclic ones and between ranks too. The right cell
// is known without the mesh: upwards in all directions, downwards only where that is beyond the mesh.
TEST(ParticleOwnershipTies, TheCellOfAPointOnFacesDoesNotKnowTheDecomposition) {
  if (!on_cube() && !on_box()) return;
  const double cell = 1e-3;
  const Foam::boundBox& box = mesh().bounds();
  Foam::DynamicList<Foam::point> points(everywhere(mesh().points()));
  points.append(everywhere(mesh().faceCentres()));
  Foam::DynamicList<Foam::point> on_edges;
  for (const Foam::edge& e : mesh().edges()) on_edges.append(e.centre(mesh().points()));
  points.append(everywhere(Foam::pointField(on_edges)));
  Foam::DynamicList<Foam::point> here;
  forAll(points, i) {
    if (i % Pstream::nProcs() == Pstream::myProcNo()) here.append(points[i]);
  }
  Foam::particleOwnership ownership(locator());
  for (int again = 0; again < 2; ++again) {  // the second time from the cells of the first
    ownership.update(here);
    EXPECT_EQ(ownership.nOutsideGlobal(), 0);
    EXPECT_EQ(total(ownership.nOwned()), points.size());
    Foam::List<Foam::vector> owned;
    ownership.toOwner<Foam::vector>(here, owned);
    forAll(owned, i) {
      Foam::point expected;
      for (int d = 0; d < 3; ++d) {
        const double last = std::round(box.span()[d] / cell) - 1.0;
        const double place = std::floor((owned[i][d] - box.min()[d]) / cell + 1e-6);
        expected[d] = box.min()[d] + (std::min(place, last) + 0.5) * cell;
      }
      EXPECT_LT(mag(mesh().cellCentres()[ownership.cells()[i]] - expected), 1e-6 * cell)
          << owned[i].x() << " " << owned[i].y() << " " << owned[i].z();
    }
  }
}

TEST(ParticleOwnership, NothingMovesWhenAllAreAtHome) {
  const Particles p = random_particles(500, cell_size(), 5);
  Foam::particleOwnership ownership(locator());
  ownership.update(p.positions);
  EXPECT_EQ(ownership.nMovedGlobal(), 0);
  EXPECT_EQ(ownership.nOutsideGlobal(), 0);
  // In the order of the cells, each row with its own.
  Foam::labelList sorted(p.cells);
  Foam::sort(sorted);
  EXPECT_EQ(ownership.cells(), sorted);
  Foam::labelList cells;
  ownership.toOwner<label>(p.cells, cells);
  EXPECT_EQ(ownership.cells(), cells);
}
