// SPDX-License-Identifier: GPL-3.0-or-later
// bridge_mpi_program ROLE TASK [FOLDER]: one of the two programs of an mpirun; mpi_test.cpp starts it.
#include <mpi.h>
#include <signal.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <thread>

#include "coupling/bridge/exchange/particle_exchange.h"
#include "coupling/bridge/transport/mpi_transport.h"
#include "coupling/bridge/transport/session.h"
#include "coupling/bridge/transport/socket_transport.h"
#include "tests/coupling/bridge/conformance.h"
#include "tests/coupling/bridge/fails.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Counts what our own code allocates; MPI's inner buffers do not come through here. Not inlined: GCC
// takes half of an inlined pair for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace powderlink::test {
namespace {

using bridge::BridgeError;
using bridge::ColumnView;
using bridge::FieldSpec;
using bridge::MpiWorld;
using bridge::ParticleTable;
using Kind = BridgeError::Kind;

constexpr double timeout_s = 10.0;

bool is_dem(const MpiWorld& world) { return world.role == "dem"; }

/// The suite between rank 0 of both programs; the other ranks have nothing to do.
int conformance(const MpiWorld& world) {
  if (world.rank != 0) return 0;
  int wrong = 0;
  int tag = 1000;
  for (const ConformanceCase& test : conformance_cases()) {
    std::string failure;
    try {
      (is_dem(world) ? test.first
                     : test.second)(std::make_unique<bridge::MpiTransport>(world, 0, tag++));
    } catch (const std::exception& e) {
      failure = e.what();
    }
    std::printf("%s %s: %s\n", world.role.c_str(), test.name,
                failure.empty() ? "ok" : failure.c_str());
    if (!failure.empty()) ++wrong;
  }
  return wrong;
}

const bridge::ExchangePlan& plan() {
  static const bridge::ExchangePlan the_plan = {
      {{"id", "1", bridge::scalar, bridge::ElementType::int64},
       {"position", "m", bridge::vector3, bridge::ElementType::float64},
       {"type", "1", bridge::scalar, bridge::ElementType::int32}},
      {{"force", "N", bridge::vector3, bridge::ElementType::float64},
       {"owner", "1", bridge::scalar, bridge::ElementType::int32}},
      timeout_s};
  return the_plan;
}

/// Particles of one DEM rank in one round, the same whoever asks.
struct Particles {
  std::vector<std::int64_t> id;
  std::vector<double> position;
  std::vector<std::int32_t> type;
  std::vector<int> destination;

  Particles(int round, int rank, int solver_ranks) {
    // Among others: none at all, some for nobody, all for one rank, whole blocks.
    const int count = (round % 5 == 0 && rank % 2 == 0) ? 0 : (37 * round + 11 * rank) % 400;
    for (int i = 0; i < count; ++i) {
      id.push_back(1000000 * (rank + 1) + i);
      for (int c = 0; c < 3; ++c) position.push_back(0.001 * i + rank + 0.1 * c + round);
      type.push_back(i % 3);
      int to = round % 4 == 1 ? 0 : (i * 7 + round) % (solver_ranks + 1) - 1;
      if (round % 4 == 2) to = i * solver_ranks / count;
      destination.push_back(to);
    }
  }
  std::size_t count() const { return id.size(); }
  std::vector<ColumnView> columns() const {
    return {ColumnView(id.data(), count()), ColumnView(position.data(), count()),
            ColumnView(type.data(), count())};
  }
};

double force_of(double position, std::int64_t id) { return 3.0 * position + double(id); }

void dem_round(bridge::DemExchange& exchange, const Particles& particles, int round,
               int solver_ranks) {
  require(solver_ranks > 0, "no solver");
  exchange.send(round, 1e-5 * round, particles.destination, particles.columns());
  std::vector<double> force(3 * particles.count(), -1.0);
  std::vector<std::int32_t> owner(particles.count(), -1);
  exchange.receive({bridge::MutableColumnView(force.data(), particles.count()),
                    bridge::MutableColumnView(owner.data(), particles.count())});
  for (std::size_t i = 0; i < particles.count(); ++i) {
    require(owner[i] == std::max(-1, particles.destination[i]), "a particle went to a wrong rank");
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected =
          owner[i] < 0 ? -1.0 : force_of(particles.position[3 * i + c], particles.id[i]);
      require(force[3 * i + c] == expected, "a value came back to a wrong particle");
    }
  }
}

