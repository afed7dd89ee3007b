// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/dem/critical_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/kat/reduced/critical_diameter.h"

namespace powderlink::analysis {

namespace {

constexpr int kMostRounds = 12;
constexpr double kOverlapOfRanges = 1.02;
constexpr double kFirstWidening = 1.6;
constexpr double kWidestWidening = 3.0;

[[noreturn]] void not_bracketed(const SearchRange& range, bool all_attached, bool given) {
  const std::string limit =
      fmt::format("{:.4g} um", 1e6 * (all_attached ? range.largest_m : range.smallest_m));
  throw InvalidInput(
      given ? "diameter_range_um" : "critical diameter",
      fmt::format("{:.4g} to {:.4g} um, where every particle {}", range.smallest_m * 1e6,
                  range.largest_m * 1e6, all_attached ? "stayed attached" : "left the plate"),
      "a range with the critical diameter inside",
      all_attached ? "widen it upwards: the critical diameter is above " + limit
                   : "widen it downwards: the critical diameter is below " + limit);
}

}  // namespace

SearchResult search_critical_diameter(const RunPopulation& run, SearchRange range,
                                      double resolution) {
  SearchResult result;
  double widening = kFirstWidening;
  bool once_bracketed = false;
  while (result.rounds < kMostRounds) {
    const DropResult drop = run(range.smallest_m, range.largest_m, ++result.rounds);
    result.wall_s += drop.wall_s;
    for (const DropParticle& p : drop.particles) {
      result.largest_balance = std::max(result.largest_balance, std::fabs(p.balance));
    }
    result.particles.insert(result.particles.end(), drop.particles.begin(), drop.particles.end());

    if (!drop.bracketed()) {
      const bool all_attached = drop.largest_attached_m > 0.0;
      if (range.given && !once_bracketed) not_bracketed(range, all_attached, true);
      if (all_attached ? range.largest_m > kLargestDiameter_m
                       : range.smallest_m < kSmallestDiameter_m) {
        not_bracketed(range, all_attached, false);
      }
      if (all_attached) {
        range.smallest_m = range.largest_m / kOverlapOfRanges;
        range.largest_m *= widening;
      } else {
        range.largest_m = range.smallest_m * kOverlapOfRanges;
        range.smallest_m /= widening;
      }
      widening = std::min(widening * widening, kWidestWidening);
      continue;
    }
    if (!once_bracketed) {
      for (const DropParticle& p : drop.particles)
        ++(p.attached ? result.attached : result.detached);
      once_bracketed = true;
    }
    result.largest_attached_m = drop.largest_attached_m;
    result.smallest_detached_m = drop.smallest_detached_m;
    result.critical_diameter_m = std::sqrt(drop.largest_attached_m * drop.smallest_detached_m);
    // Sizes that are out of order give an inverted bracket: its width counts all the same.
    const double low = std::min(drop.largest_attached_m, drop.smallest_detached_m);
    const double high = std::max(drop.largest_attached_m, drop.smallest_detached_m);
    if (high / low - 1.0 <= resolution) break;
    const double margin = std::sqrt(high / low);
    range = {low / margin, high * margin, false};
    widening = kFirstWidening;
  }
  if (!once_bracketed) not_bracketed(range, result.particles.back().attached, false);
  std::sort(
      result.particles.begin(), result.particles.end(),
      [](const DropParticle& a, const DropParticle& b) { return a.diameter_m < b.diameter_m; });
  return result;
}

}  // namespace powderlink::analysis
