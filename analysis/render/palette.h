// SPDX-License-Identifier: GPL-3.0-or-later
/// \file palette.h
/// Colours that people with any colour vision, and a grey printer, can tell apart: blue for grains
/// that stay, yellow over orange to dark red for those that leave. scripts/plots/style.gp and
/// scripts/paraview/kat_view.py use the same ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace powderlink::render {

using Colour = std::array<double, 3>;  ///< red, green, blue in 0 ... 1

constexpr Colour kAttached{0.267, 0.467, 0.667};  // #4477AA
constexpr Colour kPlate{0.78, 0.79, 0.81};
constexpr Colour kInk{0.10, 0.10, 0.10};

/// Colour of a leaving grain; `fraction` is its speed over the largest one of the scale.
inline Colour leaving_colour(double fraction) {
  constexpr std::array<Colour, 4> stops{{{0.969, 0.796, 0.271},    // #F7CB45
                                         {0.933, 0.510, 0.149},    // #EE8226
                                         {0.796, 0.243, 0.114},    // #CB3E1D
                                         {0.447, 0.098, 0.055}}};  // #72190E
  const double position = std::clamp(fraction, 0.0, 1.0) * (stops.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double share = position - static_cast<double>(lower);
  Colour mixed{};
  for (std::size_t c = 0; c < 3; ++c) {
    mixed[c] = (1.0 - share) * stops[lower][c] + share * stops[lower + 1][c];
  }
  return mixed;
}

}  // namespace powderlink::render
