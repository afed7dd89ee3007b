// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/text.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace powderlink::render {
namespace {

struct Run {
  std::string text;
  bool below = false, italic = false;
};

std::vector<Run> split(const std::string& text) {
  std::vector<Run> runs(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool special = (text[i] == '_' || text[i] == '~') && i + 1 < text.size();
    if (special) {
      runs.push_back({std::string(1, text[i + 1]), text[i] == '_', text[i] == '~'});
      runs.emplace_back();
      ++i;
    } else {
      runs.back().text += text[i];
    }
  }
  return runs;
}

void style(vtkTextProperty* property, const Run& run, double size_px, bool bold) {
  property->SetFontFamilyToArial();
  property->SetFontSize(static_cast<int>(std::lround(run.below ? 0.72 * size_px : size_px)));
  property->SetBold(bold ? 1 : 0);
  property->SetItalic(run.italic ? 1 : 0);
  property->SetColor(kInk[0], kInk[1], kInk[2]);
  property->SetVerticalJustificationToBottom();
  property->UseTightBoundingBoxOff();
}

/// Advance of a text. A bounding box leaves out blanks at the ends: they are measured between bars.
double width_px(const std::string& text, const Run& run, double size_px, bool bold) {
  vtkNew<vtkTextProperty> property;
  style(property, run, size_px, bold);
  const auto measure = [&](const std::string& part) {
    int box[4] = {0, 0, 0, 0};
    vtkTextRenderer::GetInstance()->GetBoundingBox(property, part, box, 72);
    return static_cast<double>(box[1] - box[0] + 1);
  };
  return measure("|" + text + "|") - measure("||");
}

}  // namespace

void draw_text(vtkRenderer* layer, const std::string& text, Pixel at, double size_px, Align align,
               bool bold) {
  const auto runs = split(text);
  double total = 0.0;
  for (const Run& run : runs) total += width_px(run.text, run, size_px, bold);
  double x = at.x;
  if (align == Align::centre) x -= 0.5 * total;
  if (align == Align::right) x -= total;
  for (const Run& run : runs) {
    const double advance = width_px(run.text, run, size_px, bold);
    const auto lead = run.text.find_first_not_of(' ');
    if (lead != std::string::npos) {
      vtkNew<vtkTextActor> actor;
      actor->SetInput(run.text.substr(lead).c_str());
      style(actor->GetTextProperty(), run, size_px, bold);
      actor->SetTextScaleModeToNone();
      actor->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
      actor->SetPosition(x + width_px(run.text.substr(0, lead), run, size_px, bold),
                         at.y - (run.below ? 0.18 * size_px : 0.0));
      layer->AddActor2D(actor);
    }
    x += advance;
  }
}

void draw_polygon(vtkRenderer* layer, const std::vector<Pixel>& corners,
                  const std::vector<Colour>& colours) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetNumberOfComponents(3);
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    cells->InsertCellPoint(points->InsertNextPoint(corners[i].x, corners[i].y, 0.0));
    const Colour& c = colours[std::min(i, colours.size() - 1)];
    paint->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(paint);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  layer->AddActor2D(actor);
}

void draw_line(vtkRenderer* layer, Pixel from, Pixel to, double width_px) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length == 0.0) return;
  const double nx = -0.5 * width_px * (to.y - from.y) / length;
  const double ny = 0.5 * width_px * (to.x - from.x) / length;
  draw_polygon(layer,
               {{from.x + nx, from.y + ny},
                {to.x + nx, to.y + ny},
                {to.x - nx, to.y - ny},
                {from.x - nx, from.y - ny}},
               {kInk});
}

}  // namespace powderlink::render
