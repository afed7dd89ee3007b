// SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupled_world.h
/// What start, fix and end of the process tell each other: the start tells the fix that couples which
/// other program shares the mpirun; the fix tells the end that both have parted in order; and errors
/// find their way to the other program's log.
/// Tests: tests/liggghts_styles/couple_world_test.cpp, tests/liggghts_styles/script_loops_test.cpp
#pragma once

#include "coupling/bridge/transport/mpi_world.h"

namespace powderlink::host {

/// Of this process; before set_coupled_world() it holds no other program.
const bridge::MpiWorld& coupled_world();
void set_coupled_world(const bridge::MpiWorld& world);

/// The coupled run of this mpirun is over in order, for both programs: there can be no second one.
bool has_parted();
void note_parted();

/// Tells the other program, if this one is still coupled to it, why this one ends. On any rank.
void say_last_words(const std::string& why);

}  // namespace powderlink::host
