// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_case.h
/// A coupled case for the eye: particles of post/particles_*.dump, gas of the OpenFOAM case (serial,
/// else processor*), both at physical times.
/// Tests: tests/render/flow_test.cpp
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/flow/particle_dump.h"

namespace powderlink::render {

struct DumpAtTime {
  double time_s = 0.0;
  std::filesystem::path file;
};

/// All dumps with their times. \param time_step_s  of the DEM; empty: the case's own
std::vector<DumpAtTime> dumps_with_times(const std::filesystem::path& case_folder,
                                         std::optional<double> time_step_s);

/// Points with id, radius_m, diameter_um, mass_kg, velocity_m_s and speed_m_s.
vtkSmartPointer<vtkPolyData> particles_of(const analysis::DumpState& state);

/// The gas in the plane x = `x_m` at the written time nearest to `time_s`; point array `U`.
struct GasSlice {
  double time_s = 0.0;
  vtkSmartPointer<vtkPolyData> plane;
};

/// Empty when the case has no mesh or no time folder. Throws when U cannot be read.
std::optional<GasSlice> read_gas_slice(const std::filesystem::path& case_folder, double time_s,
                                       double x_m);

/// Makes CASE/case.foam, the empty file by which ParaView opens a case; returns its name.
std::filesystem::path make_foam_file(const std::filesystem::path& case_folder);

}  // namespace powderlink::render
