// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_observable.h
/// What a measured quantity of a flow is made of: it sees the established states one after the other
/// and says at the end what it found. Each stands in a file of its own and in one line of
/// flow_observables.cpp.
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/flow/run/flow_statistics.h"
#include "analysis/flow/run/particle_clock.h"
#include "analysis/flow/run/pressure_profile.h"

namespace powderlink::analysis {

/// One entry of the JSON; with an interval (95 %) it is {"value", "low", "high"}.
struct FlowNumber {
  std::string key;
  std::optional<double> value;
  std::optional<Interval> interval = {};
};

/// NAME.csv drawn by scripts/plots/flow_NAME.gp as NAME.svg.
struct FlowFigure {
  std::string name;
  std::string definitions;  ///< for gnuplot, beside those that all figures have
  std::string why_not;      ///< why there is nothing to show; empty when there is
};

struct FlowFindings {
  std::vector<FlowNumber> numbers;
  std::vector<std::pair<std::string, std::string>> tables;  ///< file name, content
  std::vector<FlowFigure> figures;
  std::vector<std::string> notes;
  std::string text;  ///< for the terminal
};

/// Limits that the user may set.
struct FlowMeasures {
  double average_s = 2e-3;         ///< window of averages of the solids flow
  double cluster_threshold = 1.5;  ///< number per length over its mean
  double cluster_length_m = 2e-3;  ///< shortest cluster
};

/// What is known of the run when the states have been read.
struct FlowScene {
  std::filesystem::path folder;
  const FlowStatistics* particles = nullptr;
  FlowMeasures measures;
  std::optional<Interval> reach_m;             ///< of the channel along the axis
  std::optional<Interval> mesh_m;              ///< of the mesh alone
  std::optional<Interval> flow_slice_m;        ///< that the solids flow is taken through
  std::optional<double> irregularity_percent;  ///< of that flow
  std::optional<double> gas_density_kg_m3;
  const PressureProfile* pressure = nullptr;
  ParticleClock* clock = nullptr;

  const FlowWindow& window() const { return particles->window(); }
};

/// Where the section's middle is, and how far the channel reaches along the axis.
struct FlowChannelShape {
  Place centre_m{};
  std::optional<double> radius_m;  ///< half of the larger side; empty without a mesh
  std::optional<Interval> reach_m;
};

class FlowObservable {
 public:
  FlowObservable() = default;
  FlowObservable(const FlowObservable&) = delete;
  FlowObservable& operator=(const FlowObservable&) = delete;
  virtual ~FlowObservable() = default;

  /// Before the first state.
  virtual void begin(const std::filesystem::path& /*case_folder*/) {}
  /// An established state; times increase.
  virtual void add(double /*time_s*/, const DumpState& /*state*/) {}
  virtual FlowFindings find(const FlowScene& scene) = 0;
};

using FlowObservables = std::vector<std::unique_ptr<FlowObservable>>;

/// One of each that is registered.
FlowObservables make_flow_observables(const FlowWindow& window, const FlowChannelShape& shape);

}  // namespace powderlink::analysis
