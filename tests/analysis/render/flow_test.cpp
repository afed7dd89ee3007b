// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <array>
#include <cstdlib>
#include <fstream>

#include "analysis/render/flow_case.h"
#include "analysis/render/flow_picture.h"
#include "analysis/render/flow_series.h"
#include "analysis/render/particle_frame.h"
#include "base/invalid_input.h"
#include "tests/analysis/render/dump_sample.h"

namespace powderlink::render::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::string foam(const std::string& type, const std::string& object, const std::string& content) {
  return fmt::format(
      "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {};\n    object {};\n}}\n{}\n"
      "// ************************************************************************* //\n",
      type, object, content);
}

constexpr double kSide_m = 1e-3, kGasSpeed_m_s = 10.0;
constexpr int kAcross = 4, kAlong = 16;

/// Axes of the files: z, or the same turned so that it lies along x (and x, y along y, z).
bool along_x = false;

std::string place_text(double x, double y, double z) {
  return along_x ? fmt::format("{:g} {:g} {:g}", z, x, y) : fmt::format("{:g} {:g} {:g}", x, y, z);
}

/// A channel of square section from z0 on, kAlong cells of a quarter of its side long.
void write_mesh(const fs::path& root, double z0_m) {
  const double h = kSide_m / kAcross;
  const auto point = [](int i, int j, int k) {
    return (k * (kAcross + 1) + j) * (kAcross + 1) + i;
  };
  const auto cell = [](int i, int j, int k) { return (k * kAcross + j) * kAcross + i; };
  std::string points;
  for (int k = 0; k <= kAlong; ++k) {
    for (int j = 0; j <= kAcross; ++j) {
      for (int i = 0; i <= kAcross; ++i) {
        points +=
            "(" + place_text(i * h - 0.5 * kSide_m, j * h - 0.5 * kSide_m, z0_m + k * h) + ")\n";
      }
    }
  }
  struct Face {
    std::array<int, 4> points;
    int owner, neighbour;
  };
  std::vector<Face> inner, outer;
  for (int k = 0; k < kAlong; ++k) {
    for (int j = 0; j < kAcross; ++j) {
      for (int i = 0; i < kAcross; ++i) {
        const int c = cell(i, j, k);
        const std::array<int, 4> x{point(i + 1, j, k), point(i + 1, j + 1, k),
                                   point(i + 1, j + 1, k + 1), point(i + 1, j, k + 1)};
        const std::array<int, 4> y{point(i, j + 1, k), point(i, j + 1, k + 1),
                                   point(i + 1, j + 1, k + 1), point(i + 1, j + 1, k)};
        const std::array<int, 4> z{point(i, j, k + 1), point(i + 1, j, k + 1),
                                   point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1)};
        (i + 1 < kAcross ? inner : outer).push_back({x, c, i + 1 < kAcross ? c + 1 : -1});
        (j + 1 < kAcross ? inner : outer)
            .push_back({y, c, j + 1 < kAcross ? cell(i, j + 1, k) : -1});
        (k + 1 < kAlong ? inner : outer).push_back({z, c, k + 1 < kAlong ? cell(i, j, k + 1) : -1});
        if (i == 0) {
          outer.push_back(
              {{point(0, j, k), point(0, j, k + 1), point(0, j + 1, k + 1), point(0, j + 1, k)},
               c,
               -1});
        }
        if (j == 0) {
          outer.push_back(
              {{point(i, 0, k), point(i + 1, 0, k), point(i + 1, 0, k + 1), point(i, 0, k + 1)},
               c,
               -1});
        }
        if (k == 0) {
          outer.push_back(
              {{point(i, j, 0), point(i, j + 1, 0), point(i + 1, j + 1, 0), point(i + 1, j, 0)},
               c,
               -1});
        }
      }
    }
  }
  std::string faces, owners, neighbours;
  for (const auto* list : {&inner, &outer}) {
    for (const Face& f : *list) {
      faces += fmt::format("4({} {} {} {})\n", f.points[0], f.points[1], f.points[2], f.points[3]);
      owners += fmt::format("{}\n", f.owner);
      if (f.neighbour >= 0) neighbours += fmt::format("{}\n", f.neighbour);
    }
  }
  const auto list = [](std::size_t n, const std::string& text) {
    return fmt::format("{}\n(\n{})\n", n, text);
  };
  const fs::path mesh = root / "constant" / "polyMesh";
  const std::size_t all = inner.size() + outer.size();
  write(mesh / "points",
        foam("vectorField", "points",
             list(std::size_t{kAcross + 1} * (kAcross + 1) * (kAlong + 1), points)));
  write(mesh / "faces", foam("faceList", "faces", list(all, faces)));
  write(mesh / "owner", foam("labelList", "owner", list(all, owners)));
  write(mesh / "neighbour", foam("labelList", "neighbour", list(inner.size(), neighbours)));
  write(mesh / "boundary",
        foam("polyBoundaryMesh", "boundary",
             fmt::format("1\n(\n  walls {{ type wall; nFaces {}; startFace {}; }}\n)\n",
                         outer.size(), inner.size())));
}

