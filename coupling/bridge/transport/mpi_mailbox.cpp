// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/mpi_mailbox.h"

#include <limits>
#include <type_traits>

namespace powderlink::bridge {

MpiMailbox::~MpiMailbox() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (requests_.empty() || finalized) return;
  int done = 0;
  MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE);
  if (!done) static_cast<void>(letters_.release());
}

Bytes& MpiMailbox::letter() {
  if (used_ == letters_->size()) {
    // A growing vector moves its buffers' owners, not the bytes that MPI reads.
    static_assert(std::is_nothrow_move_constructible_v<Bytes>);
    letters_->emplace_back();
  }
  return (*letters_)[used_++];
}

void MpiMailbox::post(int destination) {
  Bytes& letter = (*letters_)[used_ - 1];
  if (letter.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw BridgeError(BridgeError::Kind::bad_input, "message to " + name_of(destination),
                      std::to_string(letter.size()) + " bytes", "less than 2 GiB",
                      "use more ranks, so that each one sends less");
  }
  requests_.push_back(MPI_REQUEST_NULL);
  MPI_Isend(letter.data(), static_cast<int>(letter.size()), MPI_BYTE, destination, tag_, comm_,
            &requests_.back());
}

void MpiMailbox::flush(const Deadline& deadline) {
  for (MPI_Request& request : requests_) {
    wait_for(request, deadline, flushing_);
  }
  requests_.clear();
  used_ = 0;
}

bool MpiMailbox::poll(int source, Bytes& into) {
  int there = 0;
  MPI_Message message = MPI_MESSAGE_NULL;
  MPI_Status status;
  MPI_Improbe(source, tag_, comm_, &there, &message, &status);
  if (!there) return false;
  int bytes = 0;
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  resize(into, static_cast<std::size_t>(bytes));
  MPI_Mrecv(into.data(), bytes, MPI_BYTE, &message, MPI_STATUS_IGNORE);
  return true;
}

void MpiMailbox::collect(int source, Bytes& into, const Deadline& deadline) {
  Backoff backoff;
  while (!poll(source, into)) {
    if (deadline.expired()) throw deadline.error("a message from " + name_of(source));
    backoff.pause();
  }
}

}  // namespace powderlink::bridge
