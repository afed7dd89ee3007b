// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/legend.h"

#include <fmt/format.h>

#include <cmath>

namespace powderlink::render {

double round_length(double limit) {
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= limit * (1.0 + 1e-9)) return step * decade;
  }
  return decade;
}

double round_scale(double largest) {
  if (!(largest > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(largest)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (largest <= step * decade * (1.0 + 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

int scale_ticks(double scale) {
  const double leading = scale / std::pow(10.0, std::floor(std::log10(scale * (1.0 + 1e-9))));
  if (leading < 1.25) return 5;
  if (leading < 1.75) return 3;
  if (leading > 5.5) return 4 - (leading < 7.0 ? 1 : 0);
  return static_cast<int>(std::lround(leading)) * (leading < 2.5 ? 2 : 1);
}

void draw_scale_bar(vtkRenderer* layer, Pixel right, double pixels_per_um, double limit_px,
                    double text_px) {
  const double length_um = round_length(limit_px / pixels_per_um);
  const double left = right.x - length_um * pixels_per_um;
  const double thick = 0.16 * text_px, tick = 0.28 * text_px;
  draw_line(layer, {left, right.y}, right, thick);
  for (const double x : {left + 0.5 * thick, right.x - 0.5 * thick}) {
    draw_line(layer, {x, right.y - tick}, {x, right.y + tick}, thick);
  }
  const bool millimetres = length_um >= 1000.0;
  draw_text(layer,
            millimetres ? fmt::format("{:g} mm", 1e-3 * length_um)
                        : fmt::format("{:g} \u00b5m", length_um),
            {0.5 * (left + right.x), right.y + 0.42 * text_px}, text_px, Align::centre);
}

void draw_ramp(vtkRenderer* layer, Pixel left, double width_px, double scale, double text_px,
               Colour (*colour)(double), const std::string& title) {
  const double height = 0.9 * text_px;
  constexpr int kParts = 60;
  for (int i = 0; i < kParts; ++i) {
    const double a = static_cast<double>(i) / kParts, b = static_cast<double>(i + 1) / kParts;
    const Colour from = colour(a), to = colour(b);
    draw_polygon(layer,
                 {{left.x + a * width_px, left.y},
                  {left.x + b * width_px, left.y},
                  {left.x + b * width_px, left.y + height},
                  {left.x + a * width_px, left.y + height}},
                 {from, to, to, from});
  }
  const int ticks = scale_ticks(scale);
  for (int i = 0; i <= ticks; ++i) {
    const double x = left.x + width_px * i / ticks;
    draw_line(layer, {x, left.y - 0.25 * text_px}, {x, left.y}, 0.08 * text_px);
    draw_text(layer, fmt::format("{:g}", scale * i / ticks), {x, left.y - 1.35 * text_px},
              0.88 * text_px, Align::centre);
  }
  draw_text(layer, title, {left.x + 0.5 * width_px, left.y + 1.35 * height}, text_px,
            Align::centre);
}

void draw_colour_key(vtkRenderer* layer, Pixel left, double width_px, double speed_scale,
                     double text_px) {
  const double height = 0.9 * text_px;
  std::vector<Pixel> disc;
  constexpr int kCorners = 48;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / kCorners;
    disc.push_back({left.x + 0.5 * height * (1.0 + std::cos(angle)),
                    left.y + 0.5 * height * (1.0 + std::sin(angle))});
  }
  draw_polygon(layer, disc, {kAttached});
  draw_text(layer, "attached", {left.x + 1.5 * height, left.y}, text_px);

  draw_ramp(layer, {left.x + 7.2 * text_px, left.y}, width_px - 7.2 * text_px, speed_scale, text_px,
            leaving_colour, "detached: speed away from the plate (m/s)");
}

}  // namespace powderlink::render
