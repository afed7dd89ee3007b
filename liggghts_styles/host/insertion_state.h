// SPDX-License-Identifier: GPL-3.0-or-later
/// \file insertion_state.h
/// What decides which particles come next, as numbers of this rank: the random generators of
/// insertion fixes, particle distributions and templates, surface meshes and regions, and the parts
/// of the insertion volume that each rank has drawn for itself.
///
/// LIGGGHTS keeps of that in its restart files the seed of rank 0 only, and neither the generators of
/// meshes and regions nor the second number of a Gaussian pair: after a restart other particles come.
/// Tests: tests/liggghts_styles/couple_bridge_restart_test.cpp
#pragma once

#include <string>
#include <vector>

#include "lammps.h"

namespace powderlink::host {

/// Per fix or region: a mark of its name, how many numbers, the numbers.
std::vector<double> insertion_state(LAMMPS_NS::LAMMPS* lmp);

/// Puts back what insertion_state() gave. Returns the names of those that it does not hold, as
/// `fix ID, region ID`: they go on with what they have.
std::string set_insertion_state(LAMMPS_NS::LAMMPS* lmp, const std::vector<double>& state);

}  // namespace powderlink::host
