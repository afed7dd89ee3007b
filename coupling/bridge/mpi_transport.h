// SPDX-License-Identifier: GPL-3.0-or-later
/// \file mpi_transport.h
/// Frames between one rank of each program of one mpirun.
///
/// Both ranks construct it with the other's rank in the remote group and the same tag. When a program
/// dies, mpirun ends both within seconds; what is noticed here are timeouts and an orderly close().
/// Large frames are sent from the caller's buffer without a copy. abort() ends all ranks of both
/// programs. Ping 1 us, 1 MB each way as checked frames 0.6 ms on one machine, see bench/bridge_bench.cpp.
#pragma once

#include <deque>
#include <string>

#include "coupling/bridge/mpi_mailbox.h"
#include "coupling/bridge/mpi_world.h"
#include "coupling/bridge/transport.h"

namespace powderlink::bridge {

class MpiTransport : public Transport {
 public:
  explicit MpiTransport(const MpiWorld& world, int peer_rank = 0, int tag = 100);
  ~MpiTransport() override;

  void send(Bytes& frame, const Deadline& deadline) override;
  void receive(Bytes& frame, const Deadline& deadline) override;
  const std::string& peer() const override { return peer_; }
  void close() noexcept override;
  void abort(const std::string& why) noexcept override;

 private:
  bool poll();

  MPI_Comm inter_;
  int peer_rank_;
  int tag_;
  std::string peer_;
  MpiMailbox mailbox_;
  std::deque<Bytes> ready_;  ///< came in while this side was sending
  Bytes spare_;
  bool closed_ = false;
  bool peer_closed_ = false;
};

}  // namespace powderlink::bridge
