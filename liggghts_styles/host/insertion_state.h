// SPDX-License-Identifier: GPL-3.0-or-later
/// \file insertion_state.h
/// What decides which particles come next, as numbers of this rank: the random generators of
/// insertion fixes, particle distributions and templates, surface meshes and regions, and the parts
/// of the insertion volume that each rank has drawn for itself.
///
/// LIGGGHTS keeps of that in its restart files the seed of rank 0 only, and neither the generators of
/// meshes and regions nor the second number of a Gaussian pair: after a restart other particles come.
#pragma once

#include <vector>

#include "lammps.h"

namespace powderlink::host {

/// In an order that depends on the script alone.
std::vector<double> insertion_state(LAMMPS_NS::LAMMPS* lmp);

/// Puts back what insertion_state() gave. False, and nothing is changed, when the script has other
/// generators now.
bool set_insertion_state(LAMMPS_NS::LAMMPS* lmp, const std::vector<double>& state);

}  // namespace powderlink::host
