// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_case.h
/// Files of a coupled case as LIGGGHTS and OpenFOAM write them.
#pragma once

#include <fmt/format.h>

#include <cstdlib>

#include "analysis/flow/run/particle_dump.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {

inline std::string dump_text(long step, const std::vector<DumpParticle>& particles) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 1\n"
      "ITEM: ATOMS id type x y z vx vy vz radius mass \n",
      step, particles.size());
  for (const DumpParticle& p : particles) {
    text += fmt::format("{} 1 {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} \n", p.id,
                        p.x_m, p.y_m, p.z_m, p.vx_m_s, p.vy_m_s, p.vz_m_s, p.radius_m, p.mass_kg);
  }
  return text;
}

/// Skips a test that reads dictionaries where OpenFOAM's libraries were not there at the build.
#define POWDERLINK_NEEDS_FOAM() \
  if (std::getenv("POWDERLINK_FOAM") == nullptr) GTEST_SKIP() << "built without OpenFOAM"

/// Writes into folders that are made on the way.
inline void write_in(const TestFolder& folder, const std::string& name, const std::string& text) {
  std::filesystem::create_directories((folder.path() / name).parent_path());
  folder.write(name, text);
}

constexpr double kStreamSpacing_m = 1e-4, kStreamSpeed_m_s = 3.0, kStreamMass_kg = 1e-9;
constexpr double kStreamLength_m = 0.3, kStreamTimeStep_s = 1e-6;
/// One particle of mass m every d at speed v: m v/d passes any place.
constexpr double kStreamFlow_kg_s = kStreamMass_kg * kStreamSpeed_m_s / kStreamSpacing_m;
constexpr int kStreamParticles = 3000;

/// The uniform stream after `step` steps; it enters as it leaves.
inline std::vector<DumpParticle> stream_at(long step) {
  std::vector<DumpParticle> particles;
  const double shift =
      std::fmod(kStreamSpeed_m_s * kStreamTimeStep_s * static_cast<double>(step), kStreamSpacing_m);
  for (int i = 0; i < kStreamParticles; ++i) {
    DumpParticle p;
    p.id = i + 1;
    p.z_m = kStreamSpacing_m * (i + 0.25) + shift;
    p.y_m = 1e-5 * (i % 11 - 5);
    p.vz_m_s = kStreamSpeed_m_s;
    p.radius_m = 3e-5;
    p.mass_kg = kStreamMass_kg;
    particles.push_back(p);
  }
  return particles;
}

constexpr double kSlope_m_s2 = 17584.0, kDensity_kg_m3 = 1.6355;

/// Kinematic pressure that falls linearly beyond 0.2 m, faster before; a shaking that a whole
/// number of rows averages out.
inline std::string probe_text(double from_s, double until_s, double offset = 0.0) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += fmt::format("# Probe {} (0 0 {:g})\n", i, 0.005 + 0.01 * i);
  text += "#       Probe 0 1\n#        Time\n";
  const int rows = static_cast<int>(std::lround((until_s - from_s) / 1e-4));
  for (int k = 1; k <= rows; ++k) {
    text += fmt::format("{:.9g}", from_s + 1e-4 * k);
    for (int i = 0; i < 30; ++i) {
      const double z = 0.005 + 0.01 * i;
      const double p = kSlope_m_s2 * (0.3 - z) + (z < 0.2 ? 5e4 * (0.2 - z) : 0.0);
      text += fmt::format(" {:.12g}", p + offset + (k % 2 == 0 ? 50.0 : -50.0) * (i % 3));
    }
    text += "\n";
  }
  return text;
}

/// 61 states 0.5 ms apart, 0.03 s of probes, a log that spends 4 s per simulated ms.
inline void write_stream_case(const TestFolder& folder) {
  for (long step = 0; step <= 30000; step += 500) {
    write_in(folder, fmt::format("post/particles_{}.dump", step), dump_text(step, stream_at(step)));
  }
  write_in(folder, "in.pipe", "units si\ntimestep 1e-6 # seconds\n");
  write_in(folder, "postProcessing/axis/0/p", probe_text(0.0, 0.03));
  write_in(folder, "constant/transportProperties", "nu 1.38e-5;\nrho [1 -3 0 0 0 0 0] 1.6355;\n");
  std::string log;
  for (int i = 1; i <= 30; ++i) {
    log += fmt::format("Time = {:g}\n\nExecutionTime = {:.2f} s  ClockTime = {} s\n", 1e-3 * i,
                       3.0 * i, 4 * i);
  }
  write_in(folder, "log.mpirun", log + "Coupling share: 6.4 %\nEnd\n");
}

}  // namespace powderlink::analysis
