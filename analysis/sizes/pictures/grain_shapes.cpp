// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/grain_shapes.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace powderlink::analysis {

namespace {

struct Sums {
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  double straight = 0, oblique = 0;  // crossings
  std::vector<cv::Point> ends;       // of its rows: they hold the convex hull
};

double aspect(const Sums& s) {
  constexpr double pixel = 1.0 / 12.0;  // second moment of one pixel
  const double xx = s.xx / s.n - std::pow(s.x / s.n, 2) + pixel;
  const double yy = s.yy / s.n - std::pow(s.y / s.n, 2) + pixel;
  const double xy = s.xy / s.n - s.x * s.y / (s.n * s.n);
  const double middle = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  return std::sqrt((middle + half) / std::max(middle - half, pixel));
}

double feret(const std::vector<cv::Point>& ends) {
  std::vector<cv::Point> hull;
  cv::convexHull(ends, hull);
  double largest = 0.0;
  for (const cv::Point& a : hull)
    for (const cv::Point& b : hull) largest = std::max(largest, std::hypot(a.x - b.x, a.y - b.y));
  return largest;
}

}  // namespace

std::vector<GrainShape> grain_shapes(const cv::Mat& labels, int grains) {
  std::vector<Sums> sums(static_cast<std::size_t>(grains) + 1);
  std::vector<bool> at_edge(sums.size(), false);
  const int rows = labels.rows, cols = labels.cols;
  const auto label = [&](int r, int c) {
    return r < 0 || c < 0 || r >= rows || c >= cols ? 0 : labels.at<int>(r, c);
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int own = labels.at<int>(r, c);
      if (own == 0) continue;
      Sums& s = sums[static_cast<std::size_t>(own)];
      s.n += 1;
      s.x += c;
      s.y += r;
      s.xx += static_cast<double>(c) * c;
      s.yy += static_cast<double>(r) * r;
      s.xy += static_cast<double>(c) * r;
      const bool left = label(r, c - 1) != own, right = label(r, c + 1) != own;
      s.straight += left + right + (label(r - 1, c) != own) + (label(r + 1, c) != own);
      s.oblique += (label(r - 1, c - 1) != own) + (label(r + 1, c + 1) != own) +
                   (label(r - 1, c + 1) != own) + (label(r + 1, c - 1) != own);
      if (left || right) s.ends.emplace_back(c, r);
      if (r == 0 || c == 0 || r == rows - 1 || c == cols - 1)
        at_edge[static_cast<std::size_t>(own)] = true;
    }
  }
  std::vector<GrainShape> shapes;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const Sums& s = sums[i];
    GrainShape g;
    g.label = static_cast<int>(i);
    g.area_px = s.n;
    g.perimeter_px = boost::math::constants::pi<double>() / 8.0 *
                     (s.straight + s.oblique / boost::math::constants::root_two<double>());
    g.aspect_ratio = aspect(s);
    g.feret_px = feret(s.ends);
    g.x_px = s.x / s.n;
    g.y_px = s.y / s.n;
    g.at_edge = at_edge[i];
    shapes.push_back(g);
  }
  return shapes;
}

}  // namespace powderlink::analysis
