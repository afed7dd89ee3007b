// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/render/palette.h"
#include "analysis/render/plate.h"

namespace powderlink::render {
namespace {

constexpr double kViewAngleDeg = 18.0;
constexpr double kBelowPlateDeg = 17.0;  ///< the camera looks up at the carrying face

double plate_thickness_um(const ViewWindow& window) { return 0.045 * window.width_um; }

vtkSmartPointer<vtkActor> grain_actor(const std::vector<Grain>& grains, double speed_scale) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> diameter;
  diameter->SetName("diameter");
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("colour");
  colour->SetNumberOfComponents(3);
  for (const Grain& grain : grains) {
    points->InsertNextPoint(grain.x_um, grain.y_um, grain.z_um);
    diameter->InsertNextValue(grain.diameter_um);
    const Colour c = grain.attached ? kAttached : leaving_colour(grain.speed_m_s / speed_scale);
    colour->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(diameter);
  data->GetPointData()->SetScalars(colour);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray("diameter");
  mapper->SetScalarModeToUsePointData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.22);
  actor->GetProperty()->SetDiffuse(0.78);
  actor->GetProperty()->SetSpecular(0.35);
  actor->GetProperty()->SetSpecularPower(28.0);
  return actor;
}

/// Soft dark spots on the plate where grains sit close to it: the eye sees who touches.
vtkSmartPointer<vtkActor> shade_actor(const std::vector<Grain>& grains, const State& state,
                                      const ViewWindow& window) {
  constexpr int kCorners = 32;
  constexpr std::array<std::array<double, 2>, 3> kRings{{{0.6, 1.0}, {1.1, 0.35}, {1.7, 0.0}}};
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetNumberOfComponents(4);
  const double z = state.plate_z_um - 0.0015 * window.width_um;
  const auto add_corner = [&](double x, double y, double opacity) {
    paint->InsertNextTuple4(15.0, 18.0, 25.0, 255.0 * opacity);
    return points->InsertNextPoint(x, y, z);
  };
  for (const Grain& grain : grains) {
    const double radius = 0.5 * grain.diameter_um;
    const double gap = std::max(0.0, state.plate_z_um - grain.z_um - radius);
    const double darkness = 0.55 * (1.0 - gap / radius);
    if (darkness <= 0.02) continue;
    const vtkIdType centre = add_corner(grain.x_um, grain.y_um, darkness);
    vtkIdType first_of_ring = centre;
    for (std::size_t ring = 0; ring < kRings.size(); ++ring) {
      const vtkIdType inner = first_of_ring;
      first_of_ring = points->GetNumberOfPoints();
      for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * vtkMath::Pi() * i / kCorners, r = kRings[ring][0] * radius;
        add_corner(grain.x_um + r * std::cos(angle), grain.y_um + r * std::sin(angle),
                   kRings[ring][1] * darkness);
      }
      for (int i = 0; i < kCorners; ++i) {
        const vtkIdType a = first_of_ring + i, b = first_of_ring + (i + 1) % kCorners;
        if (ring == 0) {
          cells->InsertNextCell({centre, a, b});
        } else {
          cells->InsertNextCell({inner + i, a, b, inner + (i + 1) % kCorners});
        }
      }
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(paint);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->ForceTranslucentOn();
  return actor;
}

vtkSmartPointer<vtkActor> plate_actor(const State& state, const ViewWindow& window) {
  const double margin = 0.05 * window.width_um;
  const double half_x = 0.5 * window.width_um + margin, half_y = 0.5 * window.breadth_um + margin;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(plate_box(window.x_um - half_x, window.x_um + half_x, window.y_um - half_y,
                                 window.y_um + half_y, state.plate_z_um,
                                 plate_thickness_um(window)));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  auto* look = actor->GetProperty();
  look->SetColor(kPlate[0], kPlate[1], kPlate[2]);
  look->SetAmbient(0.70);
  look->SetDiffuse(0.45);
  look->SetSpecular(0.25);
  look->SetSpecularPower(12.0);
  look->EdgeVisibilityOn();
  look->SetEdgeColor(0.45, 0.46, 0.48);
  look->SetLineWidth(2.0);
  return actor;
}

void add_light(vtkRenderer* scene, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;  // camera light: x right, y up, z towards the viewer
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  scene->AddLight(light);
}

void place_camera(vtkRenderer* scene, const State& state, const ViewWindow& window, double aspect) {
  const double margin = 0.11 * window.width_um;
  const double angle = vtkMath::RadiansFromDegrees(kBelowPlateDeg);
  const double thickness = plate_thickness_um(window);
  // What has to fit: the near, wider edge of the plate, and from its far edge down to the depth.
  const double width = window.width_um + 2.0 * margin;
  const double height = (window.depth_um + thickness) * std::cos(angle) +
                        0.5 * window.breadth_um * std::sin(angle) + margin;
  const double half_angle = 0.5 * vtkMath::RadiansFromDegrees(kViewAngleDeg);
  const double distance =
      0.5 * std::max(height, width / aspect) / std::tan(half_angle) + 0.5 * window.breadth_um;
  const double centre_z = state.plate_z_um + thickness - 0.5 * (window.depth_um + thickness) +
                          0.25 * window.breadth_um * std::sin(angle);
  vtkCamera* camera = scene->GetActiveCamera();
  camera->SetViewAngle(kViewAngleDeg);
  camera->SetFocalPoint(window.x_um, window.y_um, centre_z);
  camera->SetPosition(window.x_um, window.y_um - distance * std::cos(angle),
                      centre_z - distance * std::sin(angle));
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene->ResetCameraClippingRange();
}

}  // namespace

vtkSmartPointer<vtkRenderer> make_scene(const State& state, const State& before,
                                        const ViewWindow& window, double speed_scale,
                                        double aspect) {
  auto scene = vtkSmartPointer<vtkRenderer>::New();
  scene->SetBackground(1.0, 1.0, 1.0);
  scene->AutomaticLightCreationOff();
  scene->AddActor(plate_actor(state, window));
  const auto grains = grains_in(state, before, window);
  scene->AddActor(shade_actor(grains, state, window));
  scene->AddActor(grain_actor(grains, speed_scale));
  add_light(scene, -0.6, 0.5, 1.0, 0.75);
  add_light(scene, 0.7, -0.3, 0.8, 0.30);
  add_light(scene, 0.0, -1.0, 0.3, 0.15);
  place_camera(scene, state, window, aspect);
  return scene;
}

double pixels_per_um(vtkRenderer* scene, const State& state, const ViewWindow& window) {
  double pixel[2];
  for (int end = 0; end < 2; ++end) {
    scene->SetWorldPoint(window.x_um + (end == 0 ? -0.5 : 0.5) * window.width_um, window.y_um,
                         state.plate_z_um, 1.0);
    scene->WorldToDisplay();
    pixel[end] = scene->GetDisplayPoint()[0];
  }
  return (pixel[1] - pixel[0]) / window.width_um;
}

}  // namespace powderlink::render
