// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_frame.h
/// One dumped state of the particles, with readable names instead of LIGGGHTS's:
///   radius -> radius_m, diameter_um      v -> velocity_m_s      f -> force_N (if dumped)
///   f_kat[1] -> attached (1/0)   f_kat[2] -> speed_m_s (away from the plate)
///   f_kat[3] -> contact_radius_um
/// LIGGGHTS joins three columns of a fix into one vector f_kat[1-3]; both spellings are read.
/// All other arrays keep their names.
/// Tests: tests/analysis/render/series_test.cpp, tests/analysis/render/bad_input_test.cpp
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

namespace powderlink::render {

/// Reads a .vtp file and refuses damaged ones.
vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& path);

/// The state with readable array names. \param fix  id of the `fix kat/drop` in the input script
vtkSmartPointer<vtkPolyData> read_particles(const std::filesystem::path& path,
                                            const std::string& fix = "kat");

/// What a picture needs of one particle; lengths in um.
struct Grain {
  long id = 0;
  double x_um = 0.0, y_um = 0.0, z_um = 0.0, diameter_um = 0.0, speed_m_s = 0.0;
  bool attached = false;
};

/// The grains of a state from read_particles.
std::vector<Grain> grains_of(vtkPolyData* particles);

}  // namespace powderlink::render
