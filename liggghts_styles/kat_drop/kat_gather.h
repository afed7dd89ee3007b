// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_gather.h
/// The grains of all ranks in one place. Tests: tests/liggghts_styles/kat_drop/gather_program.cpp
#pragma once

#include <vector>

#include <mpi.h>

#include "liggghts_styles/kat_drop/kat_results.h"

namespace powderlink::host {

/// All grains on rank 0, ordered by id; empty on the others.
std::vector<KatGrainResult> gather(const std::vector<KatGrainResult>& mine, MPI_Comm world);

}  // namespace powderlink::host
