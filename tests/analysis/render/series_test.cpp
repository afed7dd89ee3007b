// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/series.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <fstream>

#include "analysis/render/particle_frame.h"
#include "analysis/render/residual_table.h"
#include "tests/analysis/render/dump_sample.h"

namespace powderlink::render::test {
namespace {

struct PvdEntry {
  double time_s;
  std::string file;
};

/// Parses with VTK's own XML parser: what is not well-formed fails here.
std::vector<PvdEntry> entries_of(const std::filesystem::path& pvd) {
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(text_of(pvd).c_str()));
  std::vector<PvdEntry> entries;
  if (root == nullptr || std::string(root->GetName()) != "VTKFile") return entries;
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* list = root->FindNestedElementWithName("Collection");
  for (int i = 0; list != nullptr && i < list->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* item = list->GetNestedElement(i);
    entries.push_back({std::stod(item->GetAttribute("timestep")), item->GetAttribute("file")});
  }
  return entries;
}

TEST(Series, PvdHasPhysicalTimesAndFilesThatExist) {
  const TemporaryFolder run;
  write_run(run.path());
  const SeriesFiles written = write_series(open_run(run.path()));
  EXPECT_EQ(written.states, 5U);
  for (const auto& pvd : {written.particles_pvd, written.plate_pvd}) {
    const auto entries = entries_of(pvd);
    ASSERT_EQ(entries.size(), 5U) << pvd;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      EXPECT_NEAR(entries[i].time_s, 100.0 * static_cast<double>(i) * kTimeStep, 1e-15);
      EXPECT_TRUE(std::filesystem::is_regular_file(run.path() / entries[i].file))
          << entries[i].file;
    }
  }
}

TEST(Series, StepsAreOrderedByNumberNotByName) {
  const TemporaryFolder run;
  std::filesystem::create_directories(run.path() / "post");
  for (const long step : {1000L, 200L, 90L}) {
    write_dump(run.path() / "post" / ("particles_" + std::to_string(step) + ".vtp"),
               sample_grains(0));
  }
  const auto entries = entries_of(write_series(open_run(run.path(), 2e-8)).particles_pvd);
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_NEAR(entries[0].time_s, 90 * 2e-8, 1e-15);
  EXPECT_NEAR(entries[2].time_s, 1000 * 2e-8, 1e-15);
}

TEST(Series, OptionBeatsTheTimeStepOfTheResults) {
  const TemporaryFolder run;
  write_run(run.path());
  const auto entries = entries_of(write_series(open_run(run.path(), 5e-7)).particles_pvd);
  EXPECT_NEAR(entries.at(4).time_s, 400 * 5e-7, 1e-15);
}

void expect_readable_arrays(const std::filesystem::path& file) {
  const auto data = read_vtp(file);
  const auto grains = sample_grains(400);
  ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(grains.size()));
  vtkPointData* arrays = data->GetPointData();
  for (const char* name : {"id", "radius_m", "diameter_um", "velocity_m_s", "force_N", "attached",
                           "speed_m_s", "contact_radius_um"}) {
    ASSERT_NE(arrays->GetArray(name), nullptr) << name;
  }
  for (const char* name : {"radius", "v", "f", "f_kat[1-3]", "f_kat[1]"}) {
    EXPECT_EQ(arrays->GetArray(name), nullptr) << name;
  }
  EXPECT_EQ(arrays->GetArray("velocity_m_s")->GetNumberOfComponents(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const SampleGrain& g = grains[static_cast<std::size_t>(i)];
    EXPECT_DOUBLE_EQ(arrays->GetArray("radius_m")->GetTuple1(i), g.radius_m);
    EXPECT_NEAR(arrays->GetArray("diameter_um")->GetTuple1(i), 2e6 * g.radius_m, 1e-9);
    EXPECT_EQ(arrays->GetArray("attached")->GetTuple1(i), g.attached ? 1.0 : 0.0);
    EXPECT_NEAR(arrays->GetArray("speed_m_s")->GetTuple1(i), g.speed_m_s, 1e-12);
    EXPECT_NEAR(arrays->GetArray("contact_radius_um")->GetTuple1(i),
                g.attached ? 1e5 * g.radius_m : 0.0, 1e-9);
    EXPECT_NEAR(arrays->GetArray("velocity_m_s")->GetComponent(i, 2), -g.speed_m_s, 1e-12);
  }
}