void solver_round(bridge::SolverExchange& exchange, const MpiWorld& world, int round) {
  const ParticleTable& table = exchange.receive();
  require(table.step == round && table.time_s == 1e-5 * round, "wrong step or time");
  // Ordered by DEM rank, then by the order there: on every transport.
  std::size_t row = 0;
  const auto& id = table.fields[0].values<std::int64_t>();
  const auto& position = table.fields[1].values<double>();
  const auto& type = table.fields[2].values<std::int32_t>();
  for (int rank = 0; rank < world.peer_ranks; ++rank) {
    const Particles sent(round, rank, world.ranks);
    for (std::size_t i = 0; i < sent.count(); ++i) {
      if (sent.destination[i] != world.rank) continue;
      require(row < table.particles && id[row] == sent.id[i] && type[row] == sent.type[i] &&
                  position[3 * row + 2] == sent.position[3 * i + 2],
              "a particle is missing, changed or out of order");
      ++row;
    }
  }
  require(row == table.particles, "more particles than were sent");
  std::vector<double> force(3 * row);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = force_of(position[i], id[i / 3]);
  const std::vector<std::int32_t> owner(row, world.rank);
  exchange.send({ColumnView(force.data(), row), ColumnView(owner.data(), row)});
}

bridge::Hello hello(const MpiWorld& world, const std::string& case_name = "pipe") {
  bridge::Hello hello;
  hello.role = world.role;
  hello.case_name = case_name;
  hello.ranks = world.ranks;
  hello.offers = is_dem(world) ? plan().to_solver : plan().to_dem;
  hello.needs = is_dem(world) ? plan().to_dem : plan().to_solver;
  return hello;
}

std::unique_ptr<bridge::Session> open_session(const MpiWorld& world, const std::string& folder) {
  std::unique_ptr<bridge::Session> session;
  bridge::on_first_rank(world.local, timeout_s, [&] {
    std::unique_ptr<bridge::Transport> transport;
    if (folder.empty()) {
      transport = std::make_unique<bridge::MpiTransport>(world);
    } else if (is_dem(world)) {
      transport = bridge::listen_on_socket({"unix:" + folder + "/s", "", "", timeout_s});
    } else {
      transport = bridge::connect_to_socket({"unix:" + folder + "/s", "", "", timeout_s});
    }
    session = std::make_unique<bridge::Session>(std::move(transport), hello(world), timeout_s);
  });
  return session;
}

constexpr int rounds = 40;

int exchange_over(const MpiWorld& world, bridge::DemExchange* dem, bridge::SolverExchange* solver) {
  for (int round = 0; round < rounds; ++round) {
    if (dem) {
      dem_round(*dem, Particles(round, world.rank, world.peer_ranks), round, world.peer_ranks);
    } else {
      solver_round(*solver, world, round);
    }
  }
  return 0;
}

/// Many to many over MPI, then the same through one connection (MPI, and a socket with a folder).
int exchange(const MpiWorld& world, const std::string& folder) {
  {
    auto dem = is_dem(world) ? bridge::dem_exchange_over_mpi(world, plan()) : nullptr;
    auto solver = is_dem(world) ? nullptr : bridge::solver_exchange_over_mpi(world, plan());
    exchange_over(world, dem.get(), solver.get());
  }
  for (const std::string& where : {std::string(), folder}) {
    const auto session = open_session(world, where);
    auto dem = is_dem(world) ? bridge::dem_exchange_over_session(world.local, session.get(), plan())
                             : nullptr;
    auto solver = is_dem(world)
                      ? nullptr
                      : bridge::solver_exchange_over_session(world.local, session.get(), plan());
    exchange_over(world, dem.get(), solver.get());
    bridge::on_first_rank(world.local, timeout_s, [&] { session->finish(); });
  }
  std::printf("%s %d: exchanges ok\n", world.role.c_str(), world.rank);
  return 0;
}

/// In steady state nothing is allocated.
int steady(const MpiWorld& world) {
  auto dem = is_dem(world) ? bridge::dem_exchange_over_mpi(world, plan()) : nullptr;
  auto solver = is_dem(world) ? nullptr : bridge::solver_exchange_over_mpi(world, plan());
  const Particles particles(7, world.rank, world.peer_ranks);
  const auto columns = particles.columns();
  std::vector<double> force(30000);
  std::vector<std::int32_t> owner(10000);
  std::vector<bridge::MutableColumnView> back = {
      bridge::MutableColumnView(force.data(), particles.count()),
      bridge::MutableColumnView(owner.data(), particles.count())};
  std::vector<ColumnView> forth;
  long before = 0;
  for (int round = 0; round < 50; ++round) {
    if (round == 10) before = allocations;
    if (dem) {
      dem->send(round, 0.0, particles.destination, columns);
      dem->receive(back);
    } else {
      const std::size_t rows = solver->receive().particles;
      forth.clear();
      forth.emplace_back(force.data(), rows);
      forth.emplace_back(owner.data(), rows);
      solver->send(forth);
    }
  }
  const long made = allocations - before;
  std::printf("%s %d: %ld allocations\n", world.role.c_str(), world.rank, made);
  return made == 0 ? 0 : 1;
}

