// SPDX-License-Identifier: GPL-3.0-or-later
// fake_dem KEY=VALUE...: the particles' side of a coupled job without LIGGGHTS; coupled_test.sh uses it.
// Spheres without contacts and weight on a lattice, velocities that differ from each other. Between
// exchanges they relax towards the fluid as the contract of the coupling says, or are held (fixed=1).
// Prints the impulse that the solver took and, at the end, writes its state (text, by id) to FILE.
//   transport=mpi|socket folder=. case=NAME dt=STEP every=N side=LENGTH low=LENGTH grid=N radius=R
//   exchanges=MAX fixed=0|1 state=FILE (begin with it) out=FILE die_at=N (exit without a word)
//   first_step=N (of its clock) skip=N (steps that its clock is ahead after each exchange)
//   open=0|1 (not periodic) vanish=X (those that come to x < X)
#include <mpi.h>

#include <unistd.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>

#include "coupling/bridge/exchange/coupling_fields.h"
#include "coupling/bridge/link/coupling_link.h"

namespace powderlink::test {
namespace {

namespace fields = bridge::fields;
using bridge::ColumnView;
using bridge::MutableColumnView;

constexpr double density_kg_m3 = 7950.0;
constexpr double pi = 3.14159265358979323846;

using Options = std::map<std::string, std::string>;
double number(const Options& options, const char* key) { return std::stod(options.at(key)); }

/// All particles live on rank 0; other ranks take part with none.
struct Particles {
  std::vector<std::int64_t> id;
  std::vector<double> x, v, spin, radius, density, impulse;
  std::vector<double> place;  ///< of the last exchange
  std::size_t count() const { return id.size(); }

  void erase(std::size_t i) {
    const auto scalar = static_cast<std::ptrdiff_t>(i);
    id.erase(id.begin() + scalar);
    for (auto* column : {&radius, &density}) column->erase(column->begin() + scalar);
    for (auto* column : {&x, &v, &spin, &impulse, &place}) {
      column->erase(column->begin() + 3 * scalar, column->begin() + 3 * scalar + 3);
    }
  }
  /// A row without a radius: the impulse of one that has vanished.
  void add_vanished(const Particles& from, std::size_t i) {
    id.push_back(from.id[i]);
    radius.push_back(0.0);
    density.push_back(0.0);
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      x.push_back(from.place[c]);
      v.push_back(0.0);
      spin.push_back(0.0);
      impulse.push_back(from.impulse[c]);
    }
  }
};

Particles lattice(const Options& options) {
  Particles p;
  const int n = std::stoi(options.at("grid"));
  const double gap = number(options, "side") / n;
  for (int i = 0; i < n * n * n; ++i) {
    const int index[3] = {i % n, i / n % n, i / n / n};
    p.id.push_back(10 * i + 3);
    for (int c = 0; c < 3; ++c) {
      // Off the faces of the cells; where a point on a face goes is not the subject.
      p.x.push_back(number(options, "low") + gap * (index[c] + 0.437 + 0.01 * c));
      p.v.push_back(0.5 * std::sin(1.0 + 0.7 * i + 2.0 * c) - (c == 0 ? 1.0 : 0.0));
    }
  }
  p.radius.assign(p.count(), number(options, "radius"));
  p.density.assign(p.count(), density_kg_m3);
  p.spin.assign(3 * p.count(), 0.0);
  p.impulse.assign(3 * p.count(), 0.0);
  return p;
}

void save(const Particles& p, std::int64_t step, const std::string& file) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (!out) throw std::runtime_error("cannot write " + file);
  std::fprintf(out, "%lld %zu\n", static_cast<long long>(step), p.count());
  for (std::size_t i = 0; i < p.count(); ++i) {
    std::fprintf(out, "%lld %.17g", static_cast<long long>(p.id[i]), p.radius[i]);
    for (const auto* column : {&p.x, &p.v, &p.impulse}) {
      for (std::size_t c = 0; c < 3; ++c) std::fprintf(out, " %.17g", (*column)[3 * i + c]);
    }
    std::fprintf(out, "\n");
  }
  std::fclose(out);
}

