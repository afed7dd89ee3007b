// SPDX-License-Identifier: GPL-3.0-or-later
// Drawn spheres of known sizes: counts, sizes and both diameters, over noise, blur, light and density.
#include "analysis/sizes/pictures/segmentation.h"

#include <numeric>
#include <opencv2/imgcodecs.hpp>

#include "analysis/sizes/pictures/edge_blur.h"
#include "analysis/sizes/pictures/split_touching.h"
#include "analysis/sizes/size_distribution.h"
#include "tests/analysis/sizes/drawn_spheres.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr double kCount = 0.02;
constexpr double kMedian = 0.01;

struct Found {
  double count = 0, count_drawn = 0, d50 = 0, d50_drawn = 0, ratio = 0;
  std::size_t grains = 0;
};

double median(std::vector<double> d) {
  return SizeDistribution(std::move(d), Weighting::number).quantile_um(0.5);
}

Found look(const Scene& scene) {
  const Drawn drawn = draw(scene);
  Micrograph m;
  m.file = "drawn";
  m.grey = drawn.grey;
  const Segmentation s = segment(m, {});
  std::vector<double> seen, true_d;
  Found f;
  for (const GrainShape& g : s.grains) {
    seen.push_back(std::sqrt(4 * g.area_px / M_PI));
    f.ratio += 4 * g.area_px / g.perimeter_px / seen.back() / static_cast<double>(s.grains.size());
  }
  for (const Disk& d : drawn.whole) true_d.push_back(2 * d.r);
  f.grains = seen.size();
  f.count = static_cast<double>(seen.size());
  f.count_drawn = static_cast<double>(true_d.size());
  f.d50 = median(seen);
  f.d50_drawn = median(true_d);
  return f;
}

void expect_right(const Scene& scene, const std::string& what) {
  const Found f = look(scene);
  EXPECT_NEAR(f.count / f.count_drawn, 1, kCount)
      << what << ": " << f.count << " of " << f.count_drawn;
  EXPECT_NEAR(f.d50 / f.d50_drawn, 1, kMedian) << what << ": " << f.d50 << " for " << f.d50_drawn;
  // On disks both diameters are the diameter; a mean over many leaves the estimator's bias.
  EXPECT_NEAR(f.ratio, 1, kMedian) << what;
}

TEST(Segmentation, CountAndMedianOfPlainDisks) {
  expect_right({}, "dark");
  Scene bright;
  bright.bright = true;
  expect_right(bright, "bright");
}

TEST(Segmentation, NoiseAndBlur) {
  for (const double noise : {0.0, 0.05, 0.08}) {
    for (const double blur : {0.0, 0.8, 1.3}) {
      Scene s;
      s.noise = noise;
      s.blur_px = blur;
      expect_right(s, "noise " + std::to_string(noise) + ", blur " + std::to_string(blur));
    }
  }
}

/// Disks of one diameter at random places of a lattice. Every pixel has the area that is covered, from
/// the closed form of the chord over strips of 1/64 pixel: independent of draw().
cv::Mat equal_disks(double d, bool bright, double blur_px, double noise) {
  constexpr int rows = 14;
  constexpr int strips = 64;
  const double pitch = 2.5 * d, r = d / 2;
  const int side = static_cast<int>(pitch * rows);
  boost::random::mt19937_64 generator(11);
  boost::random::uniform_01<double> any;
  boost::random::normal_distribution<double> normal;
  cv::Mat share = cv::Mat::zeros(side, side, CV_32F);
  for (int k = 0; k < rows * rows; ++k) {
    const double x = (k % rows + 0.5) * pitch + any(generator);
    const double y = (k / rows + 0.5) * pitch + any(generator);
    for (int i = static_cast<int>(y - r); i <= static_cast<int>(y + r); ++i) {
      for (int j = static_cast<int>(x - r); j <= static_cast<int>(x + r); ++j) {
        double area = 0;
        for (int s = 0; s < strips; ++s) {
          const double h =
              std::sqrt(std::max(0.0, r * r - std::pow(j + (s + 0.5) / strips - x, 2)));
          area += std::max(0.0, std::min(i + 1.0, y + h) - std::max<double>(i, y - h)) / strips;
        }
        share.at<float>(i, j) += static_cast<float>(area);
      }
    }
  }
  if (blur_px > 0) cv::GaussianBlur(share, share, cv::Size(), blur_px);
  cv::Mat grey = bright ? cv::Mat(0.2 + 0.5 * share) : cv::Mat(0.75 - 0.5 * share);
  for (float& value : cv::Mat_<float>(grey)) value += static_cast<float>(noise * normal(generator));
  return grey;
}

