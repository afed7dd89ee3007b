// SPDX-License-Identifier: GPL-3.0-or-later
// Values of points on periodic patches, on the edges and in the corners of a periodic box.
#include <gtest/gtest.h>

#include "foam_case.h"
#include "mathematicalConstants.H"
#include "pointValues.H"

using namespace powderlink::foam_test;

namespace {
// Sums of eight values of order one.
constexpr double kRoundOff = 1e-12;

// Differs in all directions, has the period of the box.
const Foam::vector kBox(6e-3, 8e-3, 10e-3);
double wave(const Foam::point& r) {
  const double w = 2.0 * Foam::constant::mathematical::pi;
  return std::sin(w * r.x() / kBox.x() + 0.3) * std::cos(w * r.y() / kBox.y() + 0.4) *
             std::sin(w * r.z() / kBox.z() + 0.5) +
         0.5 * std::cos(w * (r.x() / kBox.x() + r.y() / kBox.y() + r.z() / kBox.z()));
}
const Foam::vector kDirection(1.0, -2.0, 0.5);

/// In a box of equal cells a point has the mean of the eight cells around it.
double mean_of_eight(const Foam::point& r) {
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Foam::vector side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    sum += wave(r + 0.5e-3 * side);
  }
  return sum / 8.0;
}
}  // namespace

TEST(PointValues, AreThoseOfAllImagesOnAnyNumberOfRanks) {
  if (!on_box()) GTEST_SKIP() << "needs a box that is periodic in all directions";
  Foam::volScalarField p(Foam::IOobject("p", mesh().time().timeName(), mesh()), mesh(),
                         Foam::dimensionedScalar(Foam::dimless, Foam::Zero));
  forAll(p, c) p[c] = wave(mesh().C()[c]);
  p.correctBoundaryConditions();
  const Foam::volVectorField U("U", p * Foam::dimensionedVector("d", Foam::dimless, kDirection));

  const Foam::pointValues at_points(mesh());
  const Foam::labelList all(Foam::identity(mesh().nPoints()));
  const Foam::scalarField q(at_points.interpolate(p, all));
  const Foam::vectorField u(at_points.interpolate(U, all));
  ASSERT_GT(q.size(), 0);
  forAll(q, i) {
    const double expected = mean_of_eight(mesh().points()[i]);
    EXPECT_NEAR(q[i], expected, kRoundOff);
    EXPECT_LT(mag(u[i] - expected * kDirection), kRoundOff);
  }
}
