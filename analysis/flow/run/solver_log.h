// SPDX-License-Identifier: GPL-3.0-or-later
/// \file solver_log.h
/// What the solver's log tells about cost: wall clock per simulated time, share of the coupling.
///   Time = T            ExecutionTime = X s  ClockTime = Y s            coupling share: Z %
/// A log is known by what is in it, not by its name: among the files of the case's folder the newest
/// whose beginning has OpenFOAM's `Exec : ...powderFoam...`; else the newest log.powderFoam or
/// log.mpirun. The other program's lines may stand between, and mpirun's marks of ranks before them.
/// ClockTime counts whole seconds; where less than kShort_s of them are at hand the processor time
/// is taken instead (an MPI rank that waits is busy, so the two differ little).
/// Tests: tests/analysis/flow/solver_log_test.cpp, tests/analysis/flow/flow_case_test.cpp
#pragma once

#include <filesystem>
#include <optional>

namespace powderlink::analysis {

struct SolverCost {
  std::filesystem::path log;  ///< that was read; empty when there is none
  std::optional<double> wall_s_per_simulated_ms;
  std::optional<double> coupling_share_percent;  ///< the last that the log gives
  bool by_processor_time = false;
};

/// Empty when the folder has none.
std::filesystem::path find_solver_log(const std::filesystem::path& case_folder);

/// Nothing in it when there is no log.
/// \param from_s  simulated time before which is not counted
/// \param given   the user's choice; must be a file
SolverCost read_solver_cost(const std::filesystem::path& case_folder, double from_s,
                            const std::optional<std::filesystem::path>& given = {});

}  // namespace powderlink::analysis
