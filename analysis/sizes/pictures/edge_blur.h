// SPDX-License-Identifier: GPL-3.0-or-later
/// \file edge_blur.h
/// How wide the edges of a picture are, from the picture itself.
///   sigma = A/(2 z P),  z = 0.6745 the normal distribution's quartile
/// A area where the share s between background and grains is between 1/4 and 3/4, P length of the edges
/// at 1/2: a straight edge under a Gaussian of standard deviation sigma has a band 2 z sigma wide there.
/// Optics, the area of a pixel (1/12) and smoothing add as variances. Curvature changes it by
/// sigma^2/R^2; noise of the share up to 1/8 does not. Symbols: lengths in pixels.
/// Tests: tests/analysis/sizes/segmentation_test.cpp
#pragma once

#include <opencv2/core.hpp>

namespace powderlink::analysis {

/// \param share  CV_32F; \return 0 without edges
double edge_blur_px(const cv::Mat& share);

}  // namespace powderlink::analysis
