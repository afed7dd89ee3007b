// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpi_process.h
/// Beginning and end of the particles' program, in the launcher and in the stock program with LD_PRELOAD.
/// mpi_process.cpp defines MPI_Init(), MPI_Finalize() and MPI_Abort(), which the dynamic linker finds
/// before those of the MPI library.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace powderlink::plugin {

/// Command `quit`, of all ranks: the orderly end, as of a script without it, with a status of the script's
/// choice. A coupled run is finished.
[[noreturn]] void end_by_quit(LAMMPS_NS::LAMMPS* lmp, int status);

}  // namespace powderlink::plugin
