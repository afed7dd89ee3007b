// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/critical_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// A population of n sizes in equal ratios, of which everything above `critical` leaves.
RunPopulation population(double critical, int n, int* runs = nullptr) {
  return [=](double smallest, double largest, int) {
    DropResult r;
    for (int i = 0; i < n; ++i) {
      const double d = smallest * std::pow(largest / smallest, i / (n - 1.0));
      const bool attached = d < critical;
      r.particles.push_back({d, attached, attached ? 0.0 : 1.0, 1e-12});
      if (attached) r.largest_attached_m = std::max(r.largest_attached_m, d);
      if (!attached)
        r.smallest_detached_m =
            r.smallest_detached_m == 0.0 ? d : std::min(r.smallest_detached_m, d);
    }
    r.wall_s = 1.0;
    if (runs != nullptr) ++*runs;
    return r;
  };
}

TEST(CriticalSearch, ClosesInOnTheCriticalDiameter) {
  for (const int n : {8, 16, 64}) {
    int runs = 0;
    const SearchResult r =
        search_critical_diameter(population(46e-6, n, &runs), {37e-6, 57e-6, false}, 0.002);
    EXPECT_LE(r.largest_attached_m, 46e-6);
    EXPECT_GE(r.smallest_detached_m, 46e-6);
    EXPECT_LE(r.smallest_detached_m / r.largest_attached_m - 1.0, 0.002);
    EXPECT_NEAR(r.critical_diameter_m / 46e-6, 1.0, 0.002);
    EXPECT_EQ(r.attached + r.detached, n);
    EXPECT_EQ(r.rounds, runs);
    EXPECT_EQ(r.wall_s, runs);
    EXPECT_EQ(r.particles.size(), static_cast<std::size_t>(n * runs));
    EXPECT_LE(runs, n == 64 ? 2 : 5);
  }
}

TEST(CriticalSearch, WidensARangeOfItsOwn) {
  for (const double critical : {10e-6, 200e-6}) {
    const SearchResult r =
        search_critical_diameter(population(critical, 32), {37e-6, 57e-6, false}, 0.002);
    EXPECT_NEAR(r.critical_diameter_m / critical, 1.0, 0.002);
  }
}

TEST(CriticalSearch, GivenRangeSaysWhichWayToWiden) {
  expect_refusal(
      [] {
        search_critical_diameter(population(80e-6, 16), {37e-6, 57e-6, true}, 0.002);
      },
      {"diameter_range_um", "stayed attached", "widen it upwards", "above 57 um"});
  expect_refusal(
      [] {
        search_critical_diameter(population(20e-6, 16), {37e-6, 57e-6, true}, 0.002);
      },
      {"diameter_range_um", "left the plate", "widen it downwards", "below 37 um"});
}

TEST(CriticalSearch, GivesUpWithAMessage) {
  expect_refusal(
      [] {
        search_critical_diameter(population(1e9, 8), {37e-6, 57e-6, false}, 0.002);
      },
      {"critical diameter", "widen it upwards"});
}

TEST(CriticalSearch, SizesOutOfOrderEnd) {
  // One grain in the middle of the large ones stays, whatever the range.
  const RunPopulation odd = [](double smallest, double largest, int round) {
    DropResult r = population(46e-6, 32)(smallest, largest, round);
    r.particles[20].attached = true;
    r.largest_attached_m = r.particles[20].diameter_m;
    return r;
  };
  const SearchResult r = search_critical_diameter(odd, {37e-6, 57e-6, false}, 0.002);
  EXPECT_NEAR(r.critical_diameter_m / 46e-6, 1.0, 0.1);
}

}  // namespace
}  // namespace powderlink::analysis
