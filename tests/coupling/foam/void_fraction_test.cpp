// SPDX-License-Identifier: GPL-3.0-or-later
// What is shared over the cells must be what the particles have, wherever they are.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <vector>

#include "foam_case.h"
#include "labelIOList.H"
#include "mathematicalConstants.H"
#include "smoothVoidFraction.H"
#include "voidFraction.H"

using namespace powderlink::foam_test;
using Foam::label;
using Foam::Pstream;

namespace {
// Sums over 1e4 cells and up to 1e2 sweeps: a few hundred times the round-off of one addition.
constexpr double kRoundOff = 1e-12;

Foam::autoPtr<Foam::voidFraction> model(const std::string& type, double length = 0.0) {
  std::string entries = "type " + type + ";";
  if (length > 0.0) entries += " length " + std::to_string(length) + ";";
  return Foam::voidFraction::New(locator(), dictionary_of(entries));
}
double length_of_test() { return 4.0 * cell_size(); }
std::vector<std::string> types() { return {"centre", "divided", "smooth"}; }
Foam::autoPtr<Foam::voidFraction> model_of_test(const std::string& type) {
  return model(type, type == "smooth" ? length_of_test() : 0.0);
}
double standard_deviation(double width) { return width / std::sqrt(8.0 * std::log(2.0)); }
}  // namespace

TEST(VoidFraction, KeepsTheSumOfEveryQuantity) {
  // From a tenth of a cell to particles of three cells' diameter, everywhere up to the walls.
  for (const double largest : {0.5, 1.5}) {
    const Particles p = random_particles(1500, largest * cell_size(), 6);
    for (const std::string& type : types()) {
      SCOPED_TRACE(type);
      auto fraction = model_of_test(type);
      fraction->set(p.positions, p.radii, p.cells);
      const Foam::scalarField& V = mesh().V();
      const double volume = Foam::gSum(V * fraction->solidsFraction().field());
      EXPECT_NEAR(volume, p.total_volume, kRoundOff * p.total_volume);
      EXPECT_GE(Foam::gMin(fraction->solidsFraction().field()), 0.0);
      EXPECT_NEAR(Foam::gSum(V * fraction->deposit(p.values)()), p.total_value,
                  kRoundOff * p.total_value);
      const Foam::vector sum = Foam::gSum(V * fraction->deposit(p.vectors)());
      EXPECT_LT(mag(sum - p.total_vector), kRoundOff * mag(p.total_vector));
    }
  }
}

TEST(VoidFraction, SeveralQuantitiesAtOnceAreTheSameAsOneByOne) {
  const Particles p = random_particles(300, cell_size(), 7);
  for (const std::string& type : types()) {
    SCOPED_TRACE(type);
    auto fraction = model_of_test(type);
    fraction->set(p.positions, p.radii, p.cells);
    const Foam::scalarField alone(fraction->deposit(p.values));
    const Foam::vectorField vectors(fraction->deposit(p.vectors));
    for (const int n : {2, 4, 7, 8}) {
      Foam::scalarField rows(n * p.values.size(), 0.5);
      forAll(p.values, i) {
        rows[i * n] = p.values[i];
        if (n >= 4) {
          for (int d = 0; d < 3; ++d) rows[i * n + 1 + d] = p.vectors[i][d];
        }
      }
      Foam::scalarField densities;
      fraction->deposit(n, rows, densities);
      double error = 0.0;
      forAll(alone, c) {
        error = std::max(error, std::abs(densities[c * n] - alone[c]));
        for (int d = 0; d < 3 && n >= 4; ++d) {
          error = std::max(error, std::abs(densities[c * n + 1 + d] - vectors[c][d]));
        }
      }
      EXPECT_LE(error, kRoundOff * Foam::gMax(alone));
    }
  }
}

// The script runs this on one rank first, which leaves the fields for the others to compare with.
TEST(VoidFraction, DoesNotDependOnTheDecomposition) {
  for (const std::string& type : types()) {
    SCOPED_TRACE(type);
    const Particles p = random_particles(800, cell_size(), 8);
    auto fraction = model_of_test(type);
    fraction->set(p.positions, p.radii, p.cells);
    const Foam::scalarField here(fraction->solidsFraction().field());
    const std::string file = mesh().time().globalPath() + "/one_rank_" + type;
    if (!Pstream::parRun()) {
      std::ofstream(file, std::ios::binary)
          .write(reinterpret_cast<const char*>(here.cdata()), here.byteSize());
      continue;
    }
    std::vector<double> expected(mesh().globalData().nTotalCells());
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(expected.data()), expected.size() * sizeof(double));
    ASSERT_TRUE(in.good()) << file;
    const Foam::labelIOList place(
        Foam::IOobject("cellProcAddressing", mesh().facesInstance(), mesh().meshSubDir, mesh(),
                       Foam::IOobject::MUST_READ, Foam::IOobject::NO_WRITE, false));
    double error = 0.0;
    forAll(here, c) error = std::max(error, std::abs(here[c] - expected[place[c]]));
    EXPECT_LE(error, kRoundOff * Foam::gMax(here));
  }
}

