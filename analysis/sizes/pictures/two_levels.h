// SPDX-License-Identifier: GPL-3.0-or-later
/// \file two_levels.h
/// Grains and background under uneven light. Both brightnesses are smooth surfaces over the picture,
///   B(x, y) = polynomial of degree 4,   F(x, y) = polynomial of degree 2,
/// fitted in turn with the classes that they part (two means, each a surface):
///   s(x, y) = (I - B)/(F - B),  a grain where s > level
/// At level 1/2 a straight blurred edge stays where it is, whether light adds or multiplies.
/// Pixels between 1/4 and 3/4 are edges and fit neither surface. The rest of an edge pulls the surfaces
/// together, by 7 % at grains of 10 pixels: last they are fitted to pixels 4, 3 or 2 deep in their class,
/// of the picture before it was smoothed.
/// Valid for grains of about one brightness that cover up to about 60 % of the picture.
/// Tests: tests/analysis/sizes/segmentation_test.cpp
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace powderlink::analysis {

enum class GrainTone { automatic, bright, dark };  ///< automatic: the class with fewer pixels

/// s as CV_32F. Throws InvalidInput, with `name` in it, when there are no two levels: the surfaces
/// must differ by more than 4 times the scatter around them (one noisy level, cut in two, has 2.7).
/// \param smoothed  the picture, on whose edges the two levels are parted
cv::Mat grain_share(const cv::Mat& picture, const cv::Mat& smoothed, GrainTone tone,
                    const std::string& name);

}  // namespace powderlink::analysis
