// SPDX-License-Identifier: GPL-3.0-or-later
/// \file text.h
/// Text and flat shapes on top of the picture, in pixels from the lower left corner.
/// Tests: tests/analysis/render/picture_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/render/palette.h"

class vtkRenderer;

namespace powderlink::render {

struct Pixel {
  double x = 0.0, y = 0.0;
};

enum class Align { left, centre, right };

/// One line of text, its baseline at `at`. `_x` sets the letter x below the line, `~x` in italics.
void draw_text(vtkRenderer* layer, const std::string& text, Pixel at, double size_px,
               Align align = Align::left, bool bold = false);

/// Filled polygon; with one colour per corner they blend.
void draw_polygon(vtkRenderer* layer, const std::vector<Pixel>& corners,
                  const std::vector<Colour>& colours);

/// Line of a given width.
void draw_line(vtkRenderer* layer, Pixel from, Pixel to, double width_px);

}  // namespace powderlink::render
