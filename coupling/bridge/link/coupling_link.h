// SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupling_link.h
/// A coupled job as its two hosts see it: who talks, in which order, until when. Bytes, frames and
/// ranks are the business of Transport, Session and the particle exchange underneath.
///
///   every DEM rank                                   every solver rank
///   DemLink(...)              handshake, rank map    SolverLink(..., map)
///   send_particles(...)       -------------------->  receive_particles(): false when DEM has finished
///   receive_values(...)       <--------------------  send_values(command, ...)
///   ...                                              ...
///   finish()                                         finish(), or Command::stop
/// All calls are collective over the ranks of the program. Errors: BridgeError on every rank of the
/// program, after the other program was told why; the host then prints it and calls MPI_Abort.
/// Tests: tests/coupling/bridge/link_test.cpp
#pragma once

#include <mpi.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupling/bridge/exchange/particle_exchange.h"
#include "coupling/bridge/transport/mpi_world.h"
#include "coupling/bridge/transport/session.h"
#include "coupling/bridge/transport/socket_transport.h"

namespace powderlink::bridge {

struct LinkOptions {
  enum class Route { mpi, socket };
  Route route = Route::mpi;
  MpiWorld world;        ///< of split_world_if_shared(); for Route::mpi
  SocketOptions socket;  ///< for Route::socket
  bool listens = false;  ///< socket: this side waits, the other one connects
  double timeout_s = 120.0;
};

/// Which solver rank owns which part of space: a uniform grid over the solver's mesh.
/// The rank of voxel (i, j, k) is rank[(k * voxels[1] + j) * voxels[0] + i]; -1: no cell there.
struct RankMap {
  std::array<double, 3> origin_m{};
  std::array<double, 3> spacing_m{1.0, 1.0, 1.0};
  std::array<std::int32_t, 3> voxels{0, 0, 0};
  std::vector<std::int32_t> rank;

  /// Rank to send a particle to; points outside go to the nearest voxel, voxels of nobody to rank 0.
  int rank_of(const double* position_m) const;
};

enum class Command : std::int32_t { go_on = 0, stop = 1 };

/// What the solver says with its values.
struct SolverWord {
  Command command = Command::go_on;
  bool checkpoint = false;  ///< the solver's state of the time of this exchange is on disk
  /// So it will be at the next exchange, as far as the solver can tell: time to put things in order.
  bool checkpoint_next = false;
};

/// For a program that is about to end without its links' knowledge: fail() of every link that is open.
void say_last_words(const std::string& why) noexcept;

class DemLink {
 public:
  /// \param local  ranks of this program
  /// \param hello  role, case_name, ranks, exchange_interval_s, offers = all fields this side can
  ///               send; needs = values this side cannot do without
  /// \param known  all values this side understands; a solver that offers others is refused
  DemLink(MPI_Comm local, const LinkOptions& options, Hello hello, std::vector<FieldSpec> known);
  ~DemLink();  ///< without finish() the solver is told that this side ended early

  /// What goes to the solver and what comes back, as agreed: order of the columns below.
  const ExchangePlan& plan() const;
  const RankMap& rank_map() const;
  const Hello& peer() const;

  void send_particles(std::int64_t step, double time_s, const std::vector<int>& destination,
                      const std::vector<ColumnView>& columns);
  /// When the command is stop, the columns are left as they are and the link is closed.
  SolverWord receive_values(const std::vector<MutableColumnView>& columns);
  /// The orderly end, at any time; nothing happens when the link is closed already.
  void finish();
  /// Tells the solver why this side ends and closes the link; returns within 1.5 s. All ranks may call
  /// it, or one: over MPI any is heard, over a socket the first.
  void fail(const std::string& why) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

class SolverLink {
 public:
  SolverLink(MPI_Comm local, const LinkOptions& options, Hello hello, const RankMap& map);
  ~SolverLink();

  const ExchangePlan& plan() const;
  const Hello& peer() const;

  /// False when the DEM has finished; particles() is then empty and the link is closed.
  bool receive_particles();
  const ParticleTable& particles() const;
  /// \param columns  in the order of plan().to_dem; with the command stop they are not sent and the
  ///                 link is closed
  void send_values(const SolverWord& word, const std::vector<ColumnView>& columns);
  /// The orderly end, at any time: waits for the next particles if there are none to answer, and
  /// answers stop. Nothing happens when the link is closed already.
  void finish();
  void fail(const std::string& why) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace powderlink::bridge
