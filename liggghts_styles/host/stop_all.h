// SPDX-License-Identifier: GPL-3.0-or-later
/// \file stop_all.h
/// Ends the run on all ranks with one message, exit status 1.
///
/// LIGGGHTS's own Error::all() and Error::fix_error() append text that they have freed before (3.8.0,
/// error.cpp); this prints the same line without it.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include <mpi.h>

#include "fix.h"
#include "lammps.h"

#include "liggghts_styles/host/last_error.h"

namespace powderlink::host {

/// To be called by all ranks. \param file, line where: LIGGGHTS's FLERR
[[noreturn]] inline void stop_all(LAMMPS_NS::LAMMPS* lmp, const char* file, int line,
                                  const LAMMPS_NS::Fix* fix, const std::string& message) {
  const std::string who =
      fix == nullptr ? std::string() : std::string("Fix ") + fix->style + " (id " + fix->id + "): ";
  keep_error("LIGGGHTS: " + who + message);
  MPI_Barrier(lmp->world);
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  if (rank == 0) {
    for (std::FILE* out : {lmp->screen, lmp->logfile}) {
      if (out == nullptr) continue;
      std::fprintf(out, "ERROR: %s%s (%s:%d)\n", who.c_str(), message.c_str(), file, line);
      std::fflush(out);
    }
  }
  int ours = 0, all = 0;
  MPI_Comm_size(lmp->world, &ours);
  MPI_Comm_size(MPI_COMM_WORLD, &all);
  if (all > ours) MPI_Abort(MPI_COMM_WORLD, 1);  // other partitions of LIGGGHTS must stop too
  MPI_Finalize();
  std::exit(1);
}

}  // namespace powderlink::host
