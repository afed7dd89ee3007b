// SPDX-License-Identifier: GPL-3.0-or-later
/// \file own_world.h
/// A program in an mpirun that it shares with another one: every library in it that takes MPI_COMM_WORLD
/// for the program's own ranks (LIGGGHTS, VTK, OpenFOAM's Pstream) shall get just these.
///
/// own_world.cpp defines the MPI functions of own_world.def. It belongs into the program itself, or into
/// a library that the dynamic linker searches before the MPI library (LD_PRELOAD, or linked earlier):
/// then its definitions are the ones that all libraries of the process call, and they hand over to
/// PMPI_, which is where both programs are still seen.
/// Tests: tests/liggghts_styles/couple_world_test.cpp
#pragma once

#include <mpi.h>

namespace powderlink::bridge {

/// From now on MPI_COMM_WORLD is `local` in every call. Without it all calls pass unchanged.
void take_as_world(MPI_Comm local);

}  // namespace powderlink::bridge