void write_gas(const fs::path& root, const std::string& time, double speed_m_s) {
  write(root / time / "U",
        foam("volVectorField", "U",
             fmt::format("dimensions [0 1 -1 0 0 0 0];\ninternalField uniform ({});\n"
                         "boundaryField\n{{\n  walls {{ type zeroGradient; }}\n}}\n",
                         place_text(0, 0, speed_m_s))));
}

/// Two dumps, at 0 and 0.01 s; the particles rest at first and then fly with 2 m/s.
void write_particles(const fs::path& root) {
  write(root / "in.channel", "timestep 1e-6\n");
  for (const long step : {0L, 10000L}) {
    std::string text = fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n20\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 "
        "1\n"
        "ITEM: ATOMS id type x y z vx vy vz radius mass \n",
        step);
    for (int i = 0; i < 20; ++i) {
      text += fmt::format("{} 1 {} {} 6e-05 1e-9 \n", i + 1,
                          place_text(-2e-4, 1e-4 * (i % 7 - 3), 1e-4 + 1.9e-4 * i),
                          place_text(0, 0, step == 0 ? 0 : 2));
    }
    write(root / fmt::format("post/particles_{}.dump", step), text);
  }
}

class Flow : public ::testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");  // NOLINT(concurrency-mt-unsafe): works without a display
    write_particles(root());
    write(root() / "system/controlDict",
          foam("dictionary", "controlDict",
               "startFrom startTime;\nstartTime 0;\nendTime 1;\ndeltaT 1;\nwriteControl timeStep;\n"
               "writeInterval 1;\n"));
    options_.width_px = 600;
  }
  const fs::path& root() const { return folder_.path(); }
  void with_gas() {
    write_mesh(root(), 0.0);
    write_gas(root(), "0", 1.0);
    write_gas(root(), "0.01", kGasSpeed_m_s);
  }
  struct Pixels {
    int width = 0;
    long blue = 0, warm = 0, dark_red = 0;
  };
  Pixels draw() {
    const fs::path png = root() / "flow.png";
    write_flow_picture(root(), png, options_);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(png.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    Pixels seen;
    seen.width = image->GetDimensions()[0];
    // Above the colour keys only.
    for (int y = 60; y < image->GetDimensions()[1]; ++y) {
      for (int x = 0; x < seen.width; ++x) {
        const auto* rgb = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
        if (rgb[2] > rgb[0] + 50) ++seen.blue;
        if (rgb[0] > rgb[2] + 60) ++seen.warm;
        if (rgb[0] > rgb[2] + 60 && rgb[1] < 60) ++seen.dark_red;
      }
    }
    return seen;
  }
  TemporaryFolder folder_;
  FlowPictureOptions options_;
};

TEST_F(Flow, SeriesHasPhysicalTimesAndReadableArrays) {
  const FlowSeriesFiles written = write_flow_series(root(), {});
  EXPECT_EQ(written.states, 2U);
  EXPECT_TRUE(fs::exists(written.foam));
  const std::string pvd = text_of(written.particles_pvd);
  EXPECT_NE(pvd.find("timestep=\"0\""), std::string::npos) << pvd;
  EXPECT_NE(pvd.find("timestep=\"0.01\" group=\"\" part=\"0\" file=\"vtk/particles_10000.vtp\""),
            std::string::npos);
  const auto data = read_vtp(root() / "vtk/particles_10000.vtp");
  ASSERT_EQ(data->GetNumberOfPoints(), 20);
  EXPECT_EQ(data->GetNumberOfCells(), 20);  // else ParaView shows nothing
  const auto value = [&](const char* name) {
    return data->GetPointData()->GetArray(name)->GetComponent(3, 0);
  };
  EXPECT_EQ(value("id"), 4.0);
  EXPECT_EQ(value("speed_m_s"), 2.0);
  EXPECT_NEAR(value("diameter_um"), 120.0, 1e-9);
  EXPECT_NEAR(value("radius_m"), 6e-5, 1e-15);
  EXPECT_NEAR(data->GetPoint(3)[2], 1e-4 + 3 * 1.9e-4, 1e-12);
}

TEST_F(Flow, DumpsAreOnTheClockOfTheGas) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): one thread
  if (std::getenv("POWDERLINK_FOAM") == nullptr) GTEST_SKIP() << "built without OpenFOAM";
  write(root() / "0.01/uniform/couplingClock",
        foam("dictionary", "couplingClock", "particlesAhead 0.004; // settled"));
  const auto dumps = dumps_with_times(root(), {});
  ASSERT_EQ(dumps.size(), 2U);
  EXPECT_NEAR(dumps[0].time_s, -0.004, 1e-12);
  EXPECT_NEAR(dumps[1].time_s, 0.006, 1e-12);
  write_flow_series(root(), {});
  EXPECT_NE(text_of(root() / "particles.pvd").find("timestep=\"0.006\""), std::string::npos);
  // Before the gas came, all rested.
  with_gas();
  options_.time_s = 0.0;
  EXPECT_EQ(draw().dark_red, 0);
  options_.time_s = 0.002;
  EXPECT_GT(draw().dark_red, 200);
}

