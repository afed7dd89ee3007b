// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/flow_picture.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCleanPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/flow/run/flow_channel.h"
#include "analysis/render/flow_case.h"
#include "analysis/render/gl_context.h"
#include "analysis/render/legend.h"
#include "analysis/render/palette.h"
#include "analysis/render/png.h"
#include "analysis/render/text.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::render {

namespace {

constexpr double kStripOverHeight = 8.0;
constexpr int kStrips = 3;
constexpr double kMargin = 0.06;  // of the channel's height, above and below it
constexpr double kMicrometres = 1e6;
constexpr double kRounding = 1e-6;  // of the channel's width: points are read as float

/// Turns places so that the axis lies along z and `up` along y; a turn, not a mirror image.
class Turn {
 public:
  explicit Turn(const analysis::FlowAxis& axis)
      : axis_(axis), across_sign_(axis.index == 1 ? -1.0 : 1.0) {}
  analysis::Place operator()(const analysis::Place& p) const {
    return {across_sign_ * p.at(axis_.across()), p.at(axis_.up()), p.at(axis_.index)};
  }
  double across_sign() const { return across_sign_; }

 private:
  analysis::FlowAxis axis_;
  double across_sign_;
};

/// Everything in the picture, turned, lengths in m.
struct Content {
  double time_s = 0.0;
  char axis = 'z';
  std::vector<analysis::DumpParticle> particles;
  std::optional<GasSlice> gas;
  double x = 0.0;  ///< of the plane
  double bounds[6] = {0, 0, 0, 0, 0, 0};
  double gas_scale = 1.0, particle_scale = 1.0;
  double height() const { return bounds[3] - bounds[2]; }
};

void check(const FlowPictureOptions& o) {
  const auto refuse = [](const char* option, double given, const char* allowed) {
    throw InvalidInput(std::string("option ") + option, number_text(given), allowed,
                       "correct the option");
  };
  if (o.width_px < 400 || o.width_px > 8000) refuse("--width", o.width_px, "400 to 8000 pixels");
  if (o.length_m && !(*o.length_m > 0.0 && std::isfinite(*o.length_m))) {
    refuse("--length", *o.length_m, "a length in metres above 0");
  }
  if (o.at_m && !std::isfinite(*o.at_m)) refuse("--at", *o.at_m, "a place on the axis in metres");
}

double speed_of(const analysis::DumpParticle& p) {
  return std::hypot(p.vx_m_s, p.vy_m_s, p.vz_m_s);
}

/// A scale over which the few fastest of many do not wash out the colours of the rest.
double scale_of(std::vector<double> speeds) {
  if (speeds.empty()) return 1.0;
  const auto high =
      speeds.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), high, speeds.end());
  return round_scale(*high);
}

