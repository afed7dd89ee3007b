// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_exchange.h
/// Particles to the solver ranks that own their cells, and values for them back, many to many.
///
///   every DEM rank                              every solver rank
///   DemExchange::send(...)                -->   SolverExchange::receive()
///   DemExchange::receive(...)             <--   SolverExchange::send(...)
/// Each call is collective over the ranks of its program; the four make one round. DEM ranks may
/// compute between send and receive, but must keep number and order of their particles.
///
/// A solver rank sees its particles ordered by DEM rank, then by the order on that rank, on every
/// transport; so results do not depend on the transport. Only ranks that share particles exchange
/// messages (over MPI). Time and memory per rank: O(its particles * bytes per particle + ranks of the
/// other program); over a socket rank 0 of each program carries all particles. Buffers are kept, so
/// rounds of steady size allocate nothing here.
/// Errors: BridgeError timeout, mismatch (fields, step, count), bad_input (arguments), those of the
/// transport. The host then calls MPI_Abort, which ends all ranks.
/// Tests: tests/coupling/bridge/mpi_test.cpp
#pragma once

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "coupling/bridge/frame/field.h"
#include "coupling/bridge/transport/mpi_world.h"
#include "coupling/bridge/transport/session.h"

namespace powderlink::bridge {

/// The same on both sides; take it from what the handshake agreed on.
struct ExchangePlan {
  std::vector<FieldSpec> to_solver;
  std::vector<FieldSpec> to_dem;
  double timeout_s = 60.0;
};

/// Fields of one rank, all with the same number of rows.
struct ParticleTable {
  std::int64_t step = 0;
  double time_s = 0.0;
  std::size_t particles = 0;
  std::vector<Field> fields;

  explicit ParticleTable(const std::vector<FieldSpec>& specs) {
    for (const FieldSpec& spec : specs) fields.emplace_back(spec);
  }
  void resize(std::size_t rows) {
    particles = rows;
    for (Field& field : fields) field.resize(rows);
  }
};

class DemExchange {
 public:
  virtual ~DemExchange() = default;
  DemExchange(const DemExchange&) = delete;
  DemExchange& operator=(const DemExchange&) = delete;

  /// \param destination  solver rank of each particle; negative: nobody's, it is left out
  /// \param columns      in the order of ExchangePlan::to_solver, a row per particle
  virtual void send(std::int64_t step, double time_s, const std::vector<int>& destination,
                    const std::vector<ColumnView>& columns) = 0;
  /// \param columns  in the order of ExchangePlan::to_dem, a row per particle of the last send;
  ///                 rows of particles that were left out stay as they are
  virtual void receive(const std::vector<MutableColumnView>& columns) = 0;

 protected:
  DemExchange() = default;
};

class SolverExchange {
 public:
  virtual ~SolverExchange() = default;
  SolverExchange(const SolverExchange&) = delete;
  SolverExchange& operator=(const SolverExchange&) = delete;

  /// Fields of ExchangePlan::to_solver; valid until the next receive().
  virtual const ParticleTable& receive() = 0;
  /// \param columns  in the order of ExchangePlan::to_dem, a row per particle of the last receive()
  virtual void send(const std::vector<ColumnView>& columns) = 0;

 protected:
  SolverExchange() = default;
};

/// One mpirun. Collective over both programs.
std::unique_ptr<DemExchange> dem_exchange_over_mpi(const MpiWorld& world, ExchangePlan plan);
std::unique_ptr<SolverExchange> solver_exchange_over_mpi(const MpiWorld& world, ExchangePlan plan);

/// Any transport between rank 0 of both programs. Collective over `local`.
/// \param session  on rank 0, must outlive the exchange; null on the others
std::unique_ptr<DemExchange> dem_exchange_over_session(MPI_Comm local, Session* session,
                                                       ExchangePlan plan);
std::unique_ptr<SolverExchange> solver_exchange_over_session(MPI_Comm local, Session* session,
                                                             ExchangePlan plan);

}  // namespace powderlink::bridge
