// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_case.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

#include <sys/wait.h>

namespace powderlink::testing {

namespace fs = std::filesystem;

namespace {

constexpr int kSecondsPerRun = 120;

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream s;
  s << in.rdbuf();
  return s.str();
}

std::vector<Sphere> read_last_dump(const fs::path& file) {
  std::ifstream in(file);
  std::map<long, Sphere> spheres;
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("ITEM: ATOMS", 0) != 0) continue;
    spheres.clear();
    while (in.peek() != 'I' && std::getline(in, line)) {
      std::istringstream words(line);
      long id = 0;
      Sphere s;
      words >> id;
      for (double& value : s.x) words >> value;
      for (double& value : s.v) words >> value;
      for (double& value : s.omega) words >> value;
      spheres[id] = s;
    }
  }
  std::vector<Sphere> ordered;
  ordered.reserve(spheres.size());
  for (const auto& entry : spheres) ordered.push_back(entry.second);
  return ordered;
}

}  // namespace

LiggghtsCase::LiggghtsCase(const std::string& name) : folder_(fs::path(POWDERLINK_RUNS) / name) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void LiggghtsCase::write(const std::string& file, const std::string& content) const {
  std::ofstream(folder_ / file) << content;
}

void LiggghtsCase::write_spheres(const std::string& file, const std::vector<Sphere>& spheres,
                                 double half) const {
  std::ofstream out(folder_ / file);
  out << std::setprecision(17) << "spheres\n\n" << spheres.size() << " atoms\n2 atom types\n\n";
  for (const char axis : {'x', 'y', 'z'}) {
    out << -half << ' ' << half << ' ' << axis << "lo " << axis << "hi\n";
  }
  out << "\nAtoms\n\n";
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Sphere& s = spheres[i];
    out << i + 1 << ' ' << s.type << ' ' << s.diameter << ' ' << s.density << ' ' << s.x[0] << ' '
        << s.x[1] << ' ' << s.x[2] << '\n';
  }
  out << "\nVelocities\n\n";
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Sphere& s = spheres[i];
    out << i + 1;
    for (const double v : s.v) out << ' ' << v;
    for (const double w : s.omega) out << ' ' << w;
    out << '\n';
  }
}

void LiggghtsCase::write_plate(const std::string& file, double half, int n) const {
  std::ofstream out(folder_ / file);
  out << std::setprecision(17) << "solid plate\n";
  const auto triangle = [&](double x0, double y0, double x1, double y1, double x2, double y2) {
    out << "facet normal 0 0 1\n outer loop\n"
        << "  vertex " << x0 << ' ' << y0 << " 0\n  vertex " << x1 << ' ' << y1 << " 0\n  vertex "
        << x2 << ' ' << y2 << " 0\n endloop\nendfacet\n";
  };
  const auto at = [&](int i) { return -half + 2.0 * half * i / n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      triangle(at(i), at(j), at(i + 1), at(j), at(i + 1), at(j + 1));
      triangle(at(i), at(j), at(i + 1), at(j + 1), at(i), at(j + 1));
    }
  }
  out << "endsolid plate\n";
}

namespace {

/// How to start LIGGGHTS, to be followed by its options.
std::string program_line(LiggghtsCase::Program program) {
  switch (program) {
    case LiggghtsCase::Program::launcher:
      return "'" POWDERLINK_LAUNCHER "'";
    case LiggghtsCase::Program::preload:
      return "env LD_PRELOAD='" POWDERLINK_STYLES "' '" LIGGGHTS_PROGRAM "'";
    default:
      return "'" LIGGGHTS_PROGRAM "'";
  }
}

}  // namespace

Outcome LiggghtsCase::execute(const std::string& command) const {
  // Open MPI refuses root without being told; containers run as root.
  const std::string line =
      "cd '" + folder_.string() +
      "' && env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout " +
      std::to_string(kSecondsPerRun) + " " + command + " > screen.txt 2>&1 < /dev/null";
  const int raw = std::system(line.c_str());
  Outcome outcome;
  outcome.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  outcome.output = read(folder_ / "screen.txt");
  outcome.folder = folder_;
  return outcome;
}

Outcome LiggghtsCase::help() const { return execute("'" POWDERLINK_LAUNCHER "' -h"); }

