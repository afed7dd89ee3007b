// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpi_world.h
/// Two programs in one mpirun share MPI_COMM_WORLD; each needs one of its own, and a way to the other.
/// Tests: tests/coupling/bridge/mpi_test.cpp
#pragma once

#include <mpi.h>

#include <string>

#include "coupling/bridge/bridge_error.h"
#include "coupling/bridge/transport/deadline.h"

namespace powderlink::bridge {

struct MpiWorld {
  MPI_Comm local = MPI_COMM_NULL;  ///< the ranks of this program
  MPI_Comm inter = MPI_COMM_NULL;  ///< intercommunicator: its remote group is the other program
  std::string role;
  std::string peer_role;
  int rank = 0;
  int ranks = 1;
  int peer_ranks = 1;
};

/// Collective over MPI_COMM_WORLD: every rank of both programs calls it right after MPI_Init, with the
/// role of its program (at most 31 characters). The communicators live until MPI_Finalize. For a program
/// alone, with or without mpirun, `local` is MPI_COMM_WORLD and `inter` stays MPI_COMM_NULL.
/// Throws on all ranks bad_input when there are more than two roles, timeout when the other program
/// does not call it. Works in a program that maps MPI_COMM_WORLD to its own half.
MpiWorld split_world_if_shared(const std::string& role, double timeout_s);

inline bool holds_other_program(const MpiWorld& world) { return world.inter != MPI_COMM_NULL; }

/// Waits for a request, also of a nonblocking collective; throws deadline.error(waited_for).
void wait_for(MPI_Request& request, const Deadline& deadline, const std::string& waited_for);

/// Collective over `local`: shares the text of rank `root` with all; used by on_first_rank().
void share_outcome(MPI_Comm local, int root, bool& failed, BridgeError::Kind& kind,
                   std::string& text, double timeout_s);

/// Collective over `local`: runs `action` on rank 0; its BridgeError is thrown on every rank. For
/// sessions: the other ranks wait as long as rank 0 may, `timeout_s` is the limit for all.
template <class Action>
void on_first_rank(MPI_Comm local, double timeout_s, Action&& action) {
  int rank = 0;
  MPI_Comm_rank(local, &rank);
  bool failed = false;
  auto kind = BridgeError::Kind::bad_input;
  std::string text;
  if (rank == 0) {
    try {
      action();
    } catch (const BridgeError& e) {
      failed = true;
      kind = e.kind();
      text = e.what();
    }
  }
  share_outcome(local, 0, failed, kind, text, timeout_s);
  if (failed) throw BridgeError(kind, text);
}

}  // namespace powderlink::bridge
