// SPDX-License-Identifier: GPL-3.0-or-later
/// \file prepare.h
/// Makes a case continue from its last complete pair of checkpoints. Nothing is deleted:
///
///   later time folders    go to CASE/discarded/[processorN/] (a number is added when the name is
///                         taken), so that the pair's is the latest one
///   controlDict           gets `startFrom latestTime;`, in place of its own last entry or at its end,
///                         unless OpenFOAM sees that already; the rest of the file stays
///   post/restart.latest   becomes a link to the restart file; its name is the restart files' own
///                         beginning and `latest`
///
/// Doing it again changes nothing.
/// Tests: tests/analysis/flow/restart_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/flow/restart/checkpoints.h"

namespace powderlink::analysis {

/// Lines on what was done. Throws before any change when controlDict cannot be read or written.
std::vector<std::string> prepare_restart(const std::filesystem::path& case_folder,
                                         const Checkpoints& checkpoints);

}  // namespace powderlink::analysis