TEST(Segmentation, SmallDisksHaveNoBias) {
  constexpr double kBias_px = 0.05;  // 196 disks scatter by 0.13 pixels each: 5 sigma of their mean
  struct Look {
    bool bright;
    double blur_px, noise;
  };
  for (const double d : {10.0, 12.0, 15.0}) {
    for (const Look& look :
         {Look{false, 0, 0}, Look{true, 0, 0.04}, Look{false, 0.8, 0.04}, Look{true, 1.3, 0}}) {
      const Segmentation s =
          segment({"disks", equal_disks(d, look.bright, look.blur_px, look.noise), {}}, {});
      double area = 0, perimeter = 0;
      for (const GrainShape& g : s.grains) {
        area += std::sqrt(4 * g.area_px / M_PI) / static_cast<double>(s.grains.size());
        perimeter += g.perimeter_px / M_PI / static_cast<double>(s.grains.size());
      }
      const std::string what = std::to_string(d) + " pixels, " + (look.bright ? "bright" : "dark") +
                               ", blur " + std::to_string(look.blur_px);
      EXPECT_EQ(s.grains.size(), 196U) << what;
      EXPECT_NEAR(area, d, kBias_px) << what;
      EXPECT_NEAR(perimeter, d, kBias_px) << what;
    }
  }
}

TEST(EdgeBlur, IsThatOfStraightEdgesOverAllAngles) {
  constexpr double kMean = 0.01;  // whole pixels in a band average out over angles
  constexpr int angles = 40;
  for (const double sigma : {1.0, 1.5, 2.0}) {
    double mean = 0;
    for (int k = 0; k < angles; ++k) {
      const double t = (k + 0.37) * M_PI / angles;
      cv::Mat share(150, 150, CV_32F);
      for (int i = 0; i < 150; ++i) {
        for (int j = 0; j < 150; ++j) {
          const double off = (j - 74.7) * std::cos(t) + (i - 74.4) * std::sin(t);
          share.at<float>(i, j) = static_cast<float>(0.5 * std::erfc(off / sigma / std::sqrt(2.0)));
        }
      }
      mean += edge_blur_px(share) / sigma / angles;
    }
    EXPECT_NEAR(mean, 1, kMean) << sigma;
  }
  EXPECT_EQ(edge_blur_px(cv::Mat::zeros(50, 50, CV_32F)), 0);
}

TEST(Segmentation, UnevenLight) {
  for (const bool bright : {false, true}) {
    Scene s;
    s.light = 0.5;
    s.bright = bright;
    expect_right(s, bright ? "bright" : "dark");
  }
}

TEST(Segmentation, TouchingPairsArePartedAtThreeMagnifications) {
  // The same powder at 1, 2 and 3 pixels per um; the smallest grain has 10 pixels at least.
  for (const double per_um : {1.0, 2.0, 3.0}) {
    Scene s;
    s.median_px = 22 * per_um;
    s.least_px = 10 * per_um;
    s.width = static_cast<int>(1000 * per_um);
    s.height = static_cast<int>(800 * per_um);
    s.touching = 0.5;
    expect_right(s, std::to_string(per_um) + " pixels per um");
  }
}

TEST(Segmentation, NoBiasOverDensity) {
  for (const double fraction : {0.03, 0.1, 0.2, 0.3, 0.4}) {
    Scene s;
    s.fraction = fraction;
    s.width = 1800;
    s.height = 1400;
    expect_right(s, "fraction " + std::to_string(fraction));
  }
}

TEST(Segmentation, HighlightsAreFilledAndGapsAreNot) {
  Scene s;
  s.highlight = 0.35;
  expect_right(s, "highlights");
  // Three disks that touch enclose a gap of (sqrt(3) - pi/2) R^2, which is no grain's.
  const double r = 60;
  cv::Mat three(300, 300, CV_32F);
  const double h = r * std::sqrt(3.0);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      const bool in = std::hypot(x - 90, y - 90) < r || std::hypot(x - 210, y - 90) < r ||
                      std::hypot(x - 150, y - 90 - h) < r;
      three.at<float>(y, x) = in ? 0.2F : 0.8F;
    }
  }
  const Segmentation found = segment({"three", three, {}}, {});
  ASSERT_EQ(found.grains.size(), 3U);
  double area = 0;
  for (const GrainShape& g : found.grains) area += g.area_px;
  constexpr double kNecks = 0.01;  // what smoothing puts into three necks
  EXPECT_NEAR(area / (3 * M_PI * r * r), 1, kNecks);
}