// Moved by whole cells, across the periodic faces and between ranks, every particle must leave the same
// trace: the Fourier amplitude of the solids fraction turns by k s and keeps its size.
TEST(VoidFraction, HasNoSeamAtPeriodicPatches) {
  if (!on_box()) GTEST_SKIP() << "needs a box that is periodic in all directions";
  const Foam::vector box = mesh().bounds().span();
  const Foam::vector moved(3e-3, 5e-3, 4e-3);
  Foam::pointField start(random_points(200, 11));
  Foam::pointField there(start);
  for (Foam::point& r : there) {
    r += moved;
    for (int d = 0; d < 3; ++d) r[d] -= r[d] >= box[d] ? box[d] : 0.0;
  }
  const Foam::scalarField radii(start.size(), 0.8 * cell_size());
  for (const std::string& type : types()) {
    SCOPED_TRACE(type);
    auto fraction = model_of_test(type);
    const auto amplitude = [&](const Foam::pointField& positions, const Foam::vector& k) {
      const Particles p = particles_at(positions, radii);
      fraction->set(p.positions, p.radii, p.cells);
      const Foam::scalarField amount(mesh().V() * fraction->solidsFraction().field());
      const Foam::scalarField phase(mesh().C().primitiveField() & k);
      return std::complex<double>(Foam::gSum((amount * cos(phase))()),
                                  Foam::gSum((amount * sin(phase))()));
    };
    for (const Foam::vector& waves :
         {Foam::vector(1, 0, 0), Foam::vector(0, 1, 0), Foam::vector(1, 1, 1)}) {
      const Foam::vector k = 2.0 * Foam::constant::mathematical::pi * cmptDivide(waves, box);
      const auto before = amplitude(start, k);
      const auto after = amplitude(there, k);
      const double total = Foam::gSum(mesh().V() * fraction->solidsFraction().field());
      EXPECT_GT(std::abs(before), 1e-3 * total);
      EXPECT_LT(std::abs(after - before * std::polar(1.0, k & moved)), kRoundOff * total);
    }
  }
}

TEST(VoidFraction, DividedIsCentreForAParticleInsideOneCell) {
  forAll(mesh().cellCentres(), c) {
    if (c % 97) continue;
    const Foam::pointField position(1, mesh().cellCentres()[c]);
    const Foam::scalarField radius(1, 0.99 * locator().depth(position[0], c));
    const Foam::labelList cell(1, c);
    if (Pstream::parRun()) break;  // one rank sets a particle at a time
    auto divided = model("divided");
    auto centre = model("centre");
    divided->set(position, radius, cell);
    centre->set(position, radius, cell);
    EXPECT_EQ(divided->solidsFraction().field(), centre->solidsFraction().field());
  }
}

TEST(VoidFraction, DividedSharesByTheOverlap) {
  if (!on_cube()) GTEST_SKIP() << "needs cubes";
  // The centre of the cube is a corner of eight cells: each gets an eighth of the particle but for
  // the points on their faces. Of 29 points the 16 towards corners are inside, 2 per cell.
  const Particles p = one_particle(mesh().bounds().midpoint(), 0.9 * cell_size());
  auto fraction = model("divided");
  fraction->set(p.positions, p.radii, p.cells);
  int with = 0;
  double least = 1.0;
  forAll(mesh().V(), c) {
    const double share = fraction->solidsFraction()[c] * mesh().V()[c] / p.total_volume;
    if (share > 0.0) {
      ++with;
      least = std::min(least, share);
    }
  }
  EXPECT_EQ(Foam::returnReduce(with, Foam::sumOp<int>()), 8);
  EXPECT_GT(Foam::returnReduce(least, Foam::minOp<double>()), 1.999 / 29.0);
}

TEST(VoidFraction, SmoothHasTheSecondMomentOfItsGaussianOnAnyCellSize) {
  if (!on_cube()) GTEST_SKIP() << "needs equal cells";
  // Cells from one width to a quarter of it; the walls are 7 sigma away, out of the kernel's reach.
  for (const double width_in_cells : {1.0, 2.0, 4.0}) {
    const double width = width_in_cells * cell_size();
    const double sigma = standard_deviation(width);
    const Foam::point centre(Foam::vector::uniform(12.5 * cell_size()));
    const Particles p = one_particle(centre, 0.5 * width);
    auto fraction = model("smooth", width);
    fraction->set(p.positions, p.radii, p.cells);
    const Foam::scalarField weight(fraction->solidsFraction().field() * mesh().V().field() /
                                   p.total_volume);
    const Foam::vectorField r(mesh().C().primitiveField() - centre);
    EXPECT_LT(mag(Foam::gSum(weight * r)), 1e-7 * sigma);
    for (int d = 0; d < 3; ++d) {
      // Exact but for the 1e-11 that reaches the walls with the largest width.
      EXPECT_NEAR(Foam::gSum(weight * sqr(r.component(d)())), sigma * sigma, 1e-8 * sigma * sigma);
    }
    if (width_in_cells < 4.0) continue;
    // Many sweeps: the fourth moment and the height of a Gaussian, up to terms of order 1/sweeps
    // and (cell/sigma)^2.
    const double fourth = Foam::gSum(weight * pow4(r.component(0)()));
    EXPECT_NEAR(fourth, 3.0 * std::pow(sigma, 4), 0.1 * 3.0 * std::pow(sigma, 4));
    const double height = std::pow(2.0 * M_PI * sigma * sigma, -1.5) * p.total_volume;
    EXPECT_NEAR(Foam::gMax(fraction->solidsFraction().field()), height, 0.1 * height);
  }
}