/// A solver rank that does not exist stops both programs with one error.
int wrong_owner(const MpiWorld& world, const std::string& folder) {
  const auto session = open_session(world, folder);
  if (is_dem(world)) {
    auto dem = bridge::dem_exchange_over_session(world.local, session.get(), plan());
    const std::vector<std::int64_t> id(1);
    const std::vector<double> position(3);
    const std::vector<std::int32_t> type(1);
    const std::vector<int> destination = {99};
    dem->send(
        0, 0.0, destination,
        {ColumnView(id.data(), 1), ColumnView(position.data(), 1), ColumnView(type.data(), 1)});
    std::vector<double> force(3);
    std::vector<std::int32_t> owner(1);
    require_none(failure_of(
        [&] {
          dem->receive({bridge::MutableColumnView(force.data(), 1),
                        bridge::MutableColumnView(owner.data(), 1)});
        },
        Kind::peer_failed, "given: 99"));
  } else {
    auto solver = bridge::solver_exchange_over_session(world.local, session.get(), plan());
    require_none(failure_of([&] { solver->receive(); },
                            world.rank == 0 ? Kind::mismatch : Kind::peer_failed, "given: 99"));
  }
  std::printf("%s %d: told\n", world.role.c_str(), world.rank);
  return 0;
}

int other_case(const MpiWorld& world) {
  const std::string failure = failure_of(
      [&] {
        bridge::on_first_rank(world.local, timeout_s, [&] {
          const bridge::Session session(std::make_unique<bridge::MpiTransport>(world),
                                        hello(world, is_dem(world) ? "pipe" : "bed"), timeout_s);
        });
      },
      Kind::mismatch, "dem runs 'pipe', solver runs 'bed'");
  require_none(failure);
  std::printf("%s %d: told\n", world.role.c_str(), world.rank);
  return 0;
}

/// The other program does not take part in an exchange.
int late(const MpiWorld& world) {
  bridge::ExchangePlan hasty = plan();
  hasty.timeout_s = 0.5;
  if (is_dem(world)) {
    auto dem = bridge::dem_exchange_over_mpi(world, hasty);
    const Particles particles(3, world.rank, world.peer_ranks);
    dem->send(0, 0.0, particles.destination, particles.columns());
    std::vector<double> force(3 * particles.count());
    std::vector<std::int32_t> owner(particles.count());
    const bridge::Deadline before(0.4);
    const bridge::Deadline after(0.6);
    require_none(failure_of(
        [&] {
          dem->receive({bridge::MutableColumnView(force.data(), particles.count()),
                        bridge::MutableColumnView(owner.data(), particles.count())});
        },
        Kind::timeout, "nothing within 0.5 s"));
    require(before.expired() && !after.expired(), "the timeout was not kept");
    std::printf("%s %d: told\n", world.role.c_str(), world.rank);
    std::fflush(stdout);
  } else {
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  }
  return 1;
}

int killed(const MpiWorld& world) {
  bridge::MpiTransport transport(world);
  if (is_dem(world)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    raise(SIGKILL);
  }
  bridge::Bytes frame;
  transport.receive(frame, bridge::Deadline(60.0));
  return 0;
}

int run(const std::string& role, const std::string& task, const std::string& folder) {
  if (task == "absent") {
    std::this_thread::sleep_for(std::chrono::milliseconds(2000));
    return 1;
  }
  const MpiWorld world = bridge::split_world_if_shared(role, 1.0 + timeout_s * (task != "present"));
  if (task == "conformance") return conformance(world);
  if (task == "exchange") return exchange(world, folder);
  if (task == "steady") return steady(world);
  if (task == "wrong_owner") return wrong_owner(world, folder);
  if (task == "other_case") return other_case(world);
  if (task == "late") return late(world);
  if (task == "killed") return killed(world);
  return 2;
}

}  // namespace
}  // namespace powderlink::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int status = 1;
  try {
    if (argc < 3) throw std::runtime_error("usage: bridge_mpi_program ROLE TASK [FOLDER]");
    status = powderlink::test::run(argv[1], argv[2], argc > 3 ? argv[3] : "");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  std::fflush(stdout);
  if (status != 0) MPI_Abort(MPI_COMM_WORLD, status);
  MPI_Finalize();
  return status;
}