TEST(Segmentation, UnevenGrainsStayWhole) {
  // An ellipse of 2:1 has one peak of distance, a bean of slight waist two of nearly one height.
  cv::Mat picture(200, 400, CV_32F, cv::Scalar(0.2));
  cv::ellipse(picture, {100, 100}, {60, 30}, 30, 0, 360, cv::Scalar(0.8), -1);
  cv::circle(picture, {270, 100}, 30, cv::Scalar(0.8), -1);
  cv::circle(picture, {300, 100}, 30, cv::Scalar(0.8), -1);
  const Segmentation found = segment({"two", picture, {}}, {});
  ASSERT_EQ(found.grains.size(), 2U);
  EXPECT_NEAR(found.grains[0].aspect_ratio, 2, 0.03);  // an ellipse drawn as a polygon
}

TEST(GrainShapes, PerimeterOfDisksIsUnbiasedAtEverySize) {
  // 400 disks at random places: the error of the mean is far below the bound.
  constexpr double kBias = 0.005;
  boost::random::mt19937_64 generator(3);
  boost::random::uniform_01<double> any;
  for (const double r : {5.0, 10.0, 30.0}) {
    double perimeter = 0, area = 0, feret = 0;
    constexpr int disks = 400;
    for (int k = 0; k < disks; ++k) {
      const int size = static_cast<int>(2 * r) + 6;
      const double x = r + 2 + any(generator), y = r + 2 + any(generator);
      cv::Mat labels = cv::Mat::zeros(size, size, CV_32S);
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) labels.at<int>(i, j) = std::hypot(j - x, i - y) < r ? 1 : 0;
      const GrainShape g = grain_shapes(labels, 1)[0];
      perimeter += g.perimeter_px / disks;
      area += g.area_px / disks;
      feret += g.feret_px / disks;
    }
    EXPECT_NEAR(perimeter / (2 * M_PI * r), 1, kBias) << r;
    EXPECT_NEAR(area / (M_PI * r * r), 1, kBias) << r;
    EXPECT_NEAR(feret, 2 * r, 0.5) << r;
  }
}

TEST(GrainShapes, StraightEdgesAtEveryAngle) {
  // Four directions know a straight edge to within 5 %, the mean over all angles exactly.
  constexpr double kOneAngle = 0.055, kMean = 0.005;
  double mean = 0;
  constexpr int angles = 90;
  for (int k = 0; k < angles; ++k) {
    const double t = (k + 0.5) * M_PI / 2 / angles, half = 60;
    cv::Mat labels = cv::Mat::zeros(200, 200, CV_32S);
    for (int i = 0; i < 200; ++i) {
      for (int j = 0; j < 200; ++j) {
        const double x = j - 99.6, y = i - 99.7;
        labels.at<int>(i, j) = std::fabs(x * std::cos(t) + y * std::sin(t)) < half &&
                               std::fabs(y * std::cos(t) - x * std::sin(t)) < half;
      }
    }
    const double ratio = grain_shapes(labels, 1)[0].perimeter_px / (8 * half);
    EXPECT_NEAR(ratio, 1, kOneAngle) << t;
    mean += ratio / angles;
  }
  EXPECT_NEAR(mean, 1, kMean);
}

TEST(Segmentation, RefusesPicturesWithoutGrains) {
  const auto of = [](const cv::Mat& grey) {
    return [grey] { segment({"picture", grey, {}}, {}); };
  };
  cv::Mat noise(300, 300, CV_32F);
  cv::randn(noise, 0.5, 0.05);
  expect_refusal(of(noise), {"picture", "no grains to be seen"});
  cv::Mat ramp(300, 300, CV_32F);
  for (int r = 0; r < 300; ++r) ramp.row(r).setTo(0.3 + 0.001 * r);
  expect_refusal(of(ramp + 0.1 * noise), {"no grains to be seen"});
  cv::Mat blob(300, 300, CV_32F, cv::Scalar(0.2));
  cv::rectangle(blob, {0, 120}, {299, 180}, cv::Scalar(0.8), -1);
  expect_refusal(of(blob), {"no whole grain", "cut by the edge"});
}

TEST(Segmentation, OverlayHasThePicturesSizeAndMarksGrains) {
  Scene s;
  s.width = 400;
  s.height = 300;
  Micrograph m;
  m.grey = draw(s).grey;
  const Segmentation found = segment(m, {});
  const std::string png = overlay_png(m, found);
  const cv::Mat picture =
      cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_COLOR);
  ASSERT_EQ(picture.size(), m.grey.size());
  std::vector<cv::Mat> bgr;
  cv::split(picture, bgr);
  double outline = 0;
  for (const GrainShape& g : found.grains) outline += g.perimeter_px;
  const double orange = cv::countNonZero((bgr[2] == 238) & (bgr[1] == 119) & (bgr[0] == 51));
  EXPECT_GT(orange, 0.5 * outline);  // pixels of an outline count 0.9 per length, numbers hide some
}

}  // namespace
}  // namespace powderlink::analysis
