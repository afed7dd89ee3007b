// SPDX-License-Identifier: GPL-3.0-or-later
// link_program ROLE TASK mpi|socket [FOLDER]: one host of a coupled job; link_test.cpp starts it.
#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "coupling/bridge/exchange/coupling_fields.h"
#include "coupling/bridge/link/coupling_link.h"
#include "tests/coupling/bridge/fails.h"

namespace powderlink::test {
namespace {

namespace fields = bridge::fields;
using bridge::BridgeError;
using bridge::ColumnView;
using bridge::Command;
using bridge::MutableColumnView;
using Kind = BridgeError::Kind;

constexpr double timeout_s = 10.0;
constexpr double interval_s = 1e-5;
constexpr int rounds = 6;

const bridge::FieldSpec temperature{"fluid_temperature", "K", bridge::scalar};

struct Task {
  std::string role, name;
  bridge::LinkOptions link;
  bool is_dem() const { return role == "dem"; }
  bool is(const std::string& other) const { return name == other; }
};

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}
void require_none(const std::string& failure) {
  if (!failure.empty()) throw std::runtime_error(failure);
}

void say(const Task& task, const std::string& words) {
  std::printf("%s %d: %s\n", task.role.c_str(), task.link.world.rank, words.c_str());
  std::fflush(stdout);
}

bridge::Hello hello(const Task& task) {
  bridge::Hello hello;
  hello.role = task.role;
  hello.case_name = "pipe";
  hello.ranks = task.link.world.ranks;
  hello.exchange_interval_s = interval_s;
  if (task.is_dem()) {
    hello.offers = {fields::id, fields::position, fields::velocity};
    hello.needs = {fields::fluid_velocity};
    if (task.is("interval")) hello.exchange_interval_s *= 1.5;
  } else {
    hello.needs = {fields::position, fields::id};  // another order than the offer, and less
    hello.offers = {fields::fluid_velocity, fields::drag_coefficient};
    if (task.is("unknown_field")) hello.offers.push_back(temperature);
  }
  return hello;
}

/// Solver ranks own slabs of the unit cube along x; the last voxel belongs to nobody.
bridge::RankMap map_of(int solver_ranks) {
  bridge::RankMap map;
  map.voxels = {2 * solver_ranks + 1, 1, 2};
  map.spacing_m = {0.5 / solver_ranks, 1.0, 0.5};
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 2 * solver_ranks; ++i) map.rank.push_back(i / 2);
    map.rank.push_back(-1);
  }
  return map;
}

int owner_of(double x, int solver_ranks) {
  if (x >= 1.0 || x < 0.0) return 0;  // the voxel of nobody; the nearest voxel
  return static_cast<int>(x * solver_ranks);
}

std::vector<bridge::FieldSpec> known() {
  return {fields::fluid_velocity, fields::drag_coefficient, fields::added_mass};
}

int dem(const Task& task) {
  bridge::DemLink link(task.link.world.local, task.link, hello(task), known());
  require(link.peer().role == "solver" && link.plan().to_solver.size() == 2 &&
              link.plan().to_solver[0] == fields::position && link.plan().to_dem.size() == 2,
          "plan");
  const int solver_ranks = link.peer().ranks;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t count = 5 + 3 * static_cast<std::size_t>(task.link.world.rank + round);
    std::vector<double> position(3 * count);
    std::vector<std::int64_t> id(count);
    std::vector<int> destination(count);
    for (std::size_t i = 0; i < count; ++i) {
      id[i] = static_cast<std::int64_t>(100 * task.link.world.rank + static_cast<int>(i));
      position[3 * i] = -0.1 + 1.2 * static_cast<double>(i) / static_cast<double>(count);
      destination[i] = link.rank_map().rank_of(&position[3 * i]);
      require(destination[i] == owner_of(position[3 * i], solver_ranks), "owner");
    }
    if (task.is("dem_fails") && round == 2) {
      link.fail("dem: grain lost; given: a; allowed: b; to do: c");
      say(task, "failed");
      return 0;
    }
    if ((task.is("dem_dies") || task.is("dem_rank_dies")) && round == 2) {
      // As a host whose own errors end it: on all ranks at once, or on one that nobody waits for.
      if (task.is("dem_rank_dies") && task.link.world.rank == 0)
        std::this_thread::sleep_for(std::chrono::seconds(30));
      bridge::say_last_words("dem: lost atoms; given: a; allowed: b; to do: c");
      std::_Exit(3);
    }
    if (task.is("dem_rank_fails") && round == 2 && task.link.world.rank == 1) {
      destination.front() = 77;
    }
    link.send_particles(round, round * interval_s, destination,
                        {ColumnView(position.data(), count), ColumnView(id.data(), count)});
    std::vector<double> velocity(3 * count, -1.0);
    std::vector<double> drag(count, -1.0);
    const bridge::SolverWord word = link.receive_values(
        {MutableColumnView(velocity.data(), count), MutableColumnView(drag.data(), count)});
    if (word.command == Command::stop) {
      require(drag[0] == -1.0, "a stop changed the values");
      link.finish();
      say(task, "stopped in round " + std::to_string(round));
      return 0;
    }
    require(word.checkpoint == (round == 3), "checkpoint word");
    for (std::size_t i = 0; i < count; ++i) {
      require(velocity[3 * i] == 2.0 * position[3 * i], "velocity");
      require(drag[i] == static_cast<double>(1000 * destination[i]) + double(id[i]), "drag");
    }
  }
  if (task.is("dem_leaves")) return 0;  // without goodbye
  link.finish();
  link.finish();
  say(task, "finished");
  return 0;
}

