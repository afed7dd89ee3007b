// SPDX-License-Identifier: GPL-3.0-or-later
/// \file plate.h
/// The plate that carries the particles: a dumped mesh, or a thin box above the plane z = 0.
/// Tests: tests/analysis/render/series_test.cpp
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

#include "analysis/render/run_directory.h"

namespace powderlink::render {

/// A box whose lower face lies in z = `z`; lengths in the unit of the scene.
vtkSmartPointer<vtkPolyData> plate_box(double x_min, double x_max, double y_min, double y_max,
                                       double z, double thickness);

/// Box above z = 0 that overhangs the particles [m].
vtkSmartPointer<vtkPolyData> plate_above(vtkPolyData* particles);

/// Surface of a dumped mesh: .vtp, .vtk or .stl [m].
vtkSmartPointer<vtkPolyData> read_plate(const std::filesystem::path& path);

/// The mesh dumped at a step or last before it; nullptr when the plate is the plane z = 0.
const DumpFile* plate_at(const RunDirectory& run, long step);

/// Height of the plate's lower face at a step [m].
double plate_height_m(const RunDirectory& run, long step);

}  // namespace powderlink::render
