// SPDX-License-Identifier: GPL-3.0-or-later
// What an exchange costs, per transport.
//   bridge_bench                                                   unix and TCP sockets
//   mpirun -np 1 bridge_bench dem : -np 2 bridge_bench solver      MPI, many to many
#include <mpi.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "coupling/bridge/exchange/particle_exchange.h"
#include "coupling/bridge/transport/mpi_transport.h"
#include "coupling/bridge/transport/session.h"
#include "coupling/bridge/transport/socket_transport.h"

namespace {

using namespace powderlink::bridge;

constexpr double timeout_s = 30.0;
constexpr int pings = 20000;
constexpr int exchanges = 500;
constexpr std::size_t particles = 16000;

/// Median in microseconds of many runs of an action.
double median_us(int runs, const std::function<void()>& action) {
  std::vector<double> times_us;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    action();
    times_us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
            .count());
  }
  std::nth_element(times_us.begin(), times_us.begin() + runs / 2, times_us.end());
  return times_us[static_cast<std::size_t>(runs / 2)];
}

/// Bytes there and back; halved for one way of the ping.
void first_side(Transport& transport, const std::string& name) {
  const Deadline deadline(1000.0);
  Bytes frame;
  FrameView view;
  encode_text(frame, MessageKind::fields, {});
  const double ping_us = 0.5 * median_us(pings, [&] {
                           transport.send(frame, deadline);
                           transport.receive(frame, deadline);
                         });
  Bytes raw;
  resize(raw, frame.size());
  const FieldSpec spec{"rows", "1", {8, 1}, ElementType::float64};
  const std::vector<double> rows(8 * particles, 1.0);
  FrameWriter writer(raw);
  const auto write = [&] {
    writer.begin(MessageKind::fields, 0, 0.0);
    writer.add(spec, ColumnView(rows.data(), particles));
    writer.finish();
  };
  write();
  const double raw_us = median_us(exchanges, [&] {
    transport.send(raw, deadline);
    transport.receive(raw, deadline);
  });
  const double whole_us = median_us(exchanges, [&] {
    write();
    transport.send(raw, deadline);
    transport.receive(frame, deadline);
    decode(frame, view);
  });
  std::printf(
      "%-6s ping %5.1f us; 16 000 x 8 doubles each way: bytes only %.3f ms, "
      "as checked frames %.3f ms\n",
      name.c_str(), ping_us, 1e-3 * raw_us, 1e-3 * whole_us);
  std::fflush(stdout);
}

void second_side(Transport& transport) {
  const Deadline deadline(1000.0);
  Bytes frame;
  Bytes answer;
  FrameView view;
  for (int i = 0; i < pings + exchanges; ++i) {
    transport.receive(frame, deadline);
    transport.send(frame, deadline);
  }
  const FieldSpec spec{"rows", "1", {8, 1}, ElementType::float64};
  const std::vector<double> rows(8 * particles, 1.0);
  for (int i = 0; i < exchanges; ++i) {
    transport.receive(frame, deadline);
    decode(frame, view);
    FrameWriter writer(answer);
    writer.begin(MessageKind::fields, 0, 0.0);
    writer.add(spec, ColumnView(rows.data(), particles));
    writer.finish();
    transport.send(answer, deadline);
  }
}

ExchangePlan plan() {
  return {{{"position", "m", vector3, ElementType::float64},
           {"velocity", "m/s", vector3, ElementType::float64},
           {"radius", "m", scalar, ElementType::float64},
           {"id", "1", scalar, ElementType::int64}},
          {{"force", "N", vector3, ElementType::float64},
           {"fluid_velocity", "m/s", vector3, ElementType::float64},
           {"drag_coefficient", "kg/s", scalar, ElementType::float64},
           {"fluid_fraction", "1", scalar, ElementType::float64}},
          timeout_s};
}

void dem_rounds(DemExchange& exchange, int solver_ranks, const std::string& name) {
  std::vector<int> destination(particles);
  // Neighbours in memory are not neighbours in space: the worst case for gathering.
  for (std::size_t i = 0; i < particles; ++i) {
    destination[i] = static_cast<int>(i * 7919 % static_cast<std::size_t>(solver_ranks));
  }
  const std::vector<double> vectors(3 * particles, 1.0);
  const std::vector<std::int64_t> ids(particles, 1);
  std::vector<double> back[4];
  for (auto& column : back) column.resize(3 * particles);
  std::int64_t step = 0;
  const double us = median_us(exchanges, [&] {
    exchange.send(step++, 0.0, destination,
                  {ColumnView(vectors.data(), particles), ColumnView(vectors.data(), particles),
                   ColumnView(vectors.data(), particles), ColumnView(ids.data(), particles)});
    exchange.receive({MutableColumnView(back[0].data(), particles),
                      MutableColumnView(back[1].data(), particles),
                      MutableColumnView(back[2].data(), particles),
                      MutableColumnView(back[3].data(), particles)});
  });
  std::printf(
      "%-6s particle exchange, 16 000 x 8 each way, 1 DEM rank, %d solver rank(s): %.3f ms\n",
      name.c_str(), solver_ranks, 1e-3 * us);
  std::fflush(stdout);
}

void solver_rounds(SolverExchange& exchange) {
  const std::vector<double> vectors(3 * particles, 1.0);
  for (int i = 0; i < exchanges; ++i) {
    const std::size_t rows = exchange.receive().particles;
    exchange.send({ColumnView(vectors.data(), rows), ColumnView(vectors.data(), rows),
                   ColumnView(vectors.data(), rows), ColumnView(vectors.data(), rows)});
  }
}

void bench_socket(const std::string& name, const std::string& address, const std::string& file) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    second_side(*connect_to_socket({"", file, "", timeout_s}));
    _exit(0);
  }
  first_side(*listen_on_socket({address, file, "", timeout_s}), name);
  waitpid(child, nullptr, 0);
}

void bench_mpi(const std::string& role) {
  const MpiWorld world = split_world_if_shared(role, timeout_s);
  const bool dem = role == "dem";
  if (world.rank == 0) {
    MpiTransport transport(world);
    if (dem) {
      first_side(transport, "mpi");
    } else {
      second_side(transport);
    }
  }
  if (dem) {
    dem_rounds(*dem_exchange_over_mpi(world, plan()), world.peer_ranks, "mpi");
  } else {
    solver_rounds(*solver_exchange_over_mpi(world, plan()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 1) {
      MPI_Init(&argc, &argv);
      bench_mpi(argv[1]);
      MPI_Finalize();
      return 0;
    }
    char folder[] = "/tmp/powderlink_bench_XXXXXX";
    if (!mkdtemp(folder)) throw std::runtime_error("cannot make a temporary folder");
    const std::string path = folder;
    bench_socket("unix", "unix:" + path + "/socket", path + "/meet");
    bench_socket("tcp", "127.0.0.1:0", path + "/meet");
    rmdir(folder);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
