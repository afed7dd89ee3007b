// SPDX-License-Identifier: GPL-3.0-or-later
/// \file scene.h
/// One state in perspective: grains with their true radii, the plate above them, lights, camera.
/// Tests: tests/analysis/render/picture_test.cpp
#pragma once

#include <vtkSmartPointer.h>

#include "analysis/render/frame_choice.h"

class vtkRenderer;

namespace powderlink::render {

/// \param before       the state that says which grains are in the window
/// \param speed_scale  speed of the darkest colour [m/s]
/// \param aspect       width over height of the panel
vtkSmartPointer<vtkRenderer> make_scene(const State& state, const State& before,
                                        const ViewWindow& window, double speed_scale,
                                        double aspect);

/// Pixels per um in the middle of the window, for the scale bar.
double pixels_per_um(vtkRenderer* scene, const State& state, const ViewWindow& window);

}  // namespace powderlink::render
