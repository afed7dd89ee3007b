// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/mpi_world.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <vector>

namespace powderlink::bridge {

namespace {

using RoleText = std::array<char, 32>;

std::string list_of(const std::set<std::string>& roles) {
  std::string text;
  for (const std::string& role : roles) text += (text.empty() ? "" : ", ") + role;
  return text;
}

BridgeError not_two_roles(const std::set<std::string>& roles) {
  return {BridgeError::Kind::bad_input, "programs in this mpirun", list_of(roles),
          "at most two roles, e.g. dem and solver",
          "start both in one mpirun, separated by ' : ', or couple them by a socket"};
}

}  // namespace

void wait_for(MPI_Request& request, const Deadline& deadline, const std::string& waited_for) {
  Backoff backoff;
  int done = 0;
  while (true) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return;
    if (deadline.expired()) throw deadline.error(waited_for);
    backoff.pause();
  }
}

// A solver built on a library that uses MPI_COMM_WORLD replaces the MPI_ functions that take it; the
// PMPI_ ones still see both programs.
MpiWorld split_world_if_shared(const std::string& role, double timeout_s) {
  RoleText mine{};
  if (role.empty() || role.size() >= mine.size()) {
    throw BridgeError(BridgeError::Kind::bad_input, "role of this program", "'" + role + "'",
                      "1 to 31 characters", "call it dem or solver");
  }
  std::memcpy(mine.data(), role.data(), role.size());
  int rank = 0;
  int size = 1;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &size);

  // Kept for good: after a timeout MPI may still write into it.
  auto* all = new std::vector<RoleText>(static_cast<std::size_t>(size));
  auto* sent = new RoleText(mine);
  constexpr int text_bytes = static_cast<int>(sizeof(RoleText));
  MPI_Request request = MPI_REQUEST_NULL;
  PMPI_Iallgather(sent->data(), text_bytes, MPI_BYTE, all->data(), text_bytes, MPI_BYTE,
                  MPI_COMM_WORLD, &request);
  wait_for(request, Deadline(timeout_s), "the other program in this mpirun");
  std::set<std::string> roles;
  MpiWorld world;
  int peer_first = -1;
  for (int i = 0; i < size; ++i) {
    const std::string text((*all)[static_cast<std::size_t>(i)].data());
    roles.insert(text);
    if (text != role && peer_first < 0) {
      peer_first = i;
      world.peer_role = text;
    }
  }
  delete all;
  delete sent;
  if (roles.size() > 2) throw not_two_roles(roles);
  world.role = role;
  if (roles.size() == 1) {
    world.local = MPI_COMM_WORLD;
    world.rank = rank;
    world.ranks = size;
    world.peer_ranks = 0;
    return world;
  }
  MPI_Comm both = MPI_COMM_NULL;
  PMPI_Comm_dup(MPI_COMM_WORLD, &both);
  PMPI_Comm_split(both, role < world.peer_role ? 0 : 1, rank, &world.local);
  constexpr int tag = 1;
  PMPI_Intercomm_create(world.local, 0, both, peer_first, tag, &world.inter);
  PMPI_Comm_free(&both);
  PMPI_Comm_rank(world.local, &world.rank);
  PMPI_Comm_size(world.local, &world.ranks);
  PMPI_Comm_remote_size(world.inter, &world.peer_ranks);
  return world;
}

void share_outcome(MPI_Comm local, int root, bool& failed, BridgeError::Kind& kind,
                   std::string& text, double timeout_s) {
  struct Outcome {
    int failed;
    int kind;
    char text[4096];
  };
  auto* outcome = new Outcome{};  // on the heap: after a timeout MPI may still write into it
  outcome->failed = failed ? 1 : 0;
  outcome->kind = static_cast<int>(kind);
  text.copy(outcome->text, sizeof outcome->text - 1);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(outcome, static_cast<int>(sizeof(Outcome)), MPI_BYTE, root, local, &request);
  // That rank needs up to its own timeout; a little more lets its message win over this one.
  wait_for(request, Deadline(1.1 * timeout_s + 1.0),
           "rank " + std::to_string(root) + " of this program");
  failed = outcome->failed != 0;
  kind = static_cast<BridgeError::Kind>(outcome->kind);
  text = outcome->text;
  delete outcome;
}

}  // namespace powderlink::bridge
