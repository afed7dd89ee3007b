// SPDX-License-Identifier: GPL-3.0-or-later
// fake_solver KEY=VALUE...: the other program of a coupled job with a gas that the test prescribes.
//   case=NAME interval=D            as a solver's, interval in s
//   socket=FILE                     rendezvous file; without it both programs share one mpirun
//   box=XLO,XHI                     mesh along x, one slab per rank; particles beyond go to the nearest
//   wind=X,Y,Z  drag=K | stokes=ETA fluid velocity [m/s], K [kg/s] or K = 6 pi ETA radius
//   react=X,Y,Z  press=X,Y,Z        explicit forces [N]
//   added_mass=C                    m_a = C m
//   turn=SPIN,K_R,TORQUE            about z
//   above=Z                         no fluid below: zeros, fluid fraction 1
//   labels=1                        fluid velocity is (id, radius, x) instead, no drag
//   time=T ahead=D                 clock at the start; with D: goes on from a checkpoint, D ahead of
//                                  LIGGGHTS's
//   stop=N checkpoint=N,M,... fail=N nan=N   numbers of exchanges, from 0
//   unknown=1                       offers a field that LIGGGHTS has no use for
//   log=FILE                        per exchange: step, time, particles, sum of reaction impulses
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "coupling/bridge/exchange/coupling_fields.h"
#include "coupling/bridge/link/coupling_link.h"

namespace powderlink::testing {
namespace {

namespace fields = bridge::fields;

constexpr double kPi = 3.14159265358979323846;

class Settings {
 public:
  Settings(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      const auto at = word.find('=');
      if (at == std::string::npos) throw std::runtime_error("not KEY=VALUE: " + word);
      values_[word.substr(0, at)] = word.substr(at + 1);
    }
  }
  bool has(const std::string& key) const { return values_.count(key) != 0; }
  std::string text(const std::string& key) const { return has(key) ? values_.at(key) : ""; }
  double number(const std::string& key, double otherwise) const {
    return has(key) ? std::stod(values_.at(key)) : otherwise;
  }
  std::vector<double> list(const std::string& key, std::size_t size = 0) const {
    std::vector<double> numbers;
    std::istringstream words(text(key));
    for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stod(word));
    if (size > 0) numbers.resize(size, 0.0);
    return numbers;
  }
  bool names(const std::string& key, int n) const {
    for (const double value : list(key)) {
      if (static_cast<int>(value) == n) return true;
    }
    return false;
  }

 private:
  std::map<std::string, std::string> values_;
};

class Gas {
 public:
  explicit Gas(const Settings& settings)
      : settings_(settings),
        wind_(settings.list("wind", 3)),
        react_(settings.list("react", 3)),
        press_(settings.list("press", 3)),
        turn_(settings.list("turn", 3)) {}

  std::vector<bridge::FieldSpec> offers() const {
    std::vector<bridge::FieldSpec> list = {fields::fluid_velocity, fields::fluid_fraction,
                                           fields::drag_coefficient, fields::reacting_force,
                                           fields::pressure_force};
    if (settings_.has("added_mass")) list.push_back(fields::added_mass);
    if (settings_.has("turn")) {
      list.push_back(fields::fluid_spin);
      list.push_back(fields::rotational_drag);
      list.push_back(fields::fluid_torque);
    }
    if (settings_.has("unknown")) list.push_back({"fluid_temperature", "K", bridge::scalar});
    return list;
  }

  /// Columns of the offers for these particles.
  const std::vector<std::vector<double>>& values(const bridge::ParticleTable& table, bool broken) {
    const auto& id = table.fields[0].values<std::int64_t>();
    const auto& x = table.fields[1].values<double>();
    const auto& radius = table.fields[4].values<double>();
    const auto& density = table.fields[5].values<double>();
    columns_.assign(offers().size(), {});
    for (std::size_t i = 0; i < table.particles; ++i) {
      const double mass = density[i] * 4.0 / 3.0 * kPi * std::pow(radius[i], 3);
      const bool labels = settings_.has("labels");
      const std::vector<double> wind =
          labels ? std::vector<double>{double(id[i]), radius[i], x[3 * i]} : wind_;
      double drag = settings_.number("drag", 0.0);
      if (settings_.has("stokes")) drag = 6.0 * kPi * settings_.number("stokes", 0.0) * radius[i];
      if (broken) drag = std::nan("");
      std::size_t next = 0;
      if (settings_.has("above") && x[3 * i + 2] < settings_.number("above", 0.0)) {
        for (const bridge::FieldSpec& field : offers()) {
          const double value = field == fields::fluid_fraction ? 1.0 : 0.0;
          add(next, std::vector<double>(field.shape.components(), value));
        }
        continue;
      }
      add(next, wind);
      add(next, {1.0});
      add(next, {labels ? 0.0 : drag});
      add(next, react_);
      add(next, press_);
      if (settings_.has("added_mass")) add(next, {settings_.number("added_mass", 0.0) * mass});
      if (settings_.has("turn")) {
        add(next, {0.0, 0.0, turn_[0]});
        add(next, {turn_[1]});
        add(next, {0.0, 0.0, turn_[2]});
      }
    }
    return columns_;
  }

