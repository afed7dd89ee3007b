// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/particle_frame.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "base/invalid_input.h"

namespace powderlink::render {
namespace {

constexpr double kMicrometre = 1e-6;

[[noreturn]] void damaged(const std::filesystem::path& path, const std::string& given) {
  throw InvalidInput("reading " + path.string(), given,
                     "a complete VTK PolyData file as LIGGGHTS writes it",
                     "run the drop test again, or remove this file");
}

void note_error(vtkObject* /*caller*/, unsigned long /*event*/, void* client, void* /*text*/) {
  *static_cast<bool*>(client) = true;
}

std::string names_in(vtkPointData* data) {
  std::ostringstream list;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    list << (i > 0 ? ", " : "") << data->GetArrayName(i);
  }
  return list.str();
}

/// A column of a fix: the scalar f_ID[n], or a component of the vector f_ID[first-last].
struct Column {
  vtkDataArray* array = nullptr;
  int component = 0;
};

Column find_column(vtkPointData* data, const std::string& fix, int column) {
  const std::string single = "f_" + fix + "[" + std::to_string(column) + "]";
  if (vtkDataArray* array = data->GetArray(single.c_str())) return {array, 0};
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr) continue;
    const std::string name = array->GetName(), prefix = "f_" + fix + "[";
    int first = 0, last = 0;
    if (name.compare(0, prefix.size(), prefix) == 0 &&
        std::sscanf(name.c_str() + prefix.size(), "%d-%d]", &first, &last) == 2 &&  // NOLINT
        column >= first && column <= last && array->GetNumberOfComponents() == last - first + 1) {
      return {array, column - first};
    }
  }
  return {};
}

vtkDataArray* required(vtkPointData* data, const char* name, int components,
                       const std::filesystem::path& path) {
  vtkDataArray* array = data->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != components) {
    throw InvalidInput("reading " + path.string() + ": array '" + name + "' is missing",
                       "arrays " + names_in(data),
                       "radius, v (from vx vy vz) and columns 1 to 3 of fix kat/drop",
                       "dump custom/vtk with: "
                       "id type radius x y z vx vy vz fx fy fz f_kat[1] f_kat[2] f_kat[3]");
  }
  return array;
}

template <class Array>
void add_scalar(vtkPolyData* data, const char* name, Column from, double factor) {
  vtkNew<Array> array;
  const vtkIdType n = data->GetNumberOfPoints();
  array->SetName(name);
  array->SetNumberOfTuples(n);
  for (vtkIdType i = 0; i < n; ++i) {
    array->SetTuple1(i, factor * from.array->GetComponent(i, from.component));
  }
  data->GetPointData()->AddArray(array);
}

void add_renamed(vtkPolyData* data, const char* name, vtkDataArray* from) {
  auto copy = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
  copy->DeepCopy(from);
  copy->SetName(name);
  data->GetPointData()->AddArray(copy);
}

void check_numbers(vtkPolyData* data, vtkDataArray* radius, const std::filesystem::path& path) {
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const double r = radius->GetComponent(i, 0);
    const double* x = data->GetPoint(i);
    if (!(r > 0.0 && std::isfinite(r + x[0] + x[1] + x[2]))) {
      damaged(path, "point " + std::to_string(i) + " with radius or position that is no length");
    }
  }
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& path) {
  bool failed = false;
  vtkNew<vtkCallbackCommand> observer;  // catches VTK's own messages: the user gets one
  observer->SetCallback(note_error);
  observer->SetClientData(&failed);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetReaderErrorObserver(observer);
  reader->SetParserErrorObserver(observer);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkPolyData> data = reader->GetOutput();
  if (failed || reader->GetErrorCode() != 0 || data == nullptr) {
    damaged(path, "a file that breaks off or is no VTK PolyData");
  }
  return data;
}

vtkSmartPointer<vtkPolyData> read_particles(const std::filesystem::path& path,
                                            const std::string& fix) {
  const auto raw = read_vtp(path);
  vtkPointData* in = raw->GetPointData();
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->ShallowCopy(raw);
  if (raw->GetNumberOfPoints() == 0) return out;  // LIGGGHTS dumps no arrays without particles

  vtkDataArray* radius = required(in, "radius", 1, path);
  vtkDataArray* velocity = required(in, "v", 3, path);
  Column columns[3];
  for (int c = 0; c < 3; ++c) {
    columns[c] = find_column(in, fix, c + 1);
    const std::string name = "f_" + fix + "[" + std::to_string(c + 1) + "]";
    if (columns[c].array == nullptr) required(in, name.c_str(), 1, path);
  }
  check_numbers(raw, radius, path);

  add_scalar<vtkDoubleArray>(out, "radius_m", {radius, 0}, 1.0);
  add_scalar<vtkDoubleArray>(out, "diameter_um", {radius, 0}, 2.0 / kMicrometre);
  add_renamed(out, "velocity_m_s", velocity);
  if (vtkDataArray* force = in->GetArray("f")) add_renamed(out, "force_N", force);
  add_scalar<vtkIntArray>(out, "attached", columns[0], 1.0);
  add_scalar<vtkDoubleArray>(out, "speed_m_s", columns[1], 1.0);
  add_scalar<vtkDoubleArray>(out, "contact_radius_um", columns[2], 1.0 / kMicrometre);
  for (const char* name : {"radius", "v", "f"}) out->GetPointData()->RemoveArray(name);
  for (const Column& column : columns) out->GetPointData()->RemoveArray(column.array->GetName());
  return out;
}

std::vector<Grain> grains_of(vtkPolyData* particles) {
  const vtkIdType n = particles->GetNumberOfPoints();
  std::vector<Grain> grains(static_cast<std::size_t>(n));
  if (n == 0) return grains;
  vtkPointData* data = particles->GetPointData();
  vtkDataArray* id = data->GetArray("id");
  for (vtkIdType i = 0; i < n; ++i) {
    const double* x = particles->GetPoint(i);
    grains[static_cast<std::size_t>(i)] = {
        id != nullptr ? static_cast<long>(id->GetComponent(i, 0)) : static_cast<long>(i),
        x[0] / kMicrometre,
        x[1] / kMicrometre,
        x[2] / kMicrometre,
        data->GetArray("diameter_um")->GetComponent(i, 0),
        data->GetArray("speed_m_s")->GetComponent(i, 0),
        data->GetArray("attached")->GetComponent(i, 0) > 0.5};
  }
  return grains;
}

}  // namespace powderlink::render
