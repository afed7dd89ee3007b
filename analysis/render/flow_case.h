// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_case.h
/// A coupled case for the eye: particles of post/particles_*.dump, gas of the OpenFOAM case (serial,
/// else processor*), both on the clock of the gas (analysis/flow/run/particle_clock.h).
/// Tests: tests/analysis/render/flow_test.cpp
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/flow/run/particle_dump.h"

namespace powderlink::render {

struct DumpAtTime {
  double time_s = 0.0;
  std::filesystem::path file;
};

/// All dumps with their times on the clock of the gas.
/// \param time_step_s  of the DEM; empty: the case's own
std::vector<DumpAtTime> dumps_with_times(const std::filesystem::path& case_folder,
                                         std::optional<double> time_step_s);

/// Points with id, radius_m, diameter_um, mass_kg, velocity_m_s and speed_m_s.
vtkSmartPointer<vtkPolyData> particles_of(const analysis::DumpState& state);

/// The gas in a plane at the written time nearest to `time_s`; point array `U`.
struct GasSlice {
  double time_s = 0.0;
  vtkSmartPointer<vtkPolyData> plane;
};

/// Empty when the case has no mesh or no time folder. Throws when U cannot be read.
/// \param place_m  of the plane on the axis 0, 1 or 2 that is normal to it
std::optional<GasSlice> read_gas_slice(const std::filesystem::path& case_folder, double time_s,
                                       double place_m, std::size_t normal = 0);

/// Makes CASE/case.foam, the empty file by which ParaView opens a case; returns its name.
std::filesystem::path make_foam_file(const std::filesystem::path& case_folder);

}  // namespace powderlink::render
