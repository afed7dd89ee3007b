// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_population.h"

#include <cmath>
#include <random>

namespace powderlink::host {

namespace {
constexpr double kOffCentreU = 0.0127;  // of the spacing; no simple fraction of a mesh
constexpr double kOffCentreV = 0.0071;
}  // namespace

std::vector<double> graded_diameters(double d_min, double d_max, int n) {
  std::vector<double> d;
  d.reserve(n);
  for (int i = 0; i < n; ++i) {
    d.push_back(n == 1 ? d_min : d_min * std::pow(d_max / d_min, static_cast<double>(i) / (n - 1)));
  }
  return d;
}

std::vector<double> rosin_rammler_diameters(double x0, double exponent, double d_min, double d_max,
                                            int n, std::uint64_t seed) {
  const auto finer = [&](double d) { return -std::expm1(-std::pow(d / x0, exponent)); };
  const double low = finer(d_min);
  const double high = finer(d_max);
  std::mt19937_64 generator(seed);
  std::vector<double> d;
  for (int i = 0; i < n; ++i) {
    // 53 bits by hand: std::uniform_real_distribution differs between libraries.
    const double uniform = static_cast<double>(generator() >> 11) * 0x1.0p-53;
    d.push_back(x0 * std::pow(-std::log1p(-(low + uniform * (high - low))), 1.0 / exponent));
  }
  return d;
}

std::vector<PlanePoint> square_grid(std::size_t n, double spacing) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  const double centre = 0.5 * (static_cast<double>(side) - 1.0);
  std::vector<PlanePoint> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = i / side;
    const std::size_t column = i % side;
    points.push_back({(static_cast<double>(column) - centre + kOffCentreU) * spacing,
                      (static_cast<double>(row) - centre + kOffCentreV) * spacing});
  }
  return points;
}

}  // namespace powderlink::host
