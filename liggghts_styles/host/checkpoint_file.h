// SPDX-License-Identifier: GPL-3.0-or-later
/// \file checkpoint_file.h
/// A LIGGGHTS restart file that is either whole or not there.
///
/// LIGGGHTS writes without looking whether the disk took it. So the file is written beside its name,
/// its end is read back (the blocks of all ranks with their lengths are the last part of the format),
/// and only then it gets its name; what was there before stays until that moment.
/// Tests: tests/liggghts_styles/couple_bridge_restart_test.cpp
#pragma once

#include <string>

#include "lammps.h"

namespace powderlink::host {

/// Collective. Makes the folder of the file, if it is missing.
/// Returns an empty text, or on all ranks what went wrong, in four parts.
std::string write_checkpoint(LAMMPS_NS::LAMMPS* lmp, const std::string& file);

/// Collective: atoms to the ranks and into the box they belong to, as LIGGGHTS does before it writes a
/// restart file, in the order of atom_order.h, and new neighbour lists. Between two rebuilds atoms may
/// stand outside of the box, and a restart file with such atoms cannot be read.
void bring_atoms_home(LAMMPS_NS::LAMMPS* lmp);

}  // namespace powderlink::host