Particles load(const std::string& file, std::int64_t& step) {
  std::ifstream in(file);
  std::size_t count = 0;
  in >> step >> count;
  Particles p;
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t id = 0;
    double radius = 0.0;
    in >> id >> radius;
    p.id.push_back(id);
    p.radius.push_back(radius);
    for (auto* column : {&p.x, &p.v, &p.impulse}) {
      for (int c = 0; c < 3; ++c) {
        double value = 0.0;
        in >> value;
        column->push_back(value);
      }
    }
  }
  if (!in) throw std::runtime_error("cannot read " + file);
  p.density.assign(count, density_kg_m3);
  p.spin.assign(3 * count, 0.0);
  return p;
}

struct Values {
  explicit Values(std::size_t n)
      : u(3 * n), fraction(n), drag(n), reacting(3 * n), pressure(3 * n) {}
  std::vector<double> u, fraction, drag, reacting, pressure;

  void erase(std::size_t i) {
    const auto scalar = static_cast<std::ptrdiff_t>(i);
    for (auto* column : {&fraction, &drag}) column->erase(column->begin() + scalar);
    for (auto* column : {&u, &reacting, &pressure}) {
      column->erase(column->begin() + 3 * scalar, column->begin() + 3 * scalar + 3);
    }
  }
};

/// One step of the DEM, constant coefficients; side 0: not periodic.
void advance(Particles& p, const Values& w, double dt, bool fixed, double side) {
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double r = p.radius[i];
    const double mass = 4.0 / 3.0 * pi * r * r * r * p.density[i];
    const double x = w.drag[i] * dt / mass;
    const double phi = x > 0.0 ? -std::expm1(-x) / x : 1.0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const double force = w.reacting[c] + w.pressure[c] + w.drag[i] * (w.u[c] - p.v[c]);
      if (fixed) {
        p.impulse[c] += dt * (force - w.pressure[c]);
        continue;
      }
      const double change = phi * dt * force / mass;
      p.impulse[c] += mass * change - dt * w.pressure[c];
      p.v[c] += change;
      p.x[c] += dt * p.v[c];
      if (side == 0.0) continue;
      if (p.x[c] < 0.0) p.x[c] += side;
      if (p.x[c] >= side) p.x[c] -= side;
    }
  }
}

void vanish(Particles& p, Values& w, double below, Particles& gone) {
  for (std::size_t i = p.count(); i-- > 0;) {
    if (p.x[3 * i] >= below) continue;
    gone.add_vanished(p, i);
    p.erase(i);
    w.erase(i);
  }
}

