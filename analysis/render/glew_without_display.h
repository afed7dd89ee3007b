// SPDX-License-Identifier: GPL-3.0-or-later
/// \file glew_without_display.h
/// Debian's GLEW loads all OpenGL functions first and then reports "no X display" when the context
/// comes from EGL; VTK takes that report for a failure and draws nothing. The program's own
/// glewInit stands before the library's, calls it, and passes everything on but that one report.
/// Tests: tests/analysis/render/picture_test.cpp
#pragma once

namespace powderlink::render {

/// Does nothing by itself: a call links the replacement into the program.
void accept_glew_without_display();

}  // namespace powderlink::render
