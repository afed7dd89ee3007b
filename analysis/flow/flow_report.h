// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_report.h
/// Everything that `powderlink flow` finds in a coupled case, and its files.
/// Tests: tests/analysis/flow/flow_case_test.cpp, tests/analysis/program/flow_command_test.cpp
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/flow/observables/flow_observable.h"
#include "analysis/flow/observables/moving_average.h"
#include "analysis/flow/run/flow_statistics.h"
#include "analysis/flow/run/pressure_profile.h"
#include "analysis/flow/run/solver_log.h"

namespace powderlink::analysis {

struct FlowOptions {
  double from_s = 0.0;                 ///< established from here on
  std::optional<std::string> axis;     ///< x, -x, ...; default: flow_channel.h
  std::optional<double> from_m, to_m;  ///< places on the axis; default: flow_channel.h
  std::optional<double>
      slice_m;            ///< thickness of the slices; default: 1 mm, or less where it is short
  FlowMeasures measures;  ///< windows and limits of what is measured
  std::optional<Interval> flow_slice_m;  ///< of the solids flow
  std::optional<double> time_step_s;     ///< of the DEM
  std::optional<double> density_kg_m3;   ///< of the gas
  std::string probes;  ///< set of probes; empty: the one with the most in the window
  std::optional<std::filesystem::path> log;  ///< of powderFoam
};

struct FlowReport {
  FlowReport(const FlowOptions& options, const FlowWindow& window)
      : options(options), particles(window) {}
  const FlowWindow& window() const { return particles.window(); }

  FlowOptions options;
  FlowStatistics particles;
  std::optional<Interval> slice_m;
  std::vector<double> times_s, flow_kg_s;  ///< established states
  std::vector<std::optional<double>> average_kg_s;
  std::optional<double> mean_flow_kg_s;
  std::optional<Irregularity> irregularity;
  std::optional<double> gas_density_kg_m3;
  std::optional<PressureProfile> pressure;
  std::optional<PressureSlope> slope;
  SolverCost cost;
  std::vector<FlowFindings> findings;  ///< of flow_observables.h, in its order
  std::vector<std::string> notes;      ///< what is missing and why
};

using FlowProgress = std::function<void(std::size_t done, std::size_t all)>;

/// The case itself, or its results/case where foam_cases/*/run.sh leave what they ran.
std::filesystem::path find_coupled_case(const std::filesystem::path& folder);

/// When no particle is ever in the part of the channel that counts by default, all of it does.
/// Throws for damaged files and for a case with neither particles nor pressure.
FlowReport analyse_flow(const std::filesystem::path& case_folder, const FlowOptions& options,
                        const FlowProgress& progress = {});

/// Nine numbers, then those of the observables; null for what is missing.
std::string flow_json(const FlowReport& report);

/// File name and content (columns are named by the axes, here z, x, y): pressure, solids_flow, height,
/// velocity, width, concentration, and those of the observables.
std::vector<std::pair<std::string, std::string>> flow_tables(const FlowReport& report);

}  // namespace powderlink::analysis
