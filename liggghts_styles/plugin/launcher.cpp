// SPDX-License-Identifier: GPL-3.0-or-later
/// liggghts-powderlink: LIGGGHTS with all its options, and powderlink's styles. In one mpirun with
/// another powderlink program (a coupled job) LIGGGHTS gets the ranks of this one only.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

#include "coupling/bridge/mpi_world.h"
#include "host/coupled_world.h"
#include "plugin/liggghts_errors.h"
#include "plugin/styles.h"

namespace {

bool shared_job = false;  // with another program that has not ended in order, as far as known here

/// The other program of the job calls this at its start, too, unless it is none of powderlink's.
MPI_Comm own_ranks() {
  constexpr double timeout_s = 60.0;
  try {
    const auto world = powderlink::bridge::split_world_if_shared("dem", timeout_s);
    powderlink::host::set_coupled_world(world);
    shared_job = powderlink::bridge::holds_other_program(world);
    return world.local;
  } catch (const powderlink::bridge::BridgeError& problem) {
    std::fprintf(stderr, "ERROR: %s\n", problem.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    return MPI_COMM_NULL;
  }
}

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

// LIGGGHTS ends on errors by MPI_Finalize, which waits for the other program of a coupled job. That one
// is told why; after an orderly end no link is open any more.
extern "C" int MPI_Finalize() {
  powderlink::host::say_last_words(powderlink::plugin::last_liggghts_error());
  if (shared_job) {
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return PMPI_Finalize();
}

// One rank's error ends all at once: what it said must not stay in a buffer. And not by the library's
// own MPI_Abort: mpirun of Open MPI 4.1.4 chokes on its farewell now and then ("ORTE_ERROR_LOG ...
// show_help.c") and then crashes or leaves the other ranks alive. That a process is gone with a status
// is always noticed, and ends the job.
extern "C" int MPI_Abort(MPI_Comm, int code) {
  std::fflush(nullptr);
  powderlink::host::say_last_words(powderlink::plugin::last_liggghts_error());
  std::_Exit(code == 0 ? 1 : code);
}

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
  auto* lammps = new LAMMPS_NS::LAMMPS(argc, argv, own_ranks());
  powderlink::plugin::register_styles(lammps);
  lammps->input->file();
  delete lammps;
  const auto& world = powderlink::host::coupled_world();
  if (shared_job && !powderlink::host::has_met_other_program()) {
    if (world.rank == 0) {
      std::fprintf(
          stderr,
          "ERROR: LIGGGHTS and %s in one mpirun; given: a script that ends without coupling; "
          "allowed: fix couple/bridge and a run; to do: add what is missing, or start the "
          "programs one by one\n",
          world.peer_role.c_str());
    }
    MPI_Barrier(world.local);  // none may end the job before that is said
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  shared_job = false;
  MPI_Finalize();
  return 0;
}
