// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/edge_blur.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/normal.hpp>

namespace powderlink::analysis {

namespace {

constexpr float kLow = 0.25F, kEdge = 0.5F, kHigh = 0.75F;

}  // namespace

double edge_blur_px(const cv::Mat& share) {
  double band = 0.0, straight = 0.0, oblique = 0.0;
  for (int r = 0; r + 1 < share.rows; ++r) {
    const float* row = share.ptr<float>(r);
    const float* below = share.ptr<float>(r + 1);
    for (int c = 0; c + 1 < share.cols; ++c) {
      const float s = row[c];
      band += s > kLow && s < kHigh ? 1.0 : 0.0;
      const bool in = s > kEdge, right = row[c + 1] > kEdge, under = below[c] > kEdge;
      straight += static_cast<double>(in != right) + static_cast<double>(in != under);
      oblique +=
          static_cast<double>(in != (below[c + 1] > kEdge)) + static_cast<double>(right != under);
    }
  }
  // Cauchy-Crofton in four directions, as in grain_shapes.h.
  const double length = boost::math::constants::pi<double>() / 8.0 *
                        (straight + oblique / boost::math::constants::root_two<double>());
  const double quartiles = 2.0 * boost::math::quantile(boost::math::normal(), kHigh);
  return length > 0.0 ? band / (quartiles * length) : 0.0;
}

}  // namespace powderlink::analysis