Content read_content(const std::filesystem::path& folder, const FlowPictureOptions& options) {
  Content c;
  const std::vector<DumpAtTime> dumps = dumps_with_times(folder, options.time_step_s);
  const DumpAtTime* best = &dumps.back();
  if (options.time_s) {
    for (const DumpAtTime& dump : dumps) {
      if (std::abs(dump.time_s - *options.time_s) < std::abs(best->time_s - *options.time_s)) {
        best = &dump;
      }
    }
  }
  c.time_s = best->time_s;
  const analysis::DumpState state = analysis::read_first_state(best->file);
  // The axis is that of the run, not of the moment.
  const analysis::FlowChannel channel =
      analysis::look_at_channel(folder, analysis::read_last_state(dumps.back().file), options.axis);
  c.axis = channel.axis.letter();
  const Turn turn(channel.axis);
  for (analysis::DumpParticle p : state.particles) {
    const analysis::Place at = turn(analysis::place_of(p));
    p.x_m = at[0], p.y_m = at[1], p.z_m = at[2];
    c.particles.push_back(p);
  }
  std::vector<double> speeds;
  bool first = true;
  for (const analysis::DumpParticle& p : c.particles) {
    const double place[3] = {p.x_m, p.y_m, p.z_m};
    for (int axis = 0; axis < 3; ++axis) {
      double* range = c.bounds + static_cast<std::ptrdiff_t>(2) * axis;
      range[0] = first ? place[axis] - p.radius_m : std::min(range[0], place[axis] - p.radius_m);
      range[1] = first ? place[axis] + p.radius_m : std::max(range[1], place[axis] + p.radius_m);
    }
    first = false;
    speeds.push_back(speed_of(p));
  }
  c.particle_scale = scale_of(speeds);
  // A plane in the middle of the mesh, or of the particles where the mesh is not known.
  const std::size_t across = channel.axis.across();
  c.x = 0.5 * (c.bounds[0] + c.bounds[1]);
  if (channel.mesh) {
    const double low = channel.mesh->low_m.at(across), high = channel.mesh->high_m.at(across);
    c.x = turn.across_sign() * 0.5 * (low + high);
    if (std::abs(c.x) < kRounding * (high - low)) c.x = 0.0;
  }
  c.gas = read_gas_slice(folder, c.time_s, turn.across_sign() * c.x, across);
  if (c.gas && c.gas->plane->GetNumberOfPoints() == 0) c.gas.reset();
  if (c.gas) {
    vtkPoints* points = c.gas->plane->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
      const double* p = points->GetPoint(i);
      const analysis::Place at = turn({p[0], p[1], p[2]});
      points->SetPoint(i, at.data());
    }
    points->Modified();
    c.gas->plane->ComputeBounds();
    c.gas->plane->GetBounds(c.bounds);
    vtkDataArray* u = c.gas->plane->GetPointData()->GetArray("U");
    std::vector<double> gas;
    for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i) {
      const double* v = u->GetTuple3(i);
      gas.push_back(std::hypot(v[0], v[1], v[2]));
    }
    c.gas_scale = scale_of(gas);
  }
  if (!c.gas && c.particles.empty()) {
    throw InvalidInput("drawing " + folder.string(),
                       fmt::format("no particle at {:g} s and no gas field U", c.time_s),
                       "a coupled case that has run", "choose another --time");
  }
  return c;
}

void add_gas(vtkRenderer* scene, const Content& c) {
  vtkPolyData* plane = c.gas->plane;
  vtkDataArray* u = plane->GetPointData()->GetArray("U");
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i) {
    const double* v = u->GetTuple3(i);
    const Colour colour = gas_colour(std::hypot(v[0], v[1], v[2]) / c.gas_scale);
    paint->InsertNextTuple3(255 * colour[0], 255 * colour[1], 255 * colour[2]);
  }
  vtkNew<vtkPolyData> painted;
  painted->CopyStructure(plane);
  painted->GetPointData()->SetScalars(paint);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(painted);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  scene->AddActor(actor);

  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(plane);
  vtkNew<vtkCleanPolyData> joined;  // no line where two processors meet
  joined->SetInputData(bare);
  joined->ToleranceIsAbsoluteOn();
  joined->SetAbsoluteTolerance(1e-6 * c.height());
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(joined->GetOutputPort());
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> wall;
  wall->SetInputConnection(edges->GetOutputPort());
  wall->ScalarVisibilityOff();
  vtkNew<vtkActor> outline;
  outline->SetMapper(wall);
  outline->GetProperty()->LightingOff();
  outline->GetProperty()->SetColor(kInk[0], kInk[1], kInk[2]);
  outline->GetProperty()->SetLineWidth(2.0F * kOversampling);
  scene->AddActor(outline);
}

void add_particles(vtkRenderer* scene, const Content& c, double from_z, double to_z) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> diameter;
  diameter->SetName("diameter");
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetNumberOfComponents(3);
  for (const analysis::DumpParticle& p : c.particles) {
    if (p.z_m + p.radius_m < from_z || p.z_m - p.radius_m > to_z) continue;
    points->InsertNextPoint(p.x_m, p.y_m, p.z_m);
    diameter->InsertNextValue(2.0 * p.radius_m);
    const Colour colour = leaving_colour(speed_of(p) / c.particle_scale);
    paint->InsertNextTuple3(255 * colour[0], 255 * colour[1], 255 * colour[2]);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(diameter);
  data->GetPointData()->SetScalars(paint);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(18);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(data);
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->ScalingOn();
  glyphs->SetScaleModeToScaleByMagnitude();
  glyphs->SetScaleArray("diameter");
  vtkNew<vtkActor> actor;
  actor->SetMapper(glyphs);
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->GetProperty()->SetSpecular(0.15);
  scene->AddActor(actor);
}

