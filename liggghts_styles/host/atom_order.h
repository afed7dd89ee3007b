// SPDX-License-Identifier: GPL-3.0-or-later
/// \file atom_order.h
/// One order of the atoms of a rank, whatever the run did before: by tag, then in the spatial order
/// of LIGGGHTS when the script has it switched on (atom_modify sort). Sums over neighbours follow the
/// order of atoms: a run that goes on from a restart file has the sums of the run before to the last
/// bit only in the same order.
///
/// To be called between Comm::exchange() and Comm::borders(): there are no ghosts, and the map of tags
/// is made anew. O(n log n).
/// Tests: tests/liggghts_styles/couple_bridge_restart_test.cpp
#pragma once

#include "lammps.h"

namespace powderlink::host {

void set_atom_order(LAMMPS_NS::LAMMPS* lmp);

}  // namespace powderlink::host