TEST(Series, ArraysHaveReadableNamesWhetherLiggghtsJoinedThemOrNot) {
  for (const bool joined : {true, false}) {
    const TemporaryFolder run;
    std::filesystem::create_directories(run.path() / "post");
    DumpStyle style;
    style.joined = joined;
    write_dump(run.path() / "post/particles_400.vtp", sample_grains(400), style);
    write_series(open_run(run.path(), kTimeStep));
    expect_readable_arrays(run.path() / "vtk/particles_400.vtp");
  }
}

TEST(Series, PlaneCarriesTheParticlesFromAbove) {
  const TemporaryFolder run;
  write_run(run.path());
  write_series(open_run(run.path()));
  double plate[6], grains[6];
  read_vtp(run.path() / "plate.vtp")->GetBounds(plate);
  read_vtp(run.path() / "vtk/particles_0.vtp")->GetBounds(grains);
  EXPECT_DOUBLE_EQ(plate[4], 0.0);
  EXPECT_GT(plate[5], 0.0);
  EXPECT_LT(plate[0], grains[0]);
  EXPECT_GT(plate[1], grains[1]);
  EXPECT_LT(plate[2], grains[2]);
  EXPECT_GT(plate[3], grains[3]);
}

TEST(Series, DumpedMeshIsThePlate) {
  const TemporaryFolder run;
  write_run(run.path());
  // As `dump mesh/stl` writes it.
  for (const int step : {0, 400}) {
    const std::string z = step == 0 ? "0" : "-2e-05";
    std::ofstream(run.path() / ("post/plate_" + std::to_string(step) + ".stl"))
        << "solid LIGGGHTS_STL_EXPORT\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 " << z
        << "\n  vertex 0.001 0 " << z << "\n  vertex 0 0.001 " << z
        << "\n endloop\nendfacet\nendsolid LIGGGHTS_STL_EXPORT\n";
  }
  const auto entries = entries_of(write_series(open_run(run.path())).plate_pvd);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[1].file, "vtk/plate_400.vtp");
  EXPECT_NEAR(read_vtp(run.path() / entries[1].file)->GetBounds()[4], -2e-5, 1e-10);
}

TEST(Series, SecondCallReplacesTheFirstAndLeavesNothingBehind) {
  const TemporaryFolder run;
  write_run(run.path());
  write_series(open_run(run.path()));
  std::ofstream(run.path() / "vtk/particles_9999.vtp") << "stale";
  const auto dumps = names_below(run.path() / "post");
  write_series(open_run(run.path()));
  EXPECT_EQ(names_below(run.path() / "vtk").size(), 5U);
  EXPECT_EQ(names_below(run.path() / "post"), dumps);
  for (const std::string& name : names_below(run.path())) EXPECT_NE(name.front(), '.') << name;
}

TEST(Series, StateWithoutParticlesIsKept) {
  const TemporaryFolder run;
  std::filesystem::create_directories(run.path() / "post");
  write_dump(run.path() / "post/particles_0.vtp", {});
  EXPECT_EQ(write_series(open_run(run.path(), kTimeStep)).states, 1U);
}

TEST(ResidualTable, HoldsEveryParticleBySize) {
  const TemporaryFolder run;
  write_run(run.path());
  const std::string table = residual_table(read_results(run.path()), "run");
  EXPECT_EQ(table.find("# impact_velocity_m_s 1.4\n# critical_diameter_um 46\n"
                       "diameter_um,attached,speed_m_s\n20,1,0\n"),
            0U);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3 + 144);
}

}  // namespace
}  // namespace powderlink::render::test
