// SPDX-License-Identifier: GPL-3.0-or-later
/// \file png.h
/// What a window of VTK shows, as the bytes of a PNG.
/// Tests: tests/analysis/render/picture_test.cpp
#pragma once

#include <string>

class vtkRenderWindow;

namespace powderlink::render {

constexpr int kOversampling = 2;  ///< drawn larger and averaged: smooth edges without hardware

/// The window's picture, kOversampling times smaller than the window.
std::string png_of(vtkRenderWindow* window);

}  // namespace powderlink::render
