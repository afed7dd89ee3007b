// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/plate.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkDataSetReader.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include "analysis/render/particle_frame.h"
#include "base/invalid_input.h"

namespace powderlink::render {
namespace {

template <class Reader>
vtkSmartPointer<vtkPolyData> surface(const std::filesystem::path& path) {
  bool failed = false;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
  observer->SetClientData(&failed);
  vtkNew<Reader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkPolyData> result;
  if (!failed && reader->GetOutput() != nullptr) {
    vtkNew<vtkGeometryFilter> outside;
    outside->SetInputData(reader->GetOutput());
    outside->Update();
    result = outside->GetOutput();
  }
  return result;
}

}  // namespace

vtkSmartPointer<vtkPolyData> plate_box(double x_min, double x_max, double y_min, double y_max,
                                       double z, double thickness) {
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x_min, x_max, y_min, y_max, z, z + thickness);
  box->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  box->Update();
  return box->GetOutput();
}

vtkSmartPointer<vtkPolyData> plate_above(vtkPolyData* particles) {
  double bounds[6] = {-1e-3, 1e-3, -1e-3, 1e-3, 0, 0}, largest_um = 100.0;
  if (particles->GetNumberOfPoints() > 0) {
    particles->GetBounds(bounds);
    double range[2];
    particles->GetPointData()->GetArray("diameter_um")->GetRange(range);
    largest_um = range[1];
  }
  const double overhang = 2e-6 * largest_um;
  return plate_box(bounds[0] - overhang, bounds[1] + overhang, bounds[2] - overhang,
                   bounds[3] + overhang, 0.0, 0.25e-6 * largest_um);
}

vtkSmartPointer<vtkPolyData> read_plate(const std::filesystem::path& path) {
  vtkSmartPointer<vtkPolyData> mesh;
  if (path.extension() == ".vtp") {
    mesh = read_vtp(path);
  } else if (path.extension() == ".stl") {
    mesh = surface<vtkSTLReader>(path);
  } else {
    mesh = surface<vtkDataSetReader>(path);
  }
  if (mesh == nullptr || mesh->GetNumberOfCells() == 0) {
    throw InvalidInput("reading " + path.string(), "a file without readable triangles",
                       "a mesh as `dump mesh/vtk` or `dump mesh/stl` writes it",
                       "run the drop test again, or remove this file");
  }
  return mesh;
}

const DumpFile* plate_at(const RunDirectory& run, long step) {
  const DumpFile* found = run.plate.empty() ? nullptr : &run.plate.front();
  for (const DumpFile& file : run.plate) {
    if (file.step <= step) found = &file;
  }
  return found;
}

double plate_height_m(const RunDirectory& run, long step) {
  const DumpFile* file = plate_at(run, step);
  return file == nullptr ? 0.0 : read_plate(file->path)->GetBounds()[4];
}

}  // namespace powderlink::render
