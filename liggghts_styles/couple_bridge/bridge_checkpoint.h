// SPDX-License-Identifier: GPL-3.0-or-later
/// \file bridge_checkpoint.h
/// What fix couple/bridge keeps in a restart file beside the values of each particle, so that a run
/// goes on as if it had not stopped.
///
/// Doubles: format, step, ahead_s, number of ranks, how many particles have vanished, how many numbers
/// were counted; the numbers of the former, the latter; then per rank a count and its numbers.
/// Tests: tests/liggghts_styles/couple_bridge_restart_test.cpp
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include <mpi.h>

#include "liggghts_styles/couple_bridge/leaving_particles.h"

namespace powderlink::host {

struct BridgeCheckpoint {
  std::int64_t step = -1;              ///< of the last checkpoint; -1: none
  double ahead_s = 0.0;                ///< LIGGGHTS's time minus the solver's
  std::vector<double> insertion;       ///< of this rank, insertion_state.h
  std::vector<double> counted;         ///< massflow_state.h; the same on all ranks
  std::vector<VanishedParticle> gone;  ///< whose rows that exchange had; the same on all ranks

  /// Collective; rank 0 writes to the file.
  void write(std::FILE* file, MPI_Comm world) const;
  /// \param state  as LIGGGHTS hands it to Fix::restart()
  /// With another number of ranks than before, `insertion` is empty.
  static BridgeCheckpoint read(const char* state, MPI_Comm world);
};

}  // namespace powderlink::host
