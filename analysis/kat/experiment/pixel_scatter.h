// SPDX-License-Identifier: GPL-3.0-or-later
/// \file pixel_scatter.h
/// What the grid of pixels leaves open in a diameter, relative to it:
///   scatter  0.33 (d/p)^-3/2   standard deviation of one disk, by where it lies on the grid
///   shift    0.05 (d/p)^-3/2   ... of the mean of many of one size: it swings with d as the pixels of
///                              the edge fall into place, and does not become less with their number
/// Symbols: d diameter, p side of a pixel. The area, a count of pixels, scatters with the root of the
/// number of edge pixels, so by d^1/2 of d^2. Disks at random places gave 0.27 (ImageJ 1.53t, threshold)
/// and 0.35 to 0.40 (powderlink psd, which smooths; with noise of 4 to 8 % of the contrast).
/// Valid from 5 pixels for grains near to disks; 0 where the pixel is not known.
/// Source: measured; D. G. Kendall, Quart. J. Math. 19 (1948) 1 (points of a lattice in a random disk).
/// Tests: tests/analysis/kat/retention_coverage_test.cpp
#pragma once

#include <cmath>

namespace powderlink::analysis {

/// (d/p)^-3/2 of ln(d/um) and p [um]; 0 where p is 0: not known.
inline double pixel_measure(double log_diameter, double pixel_um) {
  return pixel_um > 0.0 ? std::exp(-1.5 * (log_diameter - std::log(pixel_um))) : 0.0;
}

inline double pixel_scatter(double log_diameter, double pixel_um) {
  return 0.33 * pixel_measure(log_diameter, pixel_um);
}

inline double pixel_shift(double log_diameter, double pixel_um) {
  return 0.05 * pixel_measure(log_diameter, pixel_um);
}

}  // namespace powderlink::analysis
