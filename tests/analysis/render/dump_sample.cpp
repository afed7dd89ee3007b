// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/analysis/render/dump_sample.h"

#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace powderlink::render::test {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> count{0};
  path_ = fs::temp_directory_path() /
          ("render_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void write_dump(const fs::path& file, const std::vector<SampleGrain>& grains,
                const DumpStyle& style) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> id;
  id->SetName("id");
  vtkNew<vtkDoubleArray> radius, velocity, force, joined, single[3];
  radius->SetName("radius");
  velocity->SetName("v");
  velocity->SetNumberOfComponents(3);
  force->SetName("f");
  force->SetNumberOfComponents(3);
  joined->SetName("f_kat[1-3]");
  joined->SetNumberOfComponents(3);
  for (int c = 0; c < 3; ++c) {
    single[c]->SetName(("f_kat[" + std::to_string(c + 1) + "]").c_str());
  }
  int number = 0;
  for (const SampleGrain& g : grains) {
    const vtkIdType point = points->InsertNextPoint(g.x_m, g.y_m, g.z_m);
    vertices->InsertNextCell(1, &point);
    id->InsertNextValue(++number);
    radius->InsertNextValue(g.radius_m);
    velocity->InsertNextTuple3(0.0, 0.0, -g.speed_m_s);
    force->InsertNextTuple3(0.0, 0.0, g.attached ? 1e-9 : 0.0);
    const double columns[3] = {g.attached ? 1.0 : 0.0, g.speed_m_s,
                               g.attached ? 0.1 * g.radius_m : 0.0};
    joined->InsertNextTuple(columns);
    for (int c = 0; c < 3; ++c) single[c]->InsertNextValue(columns[c]);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(id);
  if (style.with_velocity) data->GetPointData()->AddArray(velocity);
  if (style.with_force) data->GetPointData()->AddArray(force);
  data->GetPointData()->AddArray(radius);
  if (style.with_fix && style.joined) data->GetPointData()->AddArray(joined);
  for (int c = 0; c < 3 && style.with_fix && !style.joined; ++c) {
    data->GetPointData()->AddArray(single[c]);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAscii();
  writer->Write();
}

std::vector<SampleGrain> sample_grains(long step) {
  constexpr int kSide = 12;
  constexpr double kPitch = 120e-6, kCritical = 46e-6;
  std::vector<SampleGrain> grains;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double diameter = 20e-6 + 80e-6 * ((7 * i + 5 * j) % 17) / 16.0;
      SampleGrain g{i * kPitch, j * kPitch, -0.5 * diameter, 0.5 * diameter, 0.0, true};
      if (diameter > kCritical && step >= 100) {
        g.attached = false;
        g.speed_m_s = 1.4 * std::sqrt(1.0 - std::pow(kCritical / diameter, 5.0 / 3.0));
        g.z_m -= g.speed_m_s * kTimeStep * static_cast<double>(step - 100);
      }
      grains.push_back(g);
    }
  }
  return grains;
}

void write_run(const fs::path& run) {
  fs::create_directories(run / "post");
  nlohmann::json particles = nlohmann::json::array();
  for (long step = 0; step <= 400; step += 100) {
    write_dump(run / "post" / ("particles_" + std::to_string(step) + ".vtp"), sample_grains(step));
    std::ofstream(run / "post" / ("particles_boundingBox_" + std::to_string(step) + ".vtr")) << "-";
  }
  for (const SampleGrain& g : sample_grains(400)) {
    particles.push_back(
        {{"diameter_m", 2.0 * g.radius_m}, {"attached", g.attached}, {"speed_m_s", g.speed_m_s}});
  }
  std::ofstream(run / "kat_results.json") << nlohmann::json{{"critical_diameter_m", 46e-6},
                                                            {"impact_velocity_m_s", 1.4},
                                                            {"time_step_s", kTimeStep},
                                                            {"particles", particles}};
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<std::string> names_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.push_back(fs::relative(entry.path(), folder).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace powderlink::render::test
