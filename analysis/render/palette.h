// SPDX-License-Identifier: GPL-3.0-or-later
/// \file palette.h
/// Colours that people with any colour vision, and a grey printer, can tell apart: blue for grains
/// that stay, yellow over orange to dark red for those that leave or flow, blues for the gas.
/// scripts/plots/style.gp and scripts/paraview/kat_view.py use the same ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace powderlink::render {

using Colour = std::array<double, 3>;  ///< red, green, blue in 0 ... 1

constexpr Colour kAttached{0.267, 0.467, 0.667};  // #4477AA
constexpr Colour kPlate{0.78, 0.79, 0.81};
constexpr Colour kInk{0.10, 0.10, 0.10};

/// Between equally spaced stops; `fraction` outside 0 ... 1 takes the end's colour.
template <std::size_t n>
Colour blend(const std::array<Colour, n>& stops, double fraction) {
  const double position = std::clamp(fraction, 0.0, 1.0) * (n - 1);
  const auto lower = std::min(static_cast<std::size_t>(position), n - 2);
  const double share = position - static_cast<double>(lower);
  Colour mixed{};
  for (std::size_t c = 0; c < 3; ++c) {
    mixed[c] = (1.0 - share) * stops[lower][c] + share * stops[lower + 1][c];
  }
  return mixed;
}

/// Colour of a leaving or flowing grain; `fraction` is its speed over the largest of the scale.
inline Colour leaving_colour(double fraction) {
  constexpr std::array<Colour, 4> stops{{{0.969, 0.796, 0.271},    // #F7CB45
                                         {0.933, 0.510, 0.149},    // #EE8226
                                         {0.796, 0.243, 0.114},    // #CB3E1D
                                         {0.447, 0.098, 0.055}}};  // #72190E
  return blend(stops, fraction);
}

/// Colour of the gas: blues, none of which a grain has.
inline Colour gas_colour(double fraction) {
  constexpr std::array<Colour, 4> stops{{{0.969, 0.976, 0.988},    // #F7F9FC
                                         {0.741, 0.824, 0.910},    // #BDD2E8
                                         {0.267, 0.467, 0.667},    // #4477AA
                                         {0.071, 0.157, 0.294}}};  // #12284B
  return blend(stops, fraction);
}

}  // namespace powderlink::render
