// SPDX-License-Identifier: GPL-3.0-or-later
/// \file couple_bridge_case.h
/// Scripts and output of small coupled cases.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "liggghts_case.h"

namespace powderlink::testing {

constexpr double kStep = 1e-6;
constexpr int kEvery = 10;
constexpr double kDensity = 8000.0;
constexpr double kDiameter = 100e-6;

/// Text of a number that keeps its digits.
inline std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

inline double sphere_mass(double diameter) {
  return kDensity * 3.14159265358979323846 / 6.0 * diameter * diameter * diameter;
}

inline Setting soft_spheres(const std::string& model = "hertz") {
  Setting s;
  s.model = model;
  s.model_options = " tangential history";
  s.youngs_modulus[0] = s.youngs_modulus[1] = 1e8;
  s.restitution = 0.7;
  s.work_of_adhesion = s.work_of_adhesion_same = 1e-3;
  s.skin = 2e-5;
  s.time_step = kStep;
  return s;
}

inline Sphere grain(double x, double y = 0.0, double z = 0.0) {
  Sphere s;
  s.diameter = kDiameter;
  s.density = kDensity;
  s.x[0] = x;
  s.x[1] = y;
  s.x[2] = z;
  return s;
}

inline const char* kGas = "fix integrate all nve/sphere\nfix gas all couple/bridge every 10\n";

inline std::string dump_lines(int every) {
  return "dump d all custom " + std::to_string(every) +
         " all.dump id x y z vx vy vz omegaz radius f_couplingStep[1] f_fluidVelocity[1] "
         "f_fluidVelocity[2] f_dragCoefficient f_pressureForce[3] f_fluidForce[1] "
         "f_reactionImpulse[1]\ndump_modify d sort id format \"%d" +
         [] {
           std::string formats;
           for (int i = 0; i < 15; ++i) formats += " %.17g";
           return formats;
         }() +
         "\"\n";
}

/// Columns of dump_lines() behind the id.
enum Column {
  kX,
  kY,
  kZ,
  kVx,
  kVy,
  kVz,
  kSpinZ,
  kRadius,
  kState,
  kWindX,
  kWindY,
  kDrag,
  kPressZ,
  kForceX,
  kImpulseX
};

using Snapshot = std::map<long, std::vector<double>>;

/// By step.
inline std::map<long, Snapshot> read_dump(const std::filesystem::path& file) {
  std::map<long, Snapshot> all;
  std::ifstream in(file);
  std::string line;
  long step = 0;
  while (std::getline(in, line)) {
    if (line == "ITEM: TIMESTEP") {
      in >> step;
      all[step];
    }
    if (line.rfind("ITEM: ATOMS", 0) != 0) continue;
    while (in.peek() != 'I' && std::getline(in, line)) {
      std::istringstream words(line);
      long id = 0;
      words >> id;
      std::vector<double> row;
      for (double value = 0.0; words >> value;) row.push_back(value);
      all[step][id] = row;
    }
  }
  return all;
}

/// Rows of the fake solver's log: step, time, particles, sum of reaction impulses.
inline std::vector<std::vector<double>> read_log(const std::filesystem::path& file) {
  std::vector<std::vector<double>> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    rows.emplace_back();
    for (double value = 0.0; words >> value;) rows.back().push_back(value);
  }
  return rows;
}

inline std::string interval() { return "interval=1e-5 "; }

/// One grain in a gas.
inline std::map<long, Snapshot> run_grain(const LiggghtsCase& c, const std::string& more,
                                          const std::string& solver, int steps,
                                          const Sphere& sphere = grain(0.0)) {
  c.write_spheres("spheres.data", {sphere}, 1e-2);
  const Outcome o = c.couple(header(soft_spheres(), "spheres.data") + more + kGas + dump_lines(1) +
                                 "run " + std::to_string(steps) + "\n",
                             {interval() + solver});
  EXPECT_EQ(o.status, 0) << o.output;
  return read_dump(c.folder() / "all.dump");
}

}  // namespace powderlink::testing
