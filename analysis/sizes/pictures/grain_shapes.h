// SPDX-License-Identifier: GPL-3.0-or-later
/// \file grain_shapes.h
/// Area, perimeter, axes and largest width of labelled grains, in pixels.
///   A = number of pixels
///   P = pi/4 sum_k N_k h_k/2, k along 0, 45, 90 and 135 degrees; N_k crossings of the edge by the grid's
///       lines in direction k, h_k = 1 or 1/sqrt(2) their distance (Cauchy-Crofton)
///   aspect ratio = sqrt(m1/m2), m the principal second moments + 1/12 of a pixel
///   Feret = largest distance between two pixels of the grain
/// Unbiased: the mean of P over position and angle is that of the continuous edge, for disks at every
/// size. A chain of pixel edges, as ImageJ's Perim., is 5.5 % too long (8/pi (sqrt(2) - 1) = 1.0548).
/// Sources: G. Lehmann, D. Legland, Insight Journal (2012), efficient N-dimensional surface
/// estimation using Crofton formula; Z. Kulpa, Comput. Graph. Image Process. 6 (1977) 434 (chains).
/// Tests: tests/analysis/sizes/segmentation_test.cpp
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace powderlink::analysis {

struct GrainShape {
  int label = 0;
  double area_px = 0.0, perimeter_px = 0.0, aspect_ratio = 1.0, feret_px = 0.0;
  double x_px = 0.0, y_px = 0.0;  ///< centre
  bool at_edge = false;           ///< of the picture
};

/// \param labels  CV_32S, 1 to `grains`; entry i is of label i + 1
std::vector<GrainShape> grain_shapes(const cv::Mat& labels, int grains);

}  // namespace powderlink::analysis
