// SPDX-License-Identifier: GPL-3.0-or-later
/// \file legend.h
/// Scale bar and colour key of a picture.
/// Tests: tests/analysis/render/frame_choice_test.cpp, tests/analysis/render/picture_test.cpp
#pragma once

#include "analysis/render/text.h"

namespace powderlink::render {

/// The largest of 1, 2, 5 times a power of ten that is not above `limit`.
double round_length(double limit);

/// The smallest of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten that is not below `largest`.
double round_scale(double largest);

/// Intervals of a scale from round_scale, so that every tick is a round number.
int scale_ticks(double scale);

/// Bar of a round length, its right end at `right`; `limit_px` bounds its length.
void draw_scale_bar(vtkRenderer* layer, Pixel right, double pixels_per_um, double limit_px,
                    double text_px);

/// Ramp of colours over 0 ... scale with ticks and a title above it.
/// \param colour  of a fraction 0 ... 1 of the scale
void draw_ramp(vtkRenderer* layer, Pixel left, double width_px, double scale, double text_px,
               Colour (*colour)(double), const std::string& title);

/// Disc for the attached grains, ramp with ticks for the speed of the leaving ones.
void draw_colour_key(vtkRenderer* layer, Pixel left, double width_px, double speed_scale,
                     double text_px);

}  // namespace powderlink::render
