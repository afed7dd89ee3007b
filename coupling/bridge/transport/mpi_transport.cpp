// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/mpi_transport.h"

#include <limits>
#include <thread>
#include <utility>

namespace powderlink::bridge {

namespace {

constexpr int cry_tag = 99;
/// For the other program to read why this one ends, and then to print it.
constexpr double reading_s = 0.7;
constexpr double printing_s = 0.2;

void let_print() { std::this_thread::sleep_for(std::chrono::duration<double>(printing_s)); }

}  // namespace

MpiTransport::MpiTransport(const MpiWorld& world, int peer_rank, int tag)
    : inter_(world.inter),
      peer_rank_(peer_rank),
      tag_(tag),
      peer_("rank " + std::to_string(peer_rank) + " of " + world.peer_role),
      mailbox_(world.inter, tag, world.peer_role),
      cries_(world.inter, cry_tag, world.peer_role) {
  if (peer_rank < 0 || peer_rank >= world.peer_ranks) {
    throw BridgeError(BridgeError::Kind::bad_input, "rank of " + world.peer_role,
                      std::to_string(peer_rank), "0 to " + std::to_string(world.peer_ranks - 1),
                      "connect to a rank that runs");
  }
}

MpiTransport::~MpiTransport() { MpiTransport::close(); }

/// An empty message stands for the end of the connection; a frame never is empty.
bool MpiTransport::poll() {
  if (peer_closed_) return false;
  if (!mailbox_.poll(peer_rank_, spare_)) return poll_cries();
  if (spare_.empty()) {
    peer_closed_ = true;
  } else {
    ready_.push_back(std::move(spare_));
    spare_ = Bytes();
  }
  return true;
}

bool MpiTransport::poll_cries() {
  if (!cries_.poll(MPI_ANY_SOURCE, spare_)) return false;
  ready_.push_back(std::move(spare_));
  spare_ = Bytes();
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

void MpiTransport::close_after_error() noexcept {
  if (closed_) return;
  close();
  try {
    const Deadline deadline(reading_s);
    Backoff backoff;
    while (!peer_closed_) {  // its answer to what it has read
      if (deadline.expired()) break;
      if (!poll()) backoff.pause();
      ready_.clear();
    }
    let_print();
  } catch (const std::exception&) {  // this program ends in any case
  }
}

void MpiTransport::cry(const MpiWorld& world, const Bytes& frame, int peer_rank) noexcept {
  try {
    const auto* kept = new Bytes(frame);  // MPI may still read it at the end of the program
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(kept->data(), static_cast<int>(kept->size()), MPI_BYTE, peer_rank, cry_tag,
              world.inter, &request);
    const Deadline deadline(reading_s);
    Backoff backoff;
    for (int done = 0; !deadline.expired(); backoff.pause()) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    }
    let_print();
  } catch (const std::exception&) {  // this program ends in any case
  }
}

}  // namespace powderlink::bridge
