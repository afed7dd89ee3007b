// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_population.h
/// Sizes of the grains of a Kinetic Adhesion Test, and their places on the plate.
/// Tests: tests/liggghts_styles/kat_drop/kat_population_test.cpp
#pragma once

#include <cstdint>
#include <vector>

namespace powderlink::host {

/// n diameters from d_min to d_max [m], equal ratios (one diameter if n is 1).
std::vector<double> graded_diameters(double d_min, double d_max, int n);

/// n diameters [m] by NUMBER from the Rosin-Rammler law Y(d) = 1 - exp(-(d/x0)^exponent), truncated
/// to [d_min, d_max]. The same seed gives the same sizes on every machine.
std::vector<double> rosin_rammler_diameters(double x0, double exponent, double d_min, double d_max,
                                            int n, std::uint64_t seed);

/// Distance of neighbours on the square grid, over the largest diameter: grains must not touch.
inline constexpr double kGridSpacing = 1.2;

/// In-plane places (u, v) on a square grid around (0, 0), one per diameter, in the given order [m].
/// The grid is a little off centre: a mesh plate often has a vertex there, and LIGGGHTS counts a
/// sphere exactly above a vertex on two triangles.
struct PlanePoint {
  double u, v;
};
std::vector<PlanePoint> square_grid(std::size_t n, double spacing);

}  // namespace powderlink::host
