// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/picture.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>

#include "tests/analysis/render/dump_sample.h"

namespace powderlink::render::test {
namespace {

struct Pixels {
  int width = 0, height = 0;
  double variance = 0.0;
  long blue = 0, warm = 0;  ///< by hue: attached, detached
};

Pixels look_at(const std::filesystem::path& png) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(png.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Pixels seen;
  seen.width = image->GetDimensions()[0];
  seen.height = image->GetDimensions()[1];
  double sum = 0.0, squares = 0.0;
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      const auto* rgb = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      const double grey = (rgb[0] + rgb[1] + rgb[2]) / 3.0;
      sum += grey;
      squares += grey * grey;
      if (rgb[2] > rgb[0] + 50) ++seen.blue;
      if (rgb[0] > rgb[2] + 80) ++seen.warm;
    }
  }
  const double n = static_cast<double>(seen.width) * seen.height;
  seen.variance = squares / n - sum * sum / n / n;
  return seen;
}

class Picture : public ::testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");  // NOLINT(concurrency-mt-unsafe): works without a display
    write_run(run_.path());
    options_.width_px = 600;
  }
  Pixels draw() {
    write_picture(open_run(run_.path()), run_.path() / "kat.png", options_);
    return look_at(run_.path() / "kat.png");
  }
  TemporaryFolder run_;
  PictureOptions options_;
};

TEST_F(Picture, ShowsAttachedAndLeavingGrains) {
  const Pixels seen = draw();
  EXPECT_EQ(seen.width, 600);
  EXPECT_GT(seen.variance, 500.0);
  EXPECT_GT(seen.blue, 400);
  EXPECT_GT(seen.warm, 400);
}

TEST_F(Picture, OneStateBeforeTheImpactHasNoLeavingGrain) {
  // Leaves out the colour key: its warm pixels are the same in both pictures.
  options_.time_s = 0.0;
  const Pixels before = draw();
  options_.time_s = 4e-5;
  const Pixels after = draw();
  EXPECT_GT(before.blue, after.blue);
  EXPECT_LT(before.warm, after.warm);
}

TEST_F(Picture, LastStateAndSeveralStates) {
  options_.last = true;
  EXPECT_GT(draw().blue, 200);
  options_.last = false;
  for (const int frames : {1, 2, 4}) {
    options_.frames = frames;
    EXPECT_GT(draw().warm, 200) << frames;
  }
}

TEST_F(Picture, SameRunGivesTheSamePicture) {
  draw();
  const std::string first = text_of(run_.path() / "kat.png");
  draw();
  EXPECT_EQ(text_of(run_.path() / "kat.png"), first);
}

TEST_F(Picture, WorksWithoutResultsAndTimeStep) {
  std::filesystem::remove(run_.path() / "kat_results.json");
  EXPECT_GT(draw().blue, 400);
}

}  // namespace
}  // namespace powderlink::render::test
