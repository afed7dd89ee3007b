// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gl_context.h
/// An OpenGL context without display, window or graphics card: EGL's surfaceless platform, else a
/// device, else EGL's default display. Debian's VTK knows X11 windows only, so the context is made
/// here and handed to VTK's generic window. Mesa's software renderer is asked for, unless
/// LIBGL_ALWAYS_SOFTWARE is set already: it is everywhere, and the same picture comes out
/// everywhere. Tests: tests/analysis/render/picture_test.cpp
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

class vtkRenderWindow;

namespace powderlink::render {

class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// A window of VTK that draws into memory; must not outlive the context.
  vtkSmartPointer<vtkRenderWindow> make_window(int width_px, int height_px) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace powderlink::render
