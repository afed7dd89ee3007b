// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpi_transport.h
/// Frames between one rank of each program of one mpirun.
///
/// Both ranks construct it with the other's rank in the remote group and the same tag. When a program
/// dies, mpirun ends both within seconds; what is noticed here are timeouts and an orderly close().
/// Any rank of the other program may speak once, with cry(), before it ends the job.
/// Large frames are sent from the caller's buffer without a copy. Ping 1 us, 1 MB each way as
/// checked frames 0.6 ms on one machine, see bench/bridge_bench.cpp.
/// Tests: tests/coupling/bridge/mpi_test.cpp
#pragma once

#include <deque>
#include <string>

#include "coupling/bridge/transport/mpi_mailbox.h"
#include "coupling/bridge/transport/mpi_world.h"
#include "coupling/bridge/transport/transport.h"

namespace powderlink::bridge {

class MpiTransport : public Transport {
 public:
  explicit MpiTransport(const MpiWorld& world, int peer_rank = 0, int tag = 100);
  ~MpiTransport() override;

  void send(Bytes& frame, const Deadline& deadline) override;
  void receive(Bytes& frame, const Deadline& deadline) override;
  const std::string& peer() const override { return peer_; }
  void close() noexcept override;
  void close_after_error() noexcept override;

  /// The frame that a rank without a transport sends to those of `peer_rank`, which receive it as one
  /// of theirs; waits as close_after_error() does.
  static void cry(const MpiWorld& world, const Bytes& frame, int peer_rank = 0) noexcept;

 private:
  bool poll();
  bool poll_cries();

  MPI_Comm inter_;
  int peer_rank_;
  int tag_;
  std::string peer_;
  MpiMailbox mailbox_;
  MpiMailbox cries_;
  std::deque<Bytes> ready_;  ///< came in while this side was sending
  Bytes spare_;
  bool closed_ = false;
  bool peer_closed_ = false;
};

}  // namespace powderlink::bridge
