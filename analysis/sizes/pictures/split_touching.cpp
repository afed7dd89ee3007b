// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/split_touching.h"

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace powderlink::analysis {

namespace {

constexpr float kNeck = 0.8F;   // of the smaller grain's half width
constexpr float kDepth = 1.0F;  // pixels: the distance's own error on a grid

struct Basins {
  std::vector<int> parent;
  std::vector<float> peak;

  int add(float height) {
    parent.push_back(static_cast<int>(parent.size()));
    peak.push_back(height);
    return parent.back();
  }
  int root(int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
};

}  // namespace

int split_touching(const cv::Mat& mask, cv::Mat& labels) {
  cv::Mat padded, distance;
  cv::copyMakeBorder(mask, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::distanceTransform(padded, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  const int width = padded.cols;
  const auto* d = distance.ptr<float>();
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(distance.total()); ++i)
    if (d[i] > 0.0F) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return d[a] > d[b]; });

  Basins basins;
  std::vector<int> basin(distance.total(), -1);
  const int around[8] = {-1, 1, -width, width, -width - 1, -width + 1, width - 1, width + 1};
  for (const int at : order) {
    int best = -1;  // the neighbour furthest inside
    for (const int step : around) {
      const int next = at + step;
      if (basin[next] >= 0 && (best < 0 || d[next] > d[best])) best = next;
    }
    if (best < 0) {
      basin[at] = basins.add(d[at]);
      continue;
    }
    basin[at] = basins.root(basin[best]);
    for (const int step : around) {
      if (basin[at + step] < 0) continue;
      const int own = basins.root(basin[at]), other = basins.root(basin[at + step]);
      if (own == other) continue;
      const float smaller = std::min(basins.peak[own], basins.peak[other]);
      if (d[at] < kNeck * smaller && smaller - d[at] > kDepth) continue;
      const bool keep_own = basins.peak[own] >= basins.peak[other];
      basins.parent[keep_own ? other : own] = keep_own ? own : other;
    }
  }

  std::vector<int> number(basins.parent.size(), 0);
  int grains = 0;
  labels.create(mask.size(), CV_32S);
  for (int r = 0; r < mask.rows; ++r) {
    int* to = labels.ptr<int>(r);
    for (int c = 0; c < mask.cols; ++c) {
      const int b = basin[(r + 1) * width + c + 1];
      if (b < 0) {
        to[c] = 0;
        continue;
      }
      int& n = number[basins.root(b)];
      if (n == 0) n = ++grains;
      to[c] = n;
    }
  }
  return grains;
}

}  // namespace powderlink::analysis
