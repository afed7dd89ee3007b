// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/segmentation.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "analysis/sizes/pictures/edge_blur.h"
#include "analysis/sizes/pictures/split_touching.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kPi = boost::math::constants::pi<double>();
constexpr double kSmoothing_px = 1.0;
constexpr double kMostBlur_px = 2.0;   // wider edges are shaded, not blurred
constexpr double kTinyHole_px = 12.0;  // area: noise
constexpr double kConvex = 0.75;  // area over that of the hull; the gap of three disks has 0.37

void fill_holes(cv::Mat& mask) {
  cv::Mat outside, labels, stats, centres;
  cv::bitwise_not(mask, outside);
  // The background hangs together by sides only, so that grains do by corners too.
  const int parts = cv::connectedComponentsWithStats(outside, labels, stats, centres, 4, CV_32S);
  for (int i = 1; i < parts; ++i) {
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    if (box.x == 0 || box.y == 0 || box.br().x == mask.cols || box.br().y == mask.rows) continue;
    const cv::Mat hole = labels(box) == i;
    if (stats.at<int>(i, cv::CC_STAT_AREA) > kTinyHole_px) {
      std::vector<cv::Point> pixels, hull;
      cv::findNonZero(hole, pixels);
      cv::convexHull(pixels, hull);
      // The hull goes through centres of pixels; half of its length and one lie outside.
      const double area = cv::contourArea(hull) + 0.5 * cv::arcLength(hull, true) + 1.0;
      if (static_cast<double>(pixels.size()) < kConvex * area) continue;
    }
    mask(box).setTo(255, hole);
  }
}

void undo_blur(GrainShape& g, double variance) {
  g.perimeter_px += kPi * variance / std::sqrt(g.area_px / kPi);
  g.area_px += kPi * variance;
}

}  // namespace

Segmentation segment(const Micrograph& micrograph, const SegmentationOptions& options) {
  const int rows = micrograph.grey.rows - options.crop_bottom;
  if (options.crop_bottom < 0 || rows < 32) {
    throw InvalidInput("option --crop-bottom", fmt::format("{}", options.crop_bottom),
                       fmt::format("0 to {}", micrograph.grey.rows - 32),
                       "give the height of the legend in pixels");
  }
  const cv::Mat picture = micrograph.grey.rowRange(0, rows);
  cv::Mat smoothed;
  cv::GaussianBlur(picture, smoothed, cv::Size(), kSmoothing_px, kSmoothing_px, cv::BORDER_REFLECT);
  const cv::Mat share = grain_share(picture, smoothed, options.tone, micrograph.file);
  const double blur_px = std::clamp(edge_blur_px(share), kSmoothing_px, kMostBlur_px);
  const double variance = blur_px * blur_px;
  cv::Mat mask = share > options.level;
  fill_holes(mask);
  Segmentation s;
  const int grains = options.split ? split_touching(mask, s.labels)
                                   : cv::connectedComponents(mask, s.labels, 8, CV_32S) - 1;
  const double least_area = kPi / 4.0 * options.least_px * options.least_px;
  for (GrainShape& g : grain_shapes(s.labels, grains)) {
    undo_blur(g, variance);
    if (g.at_edge) {
      s.cut.push_back(g);
    } else if (g.area_px < least_area) {
      ++s.specks;
    } else {
      s.grains.push_back(g);
    }
  }
  if (s.grains.empty()) {
    throw InvalidInput(
        micrograph.file,
        fmt::format("no whole grain; {} cut by the edge, {} smaller than {:g} pixels", s.cut.size(),
                    s.specks, options.least_px),
        "whole grains of at least --min-pixels across",
        "use a lower magnification, another --threshold, or --grains bright or dark");
  }
  return s;
}

}  // namespace powderlink::analysis
