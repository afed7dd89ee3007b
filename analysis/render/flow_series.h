// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_series.h
/// A coupled run for ParaView: CASE/particles.pvd, its states in CASE/vtk/, and CASE/case.foam,
/// all at the times of the gas (analysis/flow/run/particle_clock.h), so that they play as one series. What
/// LIGGGHTS did before the first exchange has negative times.
/// Tests: tests/analysis/render/flow_test.cpp
#pragma once

#include <filesystem>
#include <optional>

#include "analysis/render/series.h"

namespace powderlink::render {

struct FlowSeriesFiles {
  std::filesystem::path particles_pvd, foam;
  std::size_t states = 0;
};

FlowSeriesFiles write_flow_series(const std::filesystem::path& case_folder,
                                  std::optional<double> time_step_s, const Progress& progress = {});

}  // namespace powderlink::render
