// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/flow_axis.h"

#include <algorithm>
#include <cmath>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kOneWay = 0.1;  // net momentum over the sum of its amounts

Place velocity_of(const DumpParticle& p) { return {p.vx_m_s, p.vy_m_s, p.vz_m_s}; }

std::optional<Extent> box_of(const std::vector<Place>& places) {
  if (places.size() < 2) return {};
  Extent box{places.front(), places.front()};
  for (const Place& p : places) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.low_m[i] = std::min(box.low_m[i], p[i]);
      box.high_m[i] = std::max(box.high_m[i], p[i]);
    }
  }
  return box;
}

/// The axis along which a box is clearly longest.
std::optional<std::size_t> long_axis(const std::optional<Extent>& box) {
  if (!box) return {};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return box->length_m(a) > box->length_m(b); });
  if (box->length_m(order[0]) < kClearlyLonger * box->length_m(order[1])) return {};
  return order[0];
}

}  // namespace

std::string FlowAxis::name() const { return (way < 0 ? "-" : "") + std::string(1, letter()); }

double FlowAxis::velocity_m_s(const DumpParticle& p) const {
  return static_cast<double>(way) * velocity_of(p).at(index);
}

FlowAxis flow_axis_of(const std::string& name) {
  const std::string letter = name.substr(name.find_first_not_of("+-") == 1 ? 1 : 0);
  const std::size_t index = std::string("xyz").find(letter);
  if (letter.size() != 1 || index == std::string::npos) {
    throw InvalidInput("option --axis", name, "x, y, z, -x, -y or -z",
                       "give the axis along which the powder flows, with - for the way against it");
  }
  return {index, name.front() == '-' ? -1 : 1};
}

FlowAxis choose_flow_axis(const std::vector<Place>& probes, const std::optional<Extent>& mesh,
                          const std::vector<DumpParticle>& particles) {
  Place net{}, amounts{};
  for (const DumpParticle& p : particles) {
    const Place v = velocity_of(p);
    for (std::size_t i = 0; i < 3; ++i) {
      net[i] += p.mass_kg * v[i];
      amounts[i] += p.mass_kg * std::abs(v[i]);
    }
  }
  FlowAxis axis;
  if (const auto along = long_axis(box_of(probes))) {
    axis.index = *along;
  } else if (const auto longest = long_axis(mesh)) {
    axis.index = *longest;
  } else {
    // Equal ones leave z.
    for (const std::size_t i : {1, 0}) {
      if (std::abs(net[i]) > std::abs(net[axis.index])) axis.index = i;
    }
  }
  const double along = net.at(axis.index);
  if (along < -kOneWay * amounts.at(axis.index)) axis.way = -1;
  return axis;
}

}  // namespace powderlink::analysis