TEST_F(Flow, GasSliceTakesTheNearestTime) {
  with_gas();
  for (const auto& [wanted, time, speed] :
       {std::array{0.004, 0.0, 1.0}, std::array{0.006, 0.01, kGasSpeed_m_s}}) {
    const auto slice = read_gas_slice(root(), wanted, 1e-5);
    ASSERT_TRUE(slice);
    EXPECT_EQ(slice->time_s, time);
    double bounds[6];
    slice->plane->GetBounds(bounds);
    EXPECT_NEAR(bounds[0], 1e-5, 1e-9);
    EXPECT_NEAR(bounds[3] - bounds[2], kSide_m, 1e-9);
    EXPECT_NEAR(bounds[5], kAlong * kSide_m / kAcross, 1e-9);
    vtkDataArray* u = slice->plane->GetPointData()->GetArray("U");
    for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i) {
      EXPECT_NEAR(u->GetComponent(i, 2), speed, 1e-5);  // read as float
    }
  }
}

TEST_F(Flow, DecomposedCaseIsReadFromItsProcessors) {
  const double length = kAlong * kSide_m / kAcross;
  for (const int k : {0, 1}) {
    const fs::path processor = root() / fmt::format("processor{}", k);
    write_mesh(processor, k * length);
    write_gas(processor, "0.01", kGasSpeed_m_s + k);
  }
  const auto slice = read_gas_slice(root(), 0.01, 1e-5);
  ASSERT_TRUE(slice);
  double bounds[6], speeds[2];
  slice->plane->GetBounds(bounds);
  slice->plane->GetPointData()->GetArray("U")->GetRange(speeds, 2);
  EXPECT_NEAR(bounds[4], 0.0, 1e-9);
  EXPECT_NEAR(bounds[5], 2.0 * length, 1e-9);
  EXPECT_NEAR(speeds[0], kGasSpeed_m_s, 1e-5);
  EXPECT_NEAR(speeds[1], kGasSpeed_m_s + 1.0, 1e-5);
}

TEST_F(Flow, PictureShowsGasAndParticles) {
  with_gas();
  const Pixels last = draw();
  EXPECT_EQ(last.width, 600);
  EXPECT_GT(last.blue, 5000);
  EXPECT_GT(last.warm, 500);
  // All particles have the speed that ends the scale: dark red.
  EXPECT_GT(last.dark_red, 200);
  options_.time_s = 0.0;
  EXPECT_EQ(draw().dark_red, 0);
}

TEST_F(Flow, PictureOfTheSameChannelAlongAnotherAxis) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): one thread
  if (std::getenv("POWDERLINK_FOAM") == nullptr) GTEST_SKIP() << "built without OpenFOAM";
  constexpr double kEdges = 0.01;  // pixels that rounding moves from one colour to the other
  with_gas();
  const Pixels along_z = draw();
  along_x = true;
  write_particles(root());
  with_gas();
  const Pixels turned = draw();
  along_x = false;
  EXPECT_NEAR(turned.blue, along_z.blue, kEdges * along_z.blue);
  EXPECT_NEAR(turned.warm, along_z.warm, kEdges * along_z.warm);
}

TEST_F(Flow, PictureWithoutGasAndOfOneStrip) {
  Pixels seen = draw();
  EXPECT_EQ(seen.blue, 0);
  EXPECT_GT(seen.warm, 500);
  options_.at_m = 0.002;
  options_.length_m = 0.001;
  const Pixels closer = draw();
  EXPECT_GT(closer.warm, seen.warm);
}

TEST_F(Flow, RefusesInFourParts) {
  const auto refuse = [&](const std::string& fragment) {
    try {
      draw();
      ADD_FAILURE() << "accepted, not: " << fragment;
    } catch (const InvalidInput& e) {
      const std::string text = e.what();
      for (const std::string& part : {std::string("; given: "), std::string("; allowed: "),
                                      std::string("; to do: "), fragment}) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
      }
    }
  };
  options_.width_px = 10;
  refuse("--width");
  options_.width_px = 600;
  options_.length_m = -1.0;
  refuse("--length");
  options_.length_m.reset();
  with_gas();
  write(root() / "0.01/U", "FoamFile { broken");
  refuse("field U");
  fs::remove_all(root() / "post");
  refuse("particles_*.dump");
  EXPECT_FALSE(fs::exists(root() / "flow.png"));
}

}  // namespace
}  // namespace powderlink::render::test
