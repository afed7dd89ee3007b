// SPDX-License-Identifier: GPL-3.0-or-later
/// liggghts-powderlink: LIGGGHTS with all its options, and powderlink's styles. Whatever the library of
/// the styles does to a process by LD_PRELOAD (interposed.cpp, mpi_process.cpp) it does to this one.
#include <csignal>
#include <cstdio>
#include <cstring>

#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

#include "liggghts_styles/plugin/styles.h"

namespace {

// As LIGGGHTS's own program: the first Ctrl-C (or mpirun's SIGTERM) ends the run after the step.
void install_signal_handlers() {
  struct sigaction quit {};
  quit.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigaction(SIGINT, &quit, nullptr);
  sigaction(SIGTERM, &quit, nullptr);
  struct sigaction write_restart {};
  write_restart.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &write_restart, nullptr);
}

bool asks_for_help(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "-h") == 0 || std::strcmp(argv[i], "-help") == 0) return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  install_signal_handlers();
  MPI_Init(&argc, &argv);
  if (asks_for_help(argc, argv)) {
    // LIGGGHTS prints its help and exits inside its constructor, so ours goes first.
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      std::puts(powderlink::plugin::help());
      std::fflush(stdout);
    }
  }
  auto* lammps = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  lammps->input->file();
  delete lammps;
  MPI_Finalize();
  return 0;
}