int solver(const Task& task) {
  bridge::SolverLink link(task.link.world.local, task.link, hello(task),
                          map_of(task.link.world.ranks));
  for (int round = 0; link.receive_particles(); ++round) {
    const bridge::ParticleTable& table = link.particles();
    require(table.step == round && table.time_s == round * interval_s, "step");
    if (task.is("solver_rank_fails") && round == 2) {
      // An error that the other ranks do not know of, until the job ends.
      if (task.link.world.rank == 0) std::this_thread::sleep_for(std::chrono::seconds(30));
      link.fail("solver: diverged; given: a; allowed: b; to do: c");
      std::_Exit(3);
    }
    if (task.is("solver_fails") && round == 2) {
      link.fail("solver: diverged; given: a; allowed: b; to do: c");
      say(task, "failed");
      return 0;
    }
    if (task.is("stop") && round == 2) {
      link.send_values({Command::stop, false}, {});
      link.finish();
      say(task, "stopped");
      return 0;
    }
    const auto& position = table.fields[0].values<double>();
    const auto& id = table.fields[1].values<std::int64_t>();
    std::vector<double> velocity(3 * table.particles);
    std::vector<double> drag(table.particles);
    for (std::size_t i = 0; i < table.particles; ++i) {
      velocity[3 * i] = 2.0 * position[3 * i];
      drag[i] = 1000.0 * task.link.world.rank + double(id[i]);
    }
    link.send_values({Command::go_on, round == 3}, {ColumnView(velocity.data(), table.particles),
                                                    ColumnView(drag.data(), table.particles)});
    if (task.is("finish") && round == 1) {
      link.finish();
      say(task, "finished by itself");
      return 0;
    }
  }
  require(link.particles().particles == 0, "particles after the end");
  say(task, "dem finished");
  return 0;
}

int run(const Task& task) { return task.is_dem() ? dem(task) : solver(task); }

/// Runs the task; its error must be of that kind and say those words.
int expect(const Task& task, Kind kind, const std::string& words) {
  require_none(failure_of([&] { run(task); }, kind, words));
  say(task, "told");
  return 0;
}

int dispatch(const Task& task) {
  if (task.is("unknown_field")) {
    return expect(task, task.is_dem() ? Kind::mismatch : Kind::peer_failed,
                  "fluid_temperature [K] float64 1x1, dem does not know it");
  }
  if (task.is("interval")) return expect(task, Kind::mismatch, "interval between exchanges");
  if (task.is("dem_fails") && !task.is_dem()) return expect(task, Kind::peer_failed, "grain lost");
  if (task.is("solver_fails") && task.is_dem()) return expect(task, Kind::peer_failed, "diverged");
  if ((task.is("dem_dies") || task.is("dem_rank_dies")) && !task.is_dem()) {
    expect(task, Kind::peer_failed, "its error: dem: lost atoms");
    std::_Exit(4);
  }
  if (task.is("solver_rank_fails") && task.is_dem()) {
    expect(task, Kind::peer_failed, "its error: solver: diverged");
    std::_Exit(4);
  }
  if (task.is("dem_leaves") && !task.is_dem()) {
    return expect(task, Kind::peer_failed, "dem ended without saying goodbye");
  }
  if (task.is("dem_rank_fails") && task.is_dem()) {
    expect(task, Kind::mismatch, "given: 77");
    MPI_Barrier(task.link.world.local);
    MPI_Abort(MPI_COMM_WORLD, 1);  // as a host does: the solver waits for particles
  }
  return run(task);
}

Task read_task(int argc, char** argv) {
  if (argc < 4) throw std::runtime_error("usage: link_program ROLE TASK mpi|socket [FOLDER]");
  Task task;
  task.role = argv[1];
  task.name = argv[2];
  task.link.world = bridge::split_world_if_shared(task.role, timeout_s);
  task.link.timeout_s = timeout_s;
  if (std::string(argv[3]) == "socket") {
    task.link.route = bridge::LinkOptions::Route::socket;
    task.link.socket.rendezvous_file = std::string(argv[4]) + "/bridge.address";
    task.link.listens = !task.is_dem();
  }
  return task;
}

}  // namespace
}  // namespace powderlink::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    powderlink::test::dispatch(powderlink::test::read_task(argc, argv));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return 0;
}
