// SPDX-License-Identifier: GPL-3.0-or-later
/// \file solver_log.h
/// What the solver's log tells about cost: wall clock per simulated time, share of the coupling.
/// Read are log.powderFoam and log.mpirun of a case, whichever was written last:
///   Time = T            ExecutionTime = X s  ClockTime = Y s            coupling share: Z %
/// ClockTime counts whole seconds; where less than kShort_s of them are at hand the processor time
/// is taken instead (an MPI rank that waits is busy, so the two differ little).
/// Tests: tests/analysis/flow_case_test.cpp
#pragma once

#include <filesystem>
#include <optional>

namespace powderlink::analysis {

struct SolverCost {
  std::optional<double> wall_s_per_simulated_ms;
  std::optional<double> coupling_share_percent;  ///< the last that the log gives
  bool by_processor_time = false;
};

/// Nothing in it when there is no log. \param from_s  simulated time before which is not counted
SolverCost read_solver_cost(const std::filesystem::path& case_folder, double from_s);

}  // namespace powderlink::analysis