/// One strip, seen along x: z to the right, y up, so the viewer stands where x is negative.
vtkSmartPointer<vtkRenderer> make_strip(const Content& c, double from_z, double to_z) {
  auto scene = vtkSmartPointer<vtkRenderer>::New();
  scene->SetBackground(1.0, 1.0, 1.0);
  scene->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.4, 0.7, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  scene->AddLight(light);
  if (c.gas) add_gas(scene, c);
  add_particles(scene, c, from_z, to_z);
  const double y = 0.5 * (c.bounds[2] + c.bounds[3]), z = 0.5 * (from_z + to_z);
  const double distance = 4.0 * c.height() + 2.0 * std::abs(c.bounds[1] - c.bounds[0]);
  vtkCamera* camera = scene->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * c.height() * (1.0 + 2.0 * kMargin));
  camera->SetFocalPoint(c.x, y, z);
  camera->SetPosition(c.x - distance, y, z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  scene->ResetCameraClippingRange();
  return scene;
}

std::string place_text(double z_m) { return fmt::format("{:.4g}", 1e3 * z_m); }

}  // namespace

void write_flow_picture(const std::filesystem::path& folder, const std::filesystem::path& png,
                        const FlowPictureOptions& options) {
  check(options);
  const Content c = read_content(folder, options);
  const double begin = c.bounds[4], end = c.bounds[5];
  double length = std::min(options.length_m.value_or(kStripOverHeight * c.height()), end - begin);
  const int strips = options.at_m || end - begin < kStrips * length ? 1 : kStrips;
  // A channel that is too short for several strips is shown from end to end.
  if (strips == 1 && !options.at_m && !options.length_m) length = end - begin;

  // Sizes in pixels of the oversampled image.
  const double width = kOversampling * options.width_px;
  const double text = 0.0155 * width, edge = 0.02 * width;
  const double panel_width = width - 2.0 * edge;
  const double panel_height = panel_width * c.height() * (1.0 + 2.0 * kMargin) / length;
  const double caption = 1.9 * text, bottom = 5.6 * text, top = 3.2 * text;
  const double height =
      std::ceil((bottom + strips * (panel_height + caption) + top) / kOversampling) * kOversampling;
  constexpr double kTallest_px = 16000.0;
  if (!(height < kTallest_px)) {
    throw InvalidInput(
        "drawing " + folder.string(),
        fmt::format("a strip of {:g} m for a channel {:g} m high", length, c.height()),
        "pictures not much higher than wide", "give a larger --length");
  }

  const GlContext gl;
  const auto window = gl.make_window(static_cast<int>(width), static_cast<int>(height));
  window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> paper;
  paper->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(paper);
  vtkNew<vtkRenderer> layer;
  layer->SetLayer(1);
  for (int i = 0; i < strips; ++i) {
    const double free = end - begin - length;
    const double from = options.at_m ? std::clamp(*options.at_m - 0.5 * length, begin, begin + free)
                                     : begin + (strips > 1 ? free * i / (strips - 1) : 0.5 * free);
    const auto strip = make_strip(c, from, from + length);
    const double low = bottom + (strips - 1 - i) * (panel_height + caption);
    strip->SetViewport(edge / width, low / height, (width - edge) / width,
                       (low + panel_height) / height);
    window->AddRenderer(strip);
    const std::string letter = strips > 1 ? fmt::format("({})  ", static_cast<char>('a' + i)) : "";
    draw_text(layer,
              fmt::format("{}~{} = {} to {} mm", letter, c.axis, place_text(from),
                          place_text(from + length)),
              {edge, low + panel_height + 0.45 * text}, text);
  }
  window->AddRenderer(layer);
  draw_text(layer, options.title.value_or(fmt::format("~t = {:.4g} ms", 1e3 * c.time_s)),
            {0.5 * width, height - 2.1 * text}, 1.25 * text, Align::centre, true);
  const double key = 0.36 * width;
  if (c.gas) {
    draw_ramp(layer, {edge, 2.0 * text}, key, c.gas_scale, text, gas_colour, "gas: speed (m/s)");
  }
  draw_ramp(layer, {edge + 1.12 * key, 2.0 * text}, key, c.particle_scale, text, leaving_colour,
            "particles: speed (m/s)");
  draw_scale_bar(layer, {width - edge, 2.3 * text}, panel_width / (length * kMicrometres),
                 0.14 * width, text);
  window->Render();
  write_file(png, png_of(window));
}

}  // namespace powderlink::render
