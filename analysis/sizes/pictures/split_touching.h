// SPDX-License-Identifier: GPL-3.0-or-later
/// \file split_touching.h
/// Watershed of the distance to the background: touching grains part at their neck. Basins grow from
/// the highest distance down; two that meet at saddle s stay apart when the smaller, of peak p, has
///   s < 0.8 p  and  p - s > 1 pixel,
/// else they are one grain (an uneven edge has many shallow peaks). Equal disks part down to a
/// distance of 1.2 radii. Every pixel keeps a grain: OpenCV's watershed leaves lines between them,
/// which takes area away.
/// Source: S. Beucher, C. Lantuejoul (1979), watersheds; pooling by dynamics: M. Grimaud, SPIE 1769
/// (1992) 292.
/// Tests: tests/analysis/sizes/segmentation_test.cpp
#pragma once

#include <opencv2/core.hpp>

namespace powderlink::analysis {

/// \param mask  CV_8U, not 0 in grains
/// \param[out] labels  CV_32S: 0 background, 1... grains
/// \return number of grains
int split_touching(const cv::Mat& mask, cv::Mat& labels);

}  // namespace powderlink::analysis
