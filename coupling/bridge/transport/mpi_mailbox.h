// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpi_mailbox.h
/// Frames from rank to rank on one communicator (also an intercommunicator) under one tag, each wait
/// with a deadline.
/// Tests: tests/coupling/bridge/mpi_test.cpp
#pragma once

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include "coupling/bridge/frame/bytes.h"
#include "coupling/bridge/transport/deadline.h"
#include "coupling/bridge/transport/mpi_world.h"

namespace powderlink::bridge {

class MpiMailbox {
 public:
  /// \param peers  for messages, e.g. "solver"
  MpiMailbox(MPI_Comm comm, int tag, std::string peers)
      : comm_(comm),
        tag_(tag),
        peers_(std::move(peers)),
        flushing_(peers_ + " to take a message"),
        letters_(std::make_unique<std::vector<Bytes>>()) {}
  /// Letters that were never fetched leave their buffers behind: MPI may still read them.
  ~MpiMailbox();
  MpiMailbox(const MpiMailbox&) = delete;
  MpiMailbox& operator=(const MpiMailbox&) = delete;

  /// A buffer to write a letter into; its capacity is that of a former letter.
  Bytes& letter();
  /// Starts to send the last letter(); the mailbox keeps it until flush().
  void post(int destination);
  /// Waits until all posted letters are fetched or on their way.
  void flush(const Deadline& deadline);
  /// True when a letter from that rank was there and has been read into `into`.
  bool poll(int source, Bytes& into);
  /// Waits for the next letter from that rank.
  void collect(int source, Bytes& into, const Deadline& deadline);

  std::string name_of(int rank) const { return "rank " + std::to_string(rank) + " of " + peers_; }

 private:
  MPI_Comm comm_;
  int tag_;
  std::string peers_;
  std::string flushing_;
  std::unique_ptr<std::vector<Bytes>> letters_;  ///< the first used_ are written or on their way
  std::size_t used_ = 0;
  std::vector<MPI_Request> requests_;
};

}  // namespace powderlink::bridge
