// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/flow_case.h"

#include <fmt/format.h>
#include <vtkAppendPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCutter.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkDummyController.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPOpenFOAMReader.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>

#include "analysis/flow/run/particle_clock.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::render {

namespace fs = std::filesystem;

namespace {

double nearest(const double* times, int count, double wanted) {
  double best = times[0];
  for (int i = 1; i < count; ++i) {
    if (std::abs(times[i] - wanted) < std::abs(best - wanted)) best = times[i];
  }
  return best;
}

}  // namespace

std::vector<DumpAtTime> dumps_with_times(const fs::path& case_folder,
                                         std::optional<double> time_step_s) {
  analysis::ParticleClock clock(case_folder, time_step_s);
  std::vector<DumpAtTime> dumps;
  for (const fs::path& file : analysis::list_dumps(case_folder)) {
    // The name tells the step without reading; a dump that is named otherwise tells it inside.
    const std::optional<long> step = analysis::step_of_name(file);
    dumps.push_back(
        {step ? clock.gas_time_s(*step) : clock.gas_time_s(analysis::read_first_state(file)),
         file});
  }
  return dumps;
}

vtkSmartPointer<vtkPolyData> particles_of(const analysis::DumpState& state) {
  const auto n = static_cast<vtkIdType>(state.particles.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  vtkNew<vtkCellArray> vertices;  // ParaView shows points only as cells
  vtkNew<vtkTypeInt64Array> id;
  id->SetName("id");
  id->SetNumberOfTuples(n);
  const auto scalar = [n](const char* name, int components = 1) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(n);
    return array;
  };
  const auto radius = scalar("radius_m"), diameter = scalar("diameter_um"),
             mass = scalar("mass_kg"), speed = scalar("speed_m_s"),
             velocity = scalar("velocity_m_s", 3);
  for (vtkIdType i = 0; i < n; ++i) {
    const analysis::DumpParticle& p = state.particles[static_cast<std::size_t>(i)];
    points->SetPoint(i, p.x_m, p.y_m, p.z_m);
    vertices->InsertNextCell(1, &i);
    id->SetValue(i, p.id);
    radius->SetValue(i, p.radius_m);
    diameter->SetValue(i, 2e6 * p.radius_m);
    mass->SetValue(i, p.mass_kg);
    speed->SetValue(i, std::hypot(p.vx_m_s, p.vy_m_s, p.vz_m_s));
    velocity->SetTuple3(i, p.vx_m_s, p.vy_m_s, p.vz_m_s);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(id);
  for (const auto& array : {radius, diameter, mass, speed, velocity}) {
    data->GetPointData()->AddArray(array);
  }
  return data;
}

std::optional<GasSlice> read_gas_slice(const fs::path& case_folder, double time_s, double place_m,
                                       std::size_t normal) {
  const bool decomposed = fs::is_directory(case_folder / "processor0" / "constant" / "polyMesh");
  const bool whole = fs::is_directory(case_folder / "constant" / "polyMesh");
  if (!decomposed && !whole) return {};
  const auto read = [&](bool parts) -> std::optional<GasSlice> {
    vtkNew<vtkPOpenFOAMReader> reader;
    vtkNew<vtkDummyController> alone;  // without one, the reader of processors fails
    reader->SetController(alone);
    reader->SetFileName((case_folder / "case.foam").c_str());
    reader->SetCaseType(parts ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                              : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
    reader->SetCreateCellToPoint(1);
    reader->UpdateInformation();
    vtkInformation* information = reader->GetOutputInformation(0);
    if (!information->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS())) return {};
    const double time =
        nearest(information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS()),
                information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), time_s);
    reader->DisableAllPatchArrays();
    reader->SetPatchArrayStatus("internalMesh", 1);
    reader->UpdateTimeStep(time);
    vtkNew<vtkPlane> plane;
    std::array<double, 3> origin{}, direction{};
    origin.at(normal) = place_m;
    direction.at(normal) = 1.0;
    plane->SetOrigin(origin.data());
    plane->SetNormal(direction.data());
    vtkNew<vtkAppendPolyData> all;
    bool any = false;
    auto blocks =
        vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem()) {
      auto* mesh = vtkUnstructuredGrid::SafeDownCast(blocks->GetCurrentDataObject());
      if (mesh == nullptr || mesh->GetPointData()->GetArray("U") == nullptr) continue;
      vtkNew<vtkCutter> cut;
      cut->SetInputData(mesh);
      cut->SetCutFunction(plane);
      cut->Update();
      all->AddInputData(cut->GetOutput());
      any = true;
    }
    if (!any) {
      throw InvalidInput(fmt::format("reading the gas of {} at {:g} s", case_folder.string(), time),
                         "no field U that can be read", "a whole mesh and a whole field U",
                         "choose another --time, or move the damaged time folder away");
    }
    all->Update();
    return GasSlice{time, all->GetOutput()};
  };
  // What the solver wrote last is in the processors; a case that was reconstructed has both.
  if (decomposed) {
    if (auto slice = read(true)) return slice;
  }
  return whole ? read(false) : std::nullopt;
}

fs::path make_foam_file(const fs::path& case_folder) {
  fs::path file = case_folder / "case.foam";
  if (!fs::exists(file)) write_file(file, "");
  return file;
}

}  // namespace powderlink::render
