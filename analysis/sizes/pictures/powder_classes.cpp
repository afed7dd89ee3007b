// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/powder_classes.h"

#include <algorithm>
#include <cmath>

namespace powderlink::analysis {

namespace {

/// RunningSums over the grains below each place.
struct RunningSums {
  explicit RunningSums(const std::vector<double>& d)
      : diameters(d), weight{0.0}, first{0.0}, cubes{0.0} {
    for (const double x : d) cubes.push_back(cubes.back() + x * x * x);
    const auto n = static_cast<double>(d.size());
    for (const double x : d) {
      const double w = 0.5 * (1.0 / n + x * x * x / cubes.back());
      weight.push_back(weight.back() + w);
      first.push_back(first.back() + w * std::log(x / d.back()));
    }
  }
  /// What the scatter of ln d is less by, against all of them in one place.
  double gathered(std::size_t begin, std::size_t end) const {
    const double sum = first[end] - first[begin];
    return sum * sum / (weight[end] - weight[begin]);
  }

  const std::vector<double>& diameters;
  std::vector<double> weight, first, cubes;
};

struct Part {
  std::size_t begin = 0, end = 0;  // of the sorted grains
  std::size_t limit = 0;           // where it is best parted
  double gain = -1.0;              // of that; stays below 0 where there is one size
};

Part part(const RunningSums& s, std::size_t begin, std::size_t end) {
  Part p{begin, end};
  const double whole = s.gathered(begin, end);
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (!(s.diameters[i - 1] < s.diameters[i])) continue;
    // Rounding may see no gain in parting two sizes.
    const double gain = std::max(0.0, s.gathered(begin, i) + s.gathered(i, end) - whole);
    if (!(gain > p.gain)) continue;
    p.gain = gain;
    p.limit = i;
  }
  return p;
}

}  // namespace

std::vector<PowderClass> powder_classes(const SizeDistribution& sample, std::size_t most) {
  const std::vector<double>& d = sample.diameters_um();
  const RunningSums sums(d);
  std::vector<Part> parts{part(sums, 0, d.size())};
  while (parts.size() < most) {
    const auto next = std::max_element(
        parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.gain < b.gain; });
    if (next->gain < 0.0) break;
    const Part old = *next;
    *next = part(sums, old.begin, old.limit);
    parts.push_back(part(sums, old.limit, old.end));
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.begin < b.begin; });
  std::vector<PowderClass> classes;
  for (const Part& p : parts) {
    const auto grains = static_cast<double>(p.end - p.begin);
    const double cubes = sums.cubes[p.end] - sums.cubes[p.begin];
    classes.push_back({std::cbrt(cubes / grains), grains / static_cast<double>(d.size()),
                       cubes / sums.cubes.back(), d[p.begin], d[p.end - 1]});
  }
  return classes;
}

}  // namespace powderlink::analysis
