// SPDX-License-Identifier: GPL-3.0-or-later
/// \file drawn_spheres.h
/// Micrographs whose answer is known: disks of drawn sizes at random places, each pixel the mean of
/// 8 x 8 points, blurred, under uneven light, with noise.
#pragma once

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace powderlink::analysis {

struct Scene {
  int width = 1200, height = 900;
  double fraction = 0.15;  // of the area, aimed at
  double median_px = 28, log_std = 0.25, least_px = 10;
  double largest_px = 1e9;  // larger ones have left their places
  double touching = 0.0;    // share of grains that get a touching neighbour
  double blur_px = 0.8, noise = 0.03;
  double light = 0.0;  // change of brightness from corner to corner
  bool bright = false;
  double highlight = 0.0;  // radius of a bright spot, in radii
  unsigned seed = 1;
};

struct Disk {
  double x, y, r;
};

struct Drawn {
  cv::Mat grey;             // CV_32F, 0 to 1
  std::vector<Disk> whole;  // those that the edge does not cut
  double covered = 0.0;
};

inline Drawn draw(const Scene& s) {
  boost::random::mt19937_64 generator(s.seed);
  boost::random::uniform_01<double> any;
  boost::random::normal_distribution<double> normal;
  constexpr double gap = 4;  // pixels between grains that do not touch
  std::vector<Disk> disks;
  const auto free = [&](const Disk& d, std::size_t partner) {
    for (std::size_t i = 0; i < disks.size(); ++i) {
      if (i != partner && std::hypot(d.x - disks[i].x, d.y - disks[i].y) < d.r + disks[i].r + gap)
        return false;
    }
    return true;
  };
  const auto radius = [&] {
    return 0.5 * std::max(s.least_px, s.median_px * std::exp(s.log_std * normal(generator)));
  };
  const double wanted = s.fraction * s.width * s.height;
  double area = 0;
  for (int tries = 0; area < wanted && tries < 200000; ++tries) {
    const Disk d{any(generator) * s.width, any(generator) * s.height, radius()};
    if (!free(d, disks.size())) continue;
    disks.push_back(d);
    area += M_PI * d.r * d.r;
    if (any(generator) >= s.touching) continue;
    const double angle = 2 * M_PI * any(generator), r = radius();
    const Disk second{d.x + (d.r + r) * std::cos(angle), d.y + (d.r + r) * std::sin(angle), r};
    if (!free(second, disks.size() - 1)) continue;
    disks.push_back(second);
    area += M_PI * r * r;
  }
  disks.erase(std::remove_if(disks.begin(), disks.end(),
                             [&](const Disk& d) { return 2 * d.r > s.largest_px; }),
              disks.end());
  Drawn out;
  cv::Mat share = cv::Mat::zeros(s.height, s.width, CV_32F), spot = share.clone();
  for (const Disk& d : disks) {
    if (d.x > d.r && d.y > d.r && d.x < s.width - d.r && d.y < s.height - d.r)
      out.whole.push_back(d);
    for (int r = std::max(0, static_cast<int>(d.y - d.r) - 1);
         r <= std::min(s.height - 1, static_cast<int>(d.y + d.r) + 1); ++r) {
      for (int c = std::max(0, static_cast<int>(d.x - d.r) - 1);
           c <= std::min(s.width - 1, static_cast<int>(d.x + d.r) + 1); ++c) {
        int inside = 0, bright = 0;
        for (int k = 0; k < 64; ++k) {
          const double off = std::hypot(c + (k % 8 + 0.5) / 8 - d.x, r + (k / 8 + 0.5) / 8 - d.y);
          inside += off < d.r ? 1 : 0;
          bright += off < s.highlight * d.r ? 1 : 0;
        }
        share.at<float>(r, c) = std::min(1.0F, share.at<float>(r, c) + inside / 64.0F);
        spot.at<float>(r, c) += bright / 64.0F;
      }
    }
  }
  out.covered = cv::mean(share)[0];
  share -= spot;
  if (s.blur_px > 0) cv::GaussianBlur(share, share, cv::Size(), s.blur_px);
  out.grey.create(share.size(), CV_32F);
  for (int r = 0; r < s.height; ++r) {
    for (int c = 0; c < s.width; ++c) {
      const double x = (c + 0.5) / s.width, y = (r + 0.5) / s.height;
      const double light = 1 - s.light * (0.5 * (x + y) + 0.6 * std::pow(x - 0.4, 2));
      const double f = share.at<float>(r, c);
      const double value = light * (s.bright ? 0.2 + 0.5 * f : 0.75 - 0.5 * f);
      out.grey.at<float>(r, c) =
          static_cast<float>(std::clamp(value + s.noise * normal(generator), 0.0, 1.0));
    }
  }
  return out;
}

}  // namespace powderlink::analysis
