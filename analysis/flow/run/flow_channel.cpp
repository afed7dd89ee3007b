// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/flow_channel.h"

#include <algorithm>
#include <limits>

#include "analysis/flow/foam/foam_files.h"
#include "analysis/flow/run/pressure_profile.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

// Of the channel, with a margin so that a probe at two thirds of its length counts.
constexpr double kDownstream = 1.0 / 3.0 + 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<std::pair<double, double>> FlowChannel::stretch_m() const {
  const std::size_t i = axis.index;
  if (mesh) return std::pair(mesh->low_m.at(i), mesh->high_m.at(i));
  std::pair<double, double> between{kInfinity, -kInfinity};
  for (const Place& p : probes) {
    between = {std::min(between.first, p.at(i)), std::max(between.second, p.at(i))};
  }
  if (between.second > between.first) return between;
  const std::pair<double, double> box{state.box_low_m.at(i), state.box_high_m.at(i)};
  return box.second > box.first ? std::optional(box) : std::nullopt;
}

std::optional<std::pair<double, double>> FlowChannel::reach_m() const {
  const std::size_t i = axis.index;
  std::pair<double, double> reach{state.box_low_m.at(i), state.box_high_m.at(i)};
  const bool box = reach.second > reach.first;
  if (mesh && box) {
    reach = {std::min(reach.first, mesh->low_m.at(i)), std::max(reach.second, mesh->high_m.at(i))};
  } else if (mesh) {
    reach = {mesh->low_m.at(i), mesh->high_m.at(i)};
  }
  return mesh || box ? std::optional(reach) : std::nullopt;
}

std::pair<double, double> FlowChannel::developed_m() const {
  const auto stretch = stretch_m();
  if (!stretch || state.periodic.at(axis.index)) return {-kInfinity, kInfinity};
  const double part_m = kDownstream * (stretch->second - stretch->first);
  if (axis.way > 0) return {stretch->second - part_m, kInfinity};
  return {-kInfinity, stretch->first + part_m};
}

FlowChannel look_at_channel(const std::filesystem::path& case_folder, DumpState state,
                            const std::optional<std::string>& axis, const std::string& set) {
  FlowChannel channel;
  channel.state = std::move(state);
  for (const std::string& name : pressure_probe_sets(case_folder)) {
    auto places = probe_places(case_folder, name);
    const bool wanted = set.empty() || set == name;
    if (wanted && places.size() > channel.probes.size()) channel.probes = std::move(places);
  }
  try {
    if (const auto box = foam_mesh_extent(case_folder)) {
      channel.mesh = Extent{box->low_m, box->high_m};
    }
  } catch (const InvalidInput&) {
    // Without OpenFOAM, or with a damaged mesh, the probes or the box tell.
  }
  channel.axis = axis ? flow_axis_of(*axis)
                      : choose_flow_axis(channel.probes, channel.mesh, channel.state.particles);
  return channel;
}

}  // namespace powderlink::analysis
