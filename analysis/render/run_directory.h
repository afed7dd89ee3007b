// SPDX-License-Identifier: GPL-3.0-or-later
/// \file run_directory.h
/// What a drop-test run leaves behind:
///   post/particles_<step>.vtp            LIGGGHTS, dump custom/vtk
///   post/plate_<step>.vtp|.vtk|.stl      LIGGGHTS, dump mesh/vtk or mesh/stl; only of a mesh plate
///   kat_results.json                     critical diameter, impact velocity, time step, particles
/// The particles hang below the plate (z < plate) and leave downwards; without a mesh the plate is
/// z = 0. Tests: tests/analysis/render/series_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace powderlink::render {

/// One dumped file.
struct DumpFile {
  long step = 0;
  std::filesystem::path path;
};

/// One particle at the end of the run.
struct ParticleResult {
  double diameter_m = 0.0;
  bool attached = false;
  double speed_m_s = 0.0;  ///< away from the plate
};

/// kat_results.json; what the file does not give is empty.
struct RunResults {
  std::optional<double> critical_diameter_m, impact_velocity_m_s, time_step_s;
  std::vector<ParticleResult> particles;
};

struct RunDirectory {
  std::filesystem::path path;
  std::vector<DumpFile> particles;  ///< by step, never empty
  std::vector<DumpFile> plate;      ///< by step, empty for the plane z = 0
  RunResults results;
  std::optional<double> time_step_s;  ///< the option if given, else that of kat_results.json

  /// Physical time of a step [s]; refuses when no time step is known.
  double time_s(long step) const;
};

/// Reads kat_results.json; a folder without the file gives empty results.
RunResults read_results(const std::filesystem::path& run);

/// Lists a run's files. \param time_step_s  the user's option; must be positive when given.
RunDirectory open_run(const std::filesystem::path& run, std::optional<double> time_step_s = {});

}  // namespace powderlink::render