 private:
  void add(std::size_t& next, const std::vector<double>& row) {
    columns_[next].insert(columns_[next].end(), row.begin(), row.end());
    ++next;
  }

  Settings settings_;
  std::vector<double> wind_, react_, press_, turn_;
  std::vector<std::vector<double>> columns_;
};

void log_exchange(std::FILE* file, MPI_Comm local, const bridge::ParticleTable& table) {
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  for (const double radius : table.fields[4].values<double>()) {
    if (radius > 0.0) ++sums[0];  // the others have vanished
  }
  const auto& impulse = table.fields[6].values<double>();
  for (std::size_t i = 0; i < impulse.size(); ++i) sums[1 + i % 3] += impulse[i];
  double all[4] = {0, 0, 0, 0};
  MPI_Reduce(sums, all, 4, MPI_DOUBLE, MPI_SUM, 0, local);
  if (file == nullptr) return;
  std::fprintf(file, "%ld %.17g %.0f %.17g %.17g %.17g\n", static_cast<long>(table.step),
               table.time_s, all[0], all[1], all[2], all[3]);
  std::fflush(file);
}

int run(const Settings& settings) {
  constexpr double timeout_s = 20.0;
  bridge::LinkOptions link;
  link.world = bridge::split_world_if_shared("solver", timeout_s);
  link.timeout_s = timeout_s;
  if (settings.has("socket")) {
    link.route = bridge::LinkOptions::Route::socket;
    link.socket.rendezvous_file = settings.text("socket");
    link.listens = true;
  }
  Gas gas(settings);
  bridge::Hello hello;
  hello.role = "solver";
  hello.case_name = settings.text("case");
  hello.ranks = link.world.ranks;
  hello.exchange_interval_s = settings.number("interval", 0.0);
  hello.clock = {settings.number("time", 0.0), settings.has("ahead"),
                 settings.number("ahead", 0.0)};
  hello.needs = {fields::id,     fields::position, fields::velocity,        fields::spin,
                 fields::radius, fields::density,  fields::reaction_impulse};
  hello.offers = gas.offers();
  std::vector<double> box = settings.list("box");
  if (box.empty()) box = {-1e-2, 1e-2};
  bridge::RankMap map;
  map.voxels = {link.world.ranks, 1, 1};
  map.origin_m = {box[0], -1.0, -1.0};
  map.spacing_m = {(box[1] - box[0]) / link.world.ranks, 2.0, 2.0};
  for (int rank = 0; rank < link.world.ranks; ++rank) map.rank.push_back(rank);

  bridge::SolverLink dem(link.world.local, link, hello, map);
  std::FILE* file = nullptr;
  if (settings.has("log") && link.world.rank == 0) {
    file = std::fopen(settings.text("log").c_str(), "a");
  }
  for (int n = 0; dem.receive_particles(); ++n) {
    const bridge::ParticleTable& table = dem.particles();
    log_exchange(file, link.world.local, table);
    const auto& x = table.fields[1].values<double>();
    for (std::size_t i = 0; i < table.particles; ++i) {
      if (map.rank_of(&x[3 * i]) != link.world.rank) throw std::runtime_error("another's particle");
    }
    if (settings.names("fail", n)) {
      const char* why = "flow; given: diverged; allowed: finite; to do: lower the time step";
      dem.fail(why);
      throw std::runtime_error(why);
    }
    bridge::SolverWord word;
    word.command = settings.names("stop", n) ? bridge::Command::stop : bridge::Command::go_on;
    word.checkpoint = settings.names("checkpoint", n);
    word.checkpoint_next = settings.names("checkpoint", n + 1);
    std::vector<bridge::ColumnView> columns;
    for (const auto& column : gas.values(table, settings.names("nan", n))) {
      columns.emplace_back(column.data(), table.particles);
    }
    dem.send_values(word, columns);
    if (word.command == bridge::Command::stop) break;
  }
  if (link.world.rank == 0) std::puts("fake solver: orderly end");
  return 0;
}

}  // namespace
}  // namespace powderlink::testing

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    powderlink::testing::run(powderlink::testing::Settings(argc, argv));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fake solver: %s\n", e.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  std::fflush(stdout);
  MPI_Finalize();
  return 0;
}
