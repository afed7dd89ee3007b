// SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupled_world.h
/// How the launcher tells the fix that couples which other program shares the mpirun, and the fix
/// the launcher that it has met it; and the way to the other program's log for the launcher's errors.
#pragma once

#include "coupling/bridge/mpi_world.h"

namespace powderlink::host {

/// Of this process; without set_coupled_world() (LD_PRELOAD) it holds no other program.
const bridge::MpiWorld& coupled_world();
void set_coupled_world(const bridge::MpiWorld& world);

/// A fix has met the other program.
bool has_met_other_program();
void note_other_program_met();

/// Tells the other program, if this one is still coupled to it, why this one ends. On any rank.
void say_last_words(const std::string& why);

}  // namespace powderlink::host
