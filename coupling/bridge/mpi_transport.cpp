// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/mpi_transport.h"

#include <cstdio>
#include <limits>
#include <utility>

namespace powderlink::bridge {

MpiTransport::MpiTransport(const MpiWorld& world, int peer_rank, int tag)
    : inter_(world.inter),
      peer_rank_(peer_rank),
      tag_(tag),
      peer_("rank " + std::to_string(peer_rank) + " of " + world.peer_role),
      mailbox_(world.inter, tag, world.peer_role) {
  if (peer_rank < 0 || peer_rank >= world.peer_ranks) {
    throw BridgeError(BridgeError::Kind::bad_input, "rank of " + world.peer_role,
                      std::to_string(peer_rank), "0 to " + std::to_string(world.peer_ranks - 1),
                      "connect to a rank that runs");
  }
}

MpiTransport::~MpiTransport() { MpiTransport::close(); }

/// An empty message stands for the end of the connection; a frame never is empty.
bool MpiTransport::poll() {
  if (peer_closed_ || !mailbox_.poll(peer_rank_, spare_)) return false;
  if (spare_.empty()) {
    peer_closed_ = true;
  } else {
    ready_.push_back(std::move(spare_));
    spare_ = Bytes();
  }
  return true;
}

void MpiTransport::send(Bytes& frame, const Deadline& deadline) {
  poll();
  if (closed_ || peer_closed_) throw lost(peer_, "closed");
  if (frame.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw BridgeError(BridgeError::Kind::bad_input, "message to " + peer_,
                      std::to_string(frame.size()) + " bytes", "less than 2 GiB",
                      "use more ranks, so that each one sends less");
  }
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(frame.data(), static_cast<int>(frame.size()), MPI_BYTE, peer_rank_, tag_, inter_,
            &request);
  Backoff backoff;
  int done = 0;
  while (true) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return;
    // The other side may be sending, too: reading on is what lets it get to its own reading.
    if (poll()) continue;
    if (deadline.expired() || peer_closed_) {
      new Bytes(std::move(frame));  // MPI may still read it
      MPI_Request_free(&request);
      if (peer_closed_) throw lost(peer_, "closed");
      throw deadline.error(peer_ + " to take a message");
    }
    backoff.pause();
  }
}

void MpiTransport::receive(Bytes& frame, const Deadline& deadline) {
  Backoff backoff;
  if (closed_) throw lost(peer_, "closed");
  while (ready_.empty()) {
    if (peer_closed_) throw lost(peer_, "closed");
    if (poll()) continue;
    if (deadline.expired()) throw deadline.error("a frame from " + peer_);
    backoff.pause();
  }
  std::swap(frame, ready_.front());
  spare_ = std::move(ready_.front());
  ready_.pop_front();
}

void MpiTransport::close() noexcept {
  if (closed_) return;
  closed_ = true;
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized) return;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(nullptr, 0, MPI_BYTE, peer_rank_, tag_, inter_, &request);
  MPI_Request_free(&request);
}

void MpiTransport::abort(const std::string& why) noexcept {
  std::fprintf(stderr, "powderlink: %s\n", why.c_str());
  std::fflush(stderr);
  MPI_Abort(inter_, 1);
}

}  // namespace powderlink::bridge
