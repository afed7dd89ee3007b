// SPDX-License-Identifier: GPL-3.0-or-later
/// \file imagej_table.h
/// Tables as ImageJ 1.x writes them: disks at random places on pixels, and perimeters by its own rule,
/// which follows the sides of pixels and takes 2 - sqrt(2) off at every corner but the second of two that
/// are one pixel apart.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace powderlink::analysis {

struct PixelShape {
  double area_px = 0.0, perimeter_px = 0.0;
  double circularity() const {
    return std::min(1.0, 4.0 * std::acos(-1.0) * area_px / (perimeter_px * perimeter_px));
  }
};

/// Sides of the outline in order, counted from a list of heights of columns: a shape whose columns are
/// whole, [low, high) each.
inline PixelShape traced(const std::vector<std::array<long, 2>>& columns) {
  PixelShape shape;
  std::vector<std::array<long, 2>> corners;  // x, y
  const auto n = static_cast<long>(columns.size());
  const auto add = [&](long x, long y) {
    // A corner on a straight line is none.
    while (corners.size() > 1) {
      const auto &a = corners[corners.size() - 2], &b = corners.back();
      if (!((a[0] == b[0] && b[0] == x) || (a[1] == b[1] && b[1] == y))) break;
      corners.pop_back();
    }
    corners.push_back({x, y});
  };
  for (long x = 0; x < n; ++x) {
    const auto& c = columns[static_cast<std::size_t>(x)];
    shape.area_px += static_cast<double>(c[1] - c[0]);
    add(x, c[0]);
    add(x + 1, c[0]);
  }
  for (long x = n - 1; x >= 0; --x) {
    const auto& c = columns[static_cast<std::size_t>(x)];
    add(x + 1, c[1]);
    add(x, c[1]);
  }
  // ImageJ begins at the left end of the topmost row, where two corners in a row then count.
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(),
                               [](const auto& a, const auto& b) {
                                 return std::pair(a[1], a[0]) < std::pair(b[1], b[0]);
                               }),
              corners.end());
  std::vector<long> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const long side = std::labs(b[0] - a[0]) + std::labs(b[1] - a[1]);
    if (side > 0) sides.push_back(side);
  }
  double cut = 0.0;
  bool corner = false;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const long before = sides[(i + sides.size() - 1) % sides.size()];
    corner = before > 1 || !corner;
    cut += corner ? 1.0 : 0.0;
    shape.perimeter_px += static_cast<double>(sides[i]);
  }
  shape.perimeter_px -= cut * (2.0 - std::sqrt(2.0));
  return shape;
}

/// Pixels whose centre is inside.
inline PixelShape disk_on_pixels(double diameter_px, double x0, double y0) {
  std::vector<std::array<long, 2>> columns;
  const double r = 0.5 * diameter_px;
  for (long x = static_cast<long>(std::floor(x0 - r)); x <= x0 + r; ++x) {
    const double dx = static_cast<double>(x) + 0.5 - x0;
    if (dx * dx >= r * r) continue;
    const double half = std::sqrt(r * r - dx * dx);
    const long low = static_cast<long>(std::ceil(y0 - half - 0.5));
    const long high = static_cast<long>(std::floor(y0 + half - 0.5)) + 1;
    if (high > low) columns.push_back({low, high});
  }
  return traced(columns);
}

/// ImageJ's number: small ones with a power of ten.
inline std::string imagej_number(double value, int decimals) {
  if (value != 0.0 && value < std::pow(10.0, -decimals)) {
    const auto power = static_cast<int>(std::floor(std::log10(value)));
    return fmt::format("{:.{}f}E{}", value / std::pow(10.0, power), decimals, power);
  }
  return fmt::format("{:.{}f}", value, decimals);
}

/// \param unit  of the image's scale per pixel; 1: in pixels
inline std::string imagej_table(const std::vector<double>& diameters_px, unsigned seed,
                                double unit = 1.0, int decimals = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place;
  std::string text = " ,Area,Perim.,Circ.,AR,Round,Solidity\n";
  int number = 0;
  for (const double d : diameters_px) {
    const PixelShape s = disk_on_pixels(d, place(random), place(random));
    text += fmt::format("{},{},{},{},1,1,0.95\n", ++number,
                        imagej_number(s.area_px * unit * unit, unit == 1.0 ? 0 : decimals),
                        imagej_number(s.perimeter_px * unit, decimals),
                        imagej_number(s.circularity(), 3));
  }
  return text;
}

}  // namespace powderlink::analysis
