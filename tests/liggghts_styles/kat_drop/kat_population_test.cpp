// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and places of the grains against the laws they are drawn from.
#include "liggghts_styles/kat_drop/kat_population.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace powderlink {
namespace {

using host::graded_diameters;
using host::rosin_rammler_diameters;
using host::square_grid;

constexpr double kRounding = 1e-13;

TEST(GradedDiameters, HaveEqualRatiosAndMeetBothEnds) {
  const double low = 20e-6, high = 90e-6;
  const auto d = graded_diameters(low, high, 101);
  ASSERT_EQ(d.size(), 101U);
  EXPECT_NEAR(d.front(), low, kRounding * low);
  EXPECT_NEAR(d.back(), high, kRounding * high);
  const double ratio = std::pow(high / low, 0.01);
  for (std::size_t i = 1; i < d.size(); ++i)
    EXPECT_NEAR(d[i] / d[i - 1], ratio, kRounding * 10) << i;
}

TEST(GradedDiameters, OneGrainAndOneSize) {
  EXPECT_EQ(graded_diameters(3e-5, 9e-5, 1), std::vector<double>{3e-5});
  for (const double d : graded_diameters(3e-5, 3e-5, 5)) EXPECT_NEAR(d, 3e-5, kRounding * 3e-5);
}

/// Largest distance of the sample's distribution from the truncated Rosin-Rammler law.
double kolmogorov_distance(std::vector<double> d, double x0, double n, double low, double high) {
  std::sort(d.begin(), d.end());
  const auto finer = [&](double x) { return 1 - std::exp(-std::pow(x / x0, n)); };
  double distance = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double law = (finer(d[i]) - finer(low)) / (finer(high) - finer(low));
    const double share = 1.0 / static_cast<double>(d.size());
    distance = std::max({distance, std::fabs(law - static_cast<double>(i) * share),
                         std::fabs(law - static_cast<double>(i + 1) * share)});
  }
  return distance;
}

TEST(RosinRammler, FollowsTheTruncatedLaw) {
  const int count = 20000;
  // Kolmogorov's 0.1 % point: one seed in a thousand would miss it; the seeds here are fixed.
  const double allowed = 1.95 / std::sqrt(double(count));
  struct Law {
    double x0, n, low, high;
  };
  for (const Law& law : std::vector<Law>{
           {60e-6, 3.5, 20e-6, 106e-6}, {60e-6, 1.0, 1e-6, 1e-3}, {30e-6, 8.0, 35e-6, 40e-6}}) {
    for (const std::uint64_t seed : {1U, 77U}) {
      const auto d = rosin_rammler_diameters(law.x0, law.n, law.low, law.high, count, seed);
      ASSERT_EQ(d.size(), static_cast<std::size_t>(count));
      EXPECT_LT(kolmogorov_distance(d, law.x0, law.n, law.low, law.high), allowed)
          << law.n << " seed " << seed;
      EXPECT_GE(*std::min_element(d.begin(), d.end()), law.low * (1 - kRounding));
      EXPECT_LE(*std::max_element(d.begin(), d.end()), law.high * (1 + kRounding));
    }
  }
}

TEST(RosinRammler, TheSeedDecides) {
  const auto draw = [](std::uint64_t seed) {
    return rosin_rammler_diameters(6e-5, 3.0, 2e-5, 1e-4, 50, seed);
  };
  EXPECT_EQ(draw(5), draw(5));
  EXPECT_NE(draw(5), draw(6));
  // More grains from the same seed begin with the same ones.
  const auto longer = rosin_rammler_diameters(6e-5, 3.0, 2e-5, 1e-4, 80, 5);
  EXPECT_TRUE(std::equal(longer.begin(), longer.begin() + 50, draw(5).begin()));
}

// Of the spacing: the grid stands a little off centre, so that no grain sits on an edge of a plate
// that is meshed with a simple fraction of the spacing.
constexpr double kOffCentre = 0.02;

TEST(SquareGrid, KeepsNeighboursApartAndIsCentred) {
  const double spacing = 1.2e-4;
  for (const std::size_t n : {1U, 2U, 9U, 10U, 100U, 1000U}) {
    const auto points = square_grid(n, spacing);
    ASSERT_EQ(points.size(), n);
    const double side = std::ceil(std::sqrt(static_cast<double>(n))) - 1;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_LE(std::fabs(points[i].u), (0.5 * side + kOffCentre) * spacing);
      EXPECT_LE(std::fabs(points[i].v), (0.5 * side + kOffCentre) * spacing);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(std::hypot(points[i].u - points[j].u, points[i].v - points[j].v),
                  spacing * (1 - kRounding));
      }
    }
  }
  double u = 0.0, v = 0.0;
  for (const auto& p : square_grid(49, spacing)) u += p.u, v += p.v;
  EXPECT_NEAR(u / 49, 0.0, kOffCentre * spacing);
  EXPECT_NEAR(v / 49, 0.0, kOffCentre * spacing);
}

TEST(SquareGrid, GrainsOfTheLargestSizeDoNotTouch) {
  EXPECT_GT(host::kGridSpacing, 1.0);
  const auto d = graded_diameters(2e-5, 9e-5, 200);
  const auto points = square_grid(d.size(), host::kGridSpacing * 9e-5);
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      // Grains on a plate: centres at their own radius above it.
      const double distance =
          std::hypot(points[i].u - points[j].u, points[i].v - points[j].v, 0.5 * (d[i] - d[j]));
      ASSERT_GT(distance, 0.5 * (d[i] + d[j]));
    }
  }
}

}  // namespace
}  // namespace powderlink
