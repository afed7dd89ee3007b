// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/plugin/mpi_process.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <mpi.h>

#include "lammps.h"

#include "coupling/bridge/transport/mpi_world.h"
#include "coupling/bridge/transport/own_world.h"
#include "liggghts_styles/couple_bridge/coupled_world.h"
#include "liggghts_styles/host/last_error.h"

namespace powderlink::plugin {

namespace {

/// With another program that has not ended in order, as far as is known here.
bool shared_job() {
  return bridge::holds_other_program(host::coupled_world()) && !host::has_parted();
}

void say_error(const std::string& message) {
  host::keep_error(message);
  if (host::coupled_world().rank == 0) std::fprintf(stderr, "ERROR: %s\n", message.c_str());
}

/// The two programs pair their ranks as mpirun started them, all of them in one world.
void refuse_other_worlds(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool partitions = word == "-partition" || word == "-p";
    if (!partitions && word != "-reorder" && word != "-ro") continue;
    const std::string instead = partitions ? "start a coupled job for each partition"
                                           : "place the ranks by options of mpirun";
    std::string message = "LIGGGHTS and " + host::coupled_world().peer_role;
    message += " in one mpirun; given: " + word;
    message +=
        "; allowed: all ranks of LIGGGHTS in one world, in the order of mpirun; to do: remove it";
    say_error(message + " and " + instead);
    MPI_Barrier(MPI_COMM_WORLD);  // none may end the job before that is said
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
}

/// The other program of the job calls split_world_if_shared() at its start, too, unless it is none of
/// powderlink's.
void begin(int argc, char** argv) {
  constexpr double timeout_s = 60.0;
  // What was said last must not stay in a buffer when this process is ended from outside.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  try {
    host::set_coupled_world(bridge::split_world_if_shared("dem", timeout_s));
  } catch (const bridge::BridgeError& problem) {
    std::fprintf(stderr, "ERROR: %s\n", problem.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  bridge::take_as_world(host::coupled_world().local);
  if (shared_job()) refuse_other_worlds(argc, argv);
}

std::string reason() {
  return host::kept_error().empty() ? "LIGGGHTS: ended early; see its log" : host::kept_error();
}

}  // namespace

void end_by_quit(LAMMPS_NS::LAMMPS* lmp, int status) {
  delete lmp;
  MPI_Finalize();
  std::exit(status);
}

}  // namespace powderlink::plugin

namespace host = powderlink::host;
namespace plugin = powderlink::plugin;

extern "C" {

int MPI_Init(int* argc, char*** argv) {
  const int error = PMPI_Init(argc, argv);
  plugin::begin(argc == nullptr || argv == nullptr ? 0 : *argc, argv == nullptr ? nullptr : *argv);
  return error;
}

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  const int error = PMPI_Init_thread(argc, argv, required, provided);
  plugin::begin(argc == nullptr || argv == nullptr ? 0 : *argc, argv == nullptr ? nullptr : *argv);
  return error;
}

// LIGGGHTS ends on errors by MPI_Finalize, which waits for the other program of a coupled job. That one
// is told why; after an orderly end no link is open any more.
int MPI_Finalize() {
  host::say_last_words(plugin::reason());
  if (plugin::shared_job()) {
    if (host::kept_error().empty()) {
      plugin::say_error(
          "LIGGGHTS and " + host::coupled_world().peer_role +
          " in one mpirun; "
          "given: a script that ends without coupling; allowed: fix couple/bridge and a run; "
          "to do: add what is missing, or start the programs one by one");
    }
    MPI_Barrier(MPI_COMM_WORLD);  // none may end the job before that is said
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return PMPI_Finalize();
}

// One rank's error ends all at once: what it said must not stay in a buffer. And not by the library's
// own MPI_Abort: mpirun of Open MPI 4.1.4 chokes on its farewell now and then ("ORTE_ERROR_LOG ...
// show_help.c") and then crashes or leaves the other ranks alive. That a process is gone with a status
// is always noticed, and ends the job.
int MPI_Abort(MPI_Comm, int code) {
  std::fflush(nullptr);
  host::say_last_words(plugin::reason());
  std::_Exit(code == 0 ? 1 : code);
}

}  // extern "C"
