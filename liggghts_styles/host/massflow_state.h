// SPDX-License-Identifier: GPL-3.0-or-later
/// \file massflow_state.h
/// What fix massflow/mesh has counted, and its restart file forgets: the number of particles, the sum of
/// the property, and the interval of its rates, which also every look at them changes. Mass and what was
/// deleted it keeps by itself; the side of the mesh on which a particle is, is a property of the particle.
/// Tests: tests/liggghts_styles/couple_bridge_restart_test.cpp
#pragma once

#include <vector>

#include "lammps.h"

namespace powderlink::host {

/// Per fix: a mark of its ID, then its numbers. The same on all ranks.
std::vector<double> massflow_state(LAMMPS_NS::LAMMPS* lmp);

/// Puts back what massflow_state() gave to the fixes that are still there.
void set_massflow_state(LAMMPS_NS::LAMMPS* lmp, const std::vector<double>& state);

}  // namespace powderlink::host
