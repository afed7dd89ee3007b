// SPDX-License-Identifier: GPL-3.0-or-later
/// \file checkpoints.h
/// Pairs of checkpoints of a coupled case: the solver's fields at a time T and LIGGGHTS's restart
/// file of the step with step dt = T, the moment of both.
///   fields   CASE/<T>/ or CASE/processor*/<T>/ with U, p, phi, alphaf, what uniform/couplingClock
///            names, and in every processor the same files; a file is whole when OpenFOAM's last line
///            closes it, a compressed one when it can be inflated to that line. uniform/couplingClock
///            itself must be there from the first time on that has it
///   restart  CASE/post/restart.<step>, or with another beginning (keyword checkpoint of the fix);
///            whole when it has this name (its writer renames it at the end), its head carries this
///            step, and the atoms of all ranks are there (liggghts_styles/host/restart_file.h)
/// Times of the case's folder beside processors count where they are newer than all of those: a run on
/// one rank has left the processors behind.
/// When the particles' clock is ahead of the fluid's (a bed that had settled before), the step is that
/// of T plus the difference, which powderFoam keeps in <T>/uniform/couplingClock.
/// T is read from <T>/uniform/time where that is given; the folder's name may be rounded. Times
/// agree when they differ by less than half a DEM step, or by the rounding of the name.
/// Tests: tests/analysis/flow/restart_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

struct FieldCheckpoint {
  std::string name;  ///< of the time folders
  double time_s = 0.0;
  double particles_ahead_s = 0.0;              ///< clock of the particles minus time_s
  double rounding_s = 0.0;                     ///< of time_s
  std::vector<std::filesystem::path> folders;  ///< one, or one per processor
  std::string missing;                         ///< why it is not complete; empty when it is
  bool decomposed = false;                     ///< the folders are those of the processors
  bool of_coupled_run = false;                 ///< a file says so
};

struct DemCheckpoint {
  long step = 0;
  std::filesystem::path file;
  std::string missing;
};

struct CheckpointPair {
  FieldCheckpoint fields;
  DemCheckpoint dem;
};

struct Checkpoints {
  double time_step_s = 0.0;             ///< of the DEM
  std::string dem_prefix;               ///< beginning of the restart files' names
  std::vector<FieldCheckpoint> fields;  ///< by time
  std::vector<DemCheckpoint> dem;       ///< by step
  std::optional<CheckpointPair> last;   ///< the latest complete pair

  /// What keeps each later checkpoint from being a pair, one line each, latest first.
  std::vector<std::string> refused() const;

  /// What a run with -parallel would start from when the pair is not that of the processors beside it;
  /// empty when there are none.
  std::string stale_processors() const;
};

inline constexpr const char* kUsualDemPrefix = "post/restart.";  ///< that of fix couple/bridge

/// Only reads. Throws when the case cannot be read or the time step is unknown.
/// \param dem_prefix  the word after `checkpoint` of fix couple/bridge, within the case's folder
Checkpoints find_checkpoints(const std::filesystem::path& case_folder,
                             std::optional<double> time_step_s,
                             const std::string& dem_prefix = kUsualDemPrefix);

/// As find_checkpoints, but throws when no pair is complete, with what is missing.
Checkpoints require_checkpoints(const std::filesystem::path& case_folder,
                                std::optional<double> time_step_s,
                                const std::string& dem_prefix = kUsualDemPrefix);

}  // namespace powderlink::analysis