Outcome LiggghtsCase::run(const std::string& script, int ranks, Program program,
                          const std::string& options) const {
  write("in.script", script);
  std::string command;
  if (ranks > 1) {
    command =
        "mpirun --oversubscribe --mca mpi_yield_when_idle 1 -np " + std::to_string(ranks) + " ";
  }
  Outcome outcome = execute(command + program_line(program) + " -in in.script " + options);
  if (fs::exists(folder_ / "last.dump")) outcome.last = read_last_dump(folder_ / "last.dump");
  return outcome;
}

Outcome LiggghtsCase::couple(const std::string& script, const Coupled& how) const {
  write("in.script", script);
  const std::string mpirun = "mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1";
  const auto program = [](int ranks, const std::string& line) {
    return " -np " + std::to_string(ranks) + " " + line;
  };
  const std::string line = program_line(how.program) + " -in in.script " + how.options;
  const std::string dem = program(
      how.dem_ranks, how.before.empty() ? line : "sh -c \"" + how.before + "; exec " + line + "\"");
  std::string solver =
      program(how.solver_ranks, "'" POWDERLINK_FAKE_SOLVER "' case=" + folder_.filename().string() +
                                    " " + how.solver);
  if (!how.socket) return execute(mpirun + dem + " :" + solver);
  solver += " socket=meet";
  std::string solvers = mpirun + solver + " > solver.txt 2>&1";
  for (int run = 1; run < how.solver_runs; ++run) {
    solvers += " && " + mpirun + solver + " >> solver.txt 2>&1";
  }
  write("couple.sh", "{ " + solvers + "; } &\nsolver=$!\n" + mpirun + dem +
                         "\nstatus=$?\nwait $solver || test $status -ne 0 || status=99\n"
                         "cat solver.txt\nexit $status\n");
  return execute("sh couple.sh");
}

std::string header(const Setting& s, const std::string& data_file) {
  std::ostringstream out;
  out << std::setprecision(17)
      << "units si\natom_style granular\natom_modify map array\nboundary m m m\n"
      << "newton off\ncommunicate single vel yes\nhard_particles yes\n";
  if (!data_file.empty()) out << "read_data " << data_file << '\n';
  out << "neighbor " << s.skin << " bin\nneigh_modify delay 0\n"
      << "fix m1 all property/global youngsModulus peratomtype " << s.youngs_modulus[0] << ' '
      << s.youngs_modulus[1] << "\nfix m2 all property/global poissonsRatio peratomtype "
      << s.poissons_ratio[0] << ' ' << s.poissons_ratio[1];
  const auto matrix = [&](const char* id, const char* name, double same, double other) {
    out << "\nfix " << id << " all property/global " << name << " peratomtypepair 2 " << same << ' '
        << other << ' ' << other << ' ' << same;
  };
  matrix("m3", "coefficientRestitution", s.restitution, s.restitution);
  matrix("m4", "workOfAdhesion", s.work_of_adhesion_same, s.work_of_adhesion);
  matrix("m5", "coefficientFriction", s.friction, s.friction);
  matrix("m6", "coefficientRollingFriction", s.rolling_friction, s.rolling_friction);
  out << "\npair_style gran model " << s.model << s.model_options << "\npair_coeff * *\ntimestep "
      << s.time_step << '\n';
  return out.str();
}

std::string primitive_plate(const Setting& s) {
  return "fix plate all wall/gran model " + s.model + s.model_options +
         " primitive type 2 zplane 0.0\n";
}

std::string mesh_plate(const Setting& s) {
  return "fix cad all mesh/surface file plate.stl type 2 precision 1e-12\n"
         "fix plate all wall/gran model " +
         s.model + s.model_options + " mesh n_meshes 1 meshes cad\n";
}

std::string dump_line(long every) {
  return "dump last all custom " + std::to_string(every) +
         " last.dump id x y z vx vy vz omegax omegay omegaz\n"
         "dump_modify last sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g "
         "%.17g\"\n";
}

std::string run_lines(long steps) {
  return "fix integrate all nve/sphere\n" + dump_line(steps) + "thermo " + std::to_string(steps) +
         "\nrun " + std::to_string(steps) + "\n";
}

}  // namespace powderlink::testing
