// SPDX-License-Identifier: GPL-3.0-or-later
/// \file frame_choice.h
/// Which states a picture shows, and which part of the plate.
/// Tests: tests/analysis/render/frame_choice_test.cpp, tests/analysis/render/picture_test.cpp
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/render/particle_frame.h"
#include "analysis/render/run_directory.h"

namespace powderlink::render {

/// Part of the plate in the picture [um]; grains are taken by their place before the impact.
struct ViewWindow {
  double x_um = 0.0, y_um = 0.0;            ///< centre
  double width_um = 0.0, breadth_um = 0.0;  ///< along the picture, along the line of sight
  double depth_um = 0.0;                    ///< below the plate

  bool holds(const Grain& grain) const {
    return 2.0 * (grain.x_um > x_um ? grain.x_um - x_um : x_um - grain.x_um) <= width_um &&
           2.0 * (grain.y_um > y_um ? grain.y_um - y_um : y_um - grain.y_um) <= breadth_um;
  }
};

/// One state: dumped, or continued from the last dumped one in free flight.
struct State {
  long step = 0;
  double clock = 0.0;     ///< time [s], or the step when no time step is known
  double flight_s = 0.0;  ///< since the last dumped state
  double plate_z_um = 0.0;
  std::vector<Grain> grains;

  std::size_t attached() const;
};

State read_state(const RunDirectory& run, std::size_t index, const std::string& fix);

/// Free fall of the detached grains after the last dumped state; the plate and what it holds rest.
/// A run ends when it is known who leaves, often only a few um below the plate.
State fly(const State& last, double duration_s);

/// Time after which the first grain from the window has fallen through `share` of its depth, at
/// most; 0 when it already has, or when none leaves.
double flight_time_s(const State& last, const State& before, const ViewWindow& window,
                     double share);

/// Index of the last state in which the most grains are attached: just before the impact shows.
std::size_t state_before(const std::vector<State>& states);

/// A part of the plate where many grains stay and many leave.
/// \param columns  grains side by side
ViewWindow choose_window(const State& before, const State& end, double columns,
                         double breadth_over_width, double depth_over_width);

/// The grains of a state that sat in the window before the impact and are not below its depth now.
std::vector<Grain> grains_in(const State& state, const State& before, const ViewWindow& window);

/// `count` states from before the impact until the leaving grains leave the window.
std::vector<std::size_t> choose_states(const std::vector<State>& states, const ViewWindow& window,
                                       std::size_t count);

}  // namespace powderlink::render
