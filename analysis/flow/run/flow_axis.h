// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_axis.h
/// The axis along which a channel is measured, and the way that counts as forward.
///   place s = x, y or z; velocity and flow count along the way: positive downstream
/// The other two axes keep their order: the first is `across`, the second `up` (for z: x and y).
/// Chosen where the user does not: the axis along which the probes of p lie; else that of a mesh
/// which is kClearlyLonger times as long along it as along the next; else that of the particles'
/// momentum; else z. The way is that of the particles' momentum, unless it is the small remainder of
/// motion both ways; then it is forward.
/// Tests: tests/analysis/flow/flow_axis_test.cpp
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow/run/particle_dump.h"

namespace powderlink::analysis {

using Place = std::array<double, 3>;

struct FlowAxis {
  std::size_t index = 2;
  int way = 1;  ///< 1 along the axis, -1 against it

  std::string name() const;  ///< "z", "-x"
  char letter() const { return "xyz"[index]; }
  std::size_t across() const { return index == 0 ? 1 : 0; }
  std::size_t up() const { return index == 2 ? 1 : 2; }

  double place_m(const Place& p) const { return p.at(index); }
  double velocity_m_s(const DumpParticle& p) const;  ///< positive downstream
};

inline constexpr double kClearlyLonger = 2.0;

inline Place place_of(const DumpParticle& p) { return {p.x_m, p.y_m, p.z_m}; }

/// x, y, z, +x, -x, ...; throws for others.
FlowAxis flow_axis_of(const std::string& name);

/// Box around a channel.
struct Extent {
  Place low_m{}, high_m{};
  double length_m(std::size_t axis) const { return high_m.at(axis) - low_m.at(axis); }
};

/// \param probes     places of the probes of one set
/// \param mesh       box of the mesh
/// \param particles  one established state
FlowAxis choose_flow_axis(const std::vector<Place>& probes, const std::optional<Extent>& mesh,
                          const std::vector<DumpParticle>& particles);

}  // namespace powderlink::analysis