TEST(VoidFraction, SmoothGoesThroughPeriodicPatches) {
  if (!on_cube()) GTEST_SKIP() << "needs periodic patches";
  // The kernel of a particle in the lowest layer is that of one in a layer inside, moved round.
  const double size = cell_size();
  const double height = mesh().bounds().span().z();
  std::vector<Foam::scalarField> shares;  // per layer
  for (const double z : {0.5, 10.5}) {
    const Particles p = one_particle(Foam::point(12.5 * size, 12.5 * size, z * size), size);
    auto fraction = model_of_test("smooth");
    fraction->set(p.positions, p.radii, p.cells);
    Foam::scalarField share(24, 0.0);
    forAll(mesh().V(), c) {
      const double above = mesh().C()[c].z() - z * size + height;
      share[static_cast<int>(std::lround(above / size)) % 24] +=
          fraction->solidsFraction()[c] * mesh().V()[c] / p.total_volume;
    }
    Foam::Pstream::listCombineGather(share, Foam::plusEqOp<double>());
    Foam::Pstream::listCombineScatter(share);
    shares.push_back(share);
  }
  EXPECT_GT(shares[0][23], 0.1);
  forAll(shares[0], layer) EXPECT_NEAR(shares[0][layer], shares[1][layer], kRoundOff);
}

TEST(VoidFraction, SmoothLeavesAnEvenFillingEven) {
  // One particle per cell in proportion to its volume: on a skewed mesh with walls too.
  const Foam::scalarField& V = mesh().V();
  const Foam::scalarField radii(cbrt(0.3 * V * 3.0 / (4.0 * M_PI)));
  auto fraction = model_of_test("smooth");
  fraction->set(mesh().cellCentres(), radii, Foam::identity(mesh().nCells()));
  EXPECT_NEAR(Foam::gMin(fraction->solidsFraction().field()), 0.3, 0.3 * kRoundOff);
  EXPECT_NEAR(Foam::gMax(fraction->solidsFraction().field()), 0.3, 0.3 * kRoundOff);
}

TEST(VoidFraction, SmoothStaysBelowThePackingWithParticlesLargerThanCells) {
  if (!on_cube()) GTEST_SKIP() << "needs equal cells";
  // A cubic packing of spheres of three cells' diameter has pi/6 of its volume. centre cannot serve
  // this mesh: 27 cells share the volume that it puts into one.
  const double d = 3.0 * cell_size();
  Foam::pointField positions;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      for (int k = 0; k < 8; ++k) positions.append(d * Foam::vector(i + 0.5, j + 0.5, k + 0.5));
    }
  }
  Foam::DynamicList<Foam::point> here;
  Foam::DynamicList<label> cells;
  for (const Foam::point& p : positions) {
    const label c = locator().find(p);
    if (c < 0) continue;
    here.append(p);
    cells.append(c);
  }
  const Foam::scalarField radii(here.size(), 0.5 * d);
  auto smooth = model("smooth", 3.0 * d);
  smooth->set(here, radii, cells);
  // Reflecting walls and periodic patches continue the packing, so that it is even everywhere; what
  // is left of the lattice is exp(-2 pi^2 sigma^2/d^2) = 1e-14.
  EXPECT_NEAR(Foam::gMax(smooth->solidsFraction().field()), M_PI / 6.0, 1e-9);
  EXPECT_NEAR(Foam::gMin(smooth->solidsFraction().field()), M_PI / 6.0, 1e-9);
  smooth->checkFluidFraction(0.2);

  auto centre = model("centre");
  centre->set(here, radii, cells);
  const std::string text = error_of([&] { centre->checkFluidFraction(0.2); });
  for (const char* part :
       {"model centre cannot serve this mesh", "in cell", "given:", "solids fraction 14.1",
        "allowed:", "minFluidFraction = 0.2", "to do:", "type smooth; length 0.009"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  }
}

TEST(VoidFraction, RefusesUnknownModelsAndEntries) {
  EXPECT_NE(error_of([] { model("gaussian"); }).find("(centre divided smooth)"), std::string::npos);
  EXPECT_NE(
      error_of([] { Foam::voidFraction::New(locator(), Foam::dictionary()); }).find("missing"),
      std::string::npos);
  EXPECT_NE(error_of([] { model("centre", 1e-3); }).find("unknown entry"), std::string::npos);
  EXPECT_NE(error_of([] { model("smooth"); }).find("missing entry length"), std::string::npos);
  const auto huge = [] {
    Foam::voidFraction::New(locator(), dictionary_of("type smooth; length 1000;"));
  };
  EXPECT_NE(error_of(huge).find("at most"), std::string::npos);
}
