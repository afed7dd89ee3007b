// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_channel.h
/// What is known of a channel before its particles are read, and which axis and part of it count
/// where the user says nothing:
///   axis  choose_flow_axis()
///   part  its last third downstream, as a flow has developed there; all of it when the dumps' box is
///         periodic along the axis, where nothing develops
/// The channel is the mesh, else the stretch of the probes of p, else the dumps' box.
/// Tests: tests/analysis/flow/flow_axis_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/flow/run/flow_axis.h"

namespace powderlink::analysis {

struct FlowChannel {
  std::vector<Place> probes;
  std::optional<Extent> mesh;
  DumpState state;  ///< a late one
  FlowAxis axis;    ///< that is chosen

  /// From and to along the axis [m].
  std::optional<std::pair<double, double>> stretch_m() const;
  /// Mesh and dumps' box together along the axis [m]: no particle is beyond.
  std::optional<std::pair<double, double>> reach_m() const;
  /// The part that counts [m], infinite where nothing bounds it.
  std::pair<double, double> developed_m() const;
};

/// \param state  of the particles; an empty one where there are none
/// \param axis   the user's choice
/// \param set    of probes; empty: that with the most
FlowChannel look_at_channel(const std::filesystem::path& case_folder, DumpState state,
                            const std::optional<std::string>& axis = {},
                            const std::string& set = "");

}  // namespace powderlink::analysis
