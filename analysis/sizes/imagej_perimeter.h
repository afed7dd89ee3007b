// SPDX-License-Identifier: GPL-3.0-or-later
/// \file imagej_perimeter.h
/// Length of an edge from the column Perim. of ImageJ 1.x, all in pixels:
///
///   Perim. = 1.0548 p - 1.79      p = pi d of a smooth edge
///
/// ImageJ follows the sides of pixels and cuts corners: 5.5 % too long for a very large disk, right at
/// about 8 pixels, too short below. 4 A/P of its tables is thus +0.4 % at 8 pixels, -0.7 at 10, -2.5 at
/// 20, -4.7 at 100. Here p is right within 0.3 % from 15 pixels on and 1.2 % too large at 8 to 10 (means
/// over 400 disks at random places).
/// Source: measured with ImageJ 1.53t; its method is PolygonRoi.getTracedPerimeter.
/// Tests: tests/analysis/sizes/imagej_tables_test.cpp
#pragma once

#include <boost/math/constants/constants.hpp>

namespace powderlink::analysis {

inline constexpr double kImagejSlope = 1.0548;
inline constexpr double kImagejOffset_px = 1.79;

inline double edge_of_imagej_px(double perimeter_px) {
  return (perimeter_px + kImagejOffset_px) / kImagejSlope;
}

/// What ImageJ prints for a disk.
inline double imagej_perimeter_px(double diameter_px) {
  return kImagejSlope * boost::math::constants::pi<double>() * diameter_px - kImagejOffset_px;
}

}  // namespace powderlink::analysis
