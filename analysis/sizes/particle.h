// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle.h
/// One grain as a micrograph shows it: the shadow's area A and perimeter P.
///   d_A = sqrt(4 A/pi)      diameter of the disk with the same area                      [um]
///   d_P = 4 A/P             four times the hydraulic radius; the disk's diameter too     [um]
///   circularity = min(1, 4 pi A/P^2) = min(1, (d_P/d_A)^2)
/// d_P <= d_A, as no shape has a shorter edge than the disk; d_P reacts to a ragged edge and to how
/// the perimeter of pixels was estimated, d_A to neither (docs/particle_sizes.md).
/// Tests: tests/analysis/sizes/particle_table_test.cpp
#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstddef>
#include <optional>

namespace powderlink::analysis {

struct Particle {
  std::size_t file = 0;  ///< which of the files it comes from
  int place = 0;         ///< line of the table, or number in the overlay
  double area_um2 = 0.0, perimeter_um = 0.0;
  std::optional<double> aspect_ratio;  ///< long over short axis of the equal ellipse, >= 1
  std::optional<double> feret_um;      ///< largest distance between two points of the edge

  double area_diameter_um() const {
    return std::sqrt(4.0 * area_um2 / boost::math::constants::pi<double>());
  }
  double perimeter_diameter_um() const { return 4.0 * area_um2 / perimeter_um; }
  double circularity() const {
    const double ratio = perimeter_diameter_um() / area_diameter_um();
    return std::min(1.0, ratio * ratio);
  }
};

}  // namespace powderlink::analysis
