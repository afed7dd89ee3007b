// SPDX-License-Identifier: GPL-3.0-or-later
/// \file dem_time_step.h
/// The DEM time step of a coupled case [s]: what LIGGGHTS's log says (it repeats `timestep` with
/// its variables put in), else the only number after `timestep` in the scripts in.*.
/// Tests: tests/analysis/flow/flow_case_test.cpp
#pragma once

#include <filesystem>
#include <optional>

namespace powderlink::analysis {

/// \param given_s  the user's option, wins when there; must be positive
/// Throws when no time step is found, or more than one.
double dem_time_step_s(const std::filesystem::path& case_folder, std::optional<double> given_s);

}  // namespace powderlink::analysis
