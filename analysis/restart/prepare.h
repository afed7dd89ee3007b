// SPDX-License-Identifier: GPL-3.0-or-later
/// \file prepare.h
/// Makes a case continue from its last complete pair of checkpoints. Nothing is deleted:
/// later time folders go to CASE/discarded/[processorN/] (a number is added when the name is taken),
/// so that the pair's is the latest one; controlDict gets `startFrom latestTime;` by a new file that
/// is renamed onto it; post/restart.latest (the restart files' own beginning and `latest`) becomes a
/// link to the restart file. Doing it again changes nothing.
/// Tests: tests/analysis/restart_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/restart/checkpoints.h"

namespace powderlink::analysis {

/// Lines on what was done. Throws when controlDict has no entry startFrom of its own.
std::vector<std::string> prepare_restart(const std::filesystem::path& case_folder,
                                         const Checkpoints& checkpoints);

}  // namespace powderlink::analysis