int run(const Options& options, const bridge::MpiWorld& world) {
  bridge::LinkOptions link;
  link.world = world;
  link.timeout_s = 20.0;
  if (options.at("transport") == "socket") {
    link.route = bridge::LinkOptions::Route::socket;
    link.socket.rendezvous_file = options.at("folder") + "/bridge.address";
  }
  const double dt = number(options, "dt");
  const int every = std::stoi(options.at("every"));
  bridge::Hello hello;
  hello.role = "dem";
  hello.case_name = options.at("case");
  hello.ranks = world.ranks;
  hello.exchange_interval_s = every * dt;
  hello.offers = {fields::id,     fields::position, fields::velocity,         fields::spin,
                  fields::radius, fields::density,  fields::reaction_impulse, fields::held};
  hello.needs = {fields::fluid_velocity, fields::fluid_fraction, fields::drag_coefficient,
                 fields::reacting_force, fields::pressure_force};
  std::int64_t step = 0;
  Particles p;
  if (world.rank == 0) {
    p = options.count("state") ? load(options.at("state"), step) : lattice(options);
  }
  if (options.count("first_step")) step = std::stol(options.at("first_step"));
  MPI_Bcast(&step, 1, MPI_INT64_T, 0, world.local);
  hello.clock.time_s = static_cast<double>(step) * dt;
  bridge::DemLink dem(world.local, link, hello, hello.needs);
  double total[3] = {0.0, 0.0, 0.0};
  Particles gone;  // since the last exchange
  for (int exchange = 0; exchange < std::stoi(options.at("exchanges")); ++exchange) {
    if (options.count("die_at") && exchange == std::stoi(options.at("die_at"))) _exit(3);
    Particles rows = p;
    p.place = p.x;
    for (std::size_t i = 0; i < gone.count(); ++i) {
      gone.place = gone.x;
      rows.add_vanished(gone, i);
    }
    gone = Particles();
    const std::size_t n = rows.count();
    std::vector<int> destination;
    for (std::size_t i = 0; i < n; ++i) {
      destination.push_back(dem.rank_map().rank_of(&rows.x[3 * i]));
    }
    const std::vector<double> held(n, 0.0);
    const ColumnView columns[] = {
        ColumnView(rows.id.data(), n),      ColumnView(rows.x.data(), n),
        ColumnView(rows.v.data(), n),       ColumnView(rows.spin.data(), n),
        ColumnView(rows.radius.data(), n),  ColumnView(rows.density.data(), n),
        ColumnView(rows.impulse.data(), n), ColumnView(held.data(), n)};
    std::vector<ColumnView> sent;
    for (const auto& spec : dem.plan().to_solver) {
      for (std::size_t k = 0; k < hello.offers.size(); ++k) {
        if (spec == hello.offers[k]) sent.push_back(columns[k]);
      }
    }
    dem.send_particles(step, static_cast<double>(step) * dt, destination, sent);
    Values w(n);
    const bridge::SolverWord word = dem.receive_values(
        {MutableColumnView(w.u.data(), n), MutableColumnView(w.fraction.data(), n),
         MutableColumnView(w.drag.data(), n), MutableColumnView(w.reacting.data(), n),
         MutableColumnView(w.pressure.data(), n)});
    if (word.checkpoint && world.rank == 0) {
      save(p, step, options.at("out") + "." + std::to_string(step));
    }
    if (word.command == bridge::Command::stop) break;
    for (std::size_t c = 0; c < 3 * n; ++c) total[c % 3] += rows.impulse[c];
    p.impulse.assign(3 * p.count(), 0.0);
    for (int i = 0; i < every; ++i) {
      advance(p, w, dt, options.at("fixed") == "1",
              options.at("open") == "1" ? 0.0 : number(options, "side"));
      if (options.count("vanish")) vanish(p, w, number(options, "vanish"), gone);
    }
    step += every + std::stoi(options.at("skip"));
  }
  dem.finish();
  if (world.rank == 0) {
    save(p, step, options.at("out"));
    std::printf("taken: %.17g %.17g %.17g\n", total[0], total[1], total[2]);
  }
  return 0;
}

}  // namespace
}  // namespace powderlink::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  powderlink::test::Options options{{"transport", "mpi"},   {"folder", "."}, {"case", "closed_box"},
                                    {"dt", "2e-6"},         {"every", "10"}, {"side", "4e-3"},
                                    {"low", "0"},           {"grid", "6"},   {"radius", "3e-5"},
                                    {"exchanges", "10000"}, {"fixed", "0"},  {"out", "dem.state"},
                                    {"skip", "0"},          {"open", "0"}};
  int status = 0;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string word(argv[i]);
      const auto equals = word.find('=');
      if (equals == std::string::npos) throw std::runtime_error("not KEY=VALUE: " + word);
      options[word.substr(0, equals)] = word.substr(equals + 1);
    }
    status = powderlink::test::run(options, powderlink::bridge::split_world_if_shared("dem", 20.0));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fake_dem: %s\n", e.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return status;
}
