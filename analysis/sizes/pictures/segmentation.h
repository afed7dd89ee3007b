// SPDX-License-Identifier: GPL-3.0-or-later
/// \file segmentation.h
/// From a micrograph to its grains:
///   smooth (Gauss, sigma = 1 pixel) -> share between the two brightnesses (two_levels.h) -> threshold
///   -> fill holes -> part touching grains (split_touching.h) -> measure (grain_shapes.h)
///   -> leave out what is cut by the picture's edge or smaller than `least_px`.
/// Blur of variance sigma^2 moves an edge of radius R inwards by sigma^2/(2 R): pi sigma^2 is added to
/// the area and pi sigma^2/R to the perimeter. sigma holds smoothing, optics and pixels together, as the
/// picture's own edges show it (edge_blur.h), up to 2 pixels: wider edges are shaded, not blurred.
/// Disks from 10 pixels thus have no bias above 0.05 pixels; one disk scatters by 0.4 d^-1.5 of its
/// diameter d in pixels, by where it lies on the grid.
/// A hole is filled when it is convex (a highlight) or tiny; the gap between touching grains is
/// neither. Grains of 10 pixels or more are measured, smaller ones are found down to `least_px`.
/// Larger grains are cut by the edge more often: a grain of diameter d is whole with probability
/// (1 - d/W)(1 - d/H) in a picture of W x H (R. E. Miles, 1974).
/// Tests: tests/analysis/sizes/segmentation_test.cpp
#pragma once

#include <vector>

#include "analysis/sizes/pictures/grain_shapes.h"
#include "analysis/sizes/pictures/micrograph.h"
#include "analysis/sizes/pictures/two_levels.h"

namespace powderlink::analysis {

struct SegmentationOptions {
  GrainTone tone = GrainTone::automatic;
  double level = 0.5;   ///< threshold between background (0) and grains (1)
  double least_px = 5;  ///< smallest diameter
  int crop_bottom = 0;  ///< rows of a legend
  bool split = true;
};

struct Segmentation {
  cv::Mat labels;                  ///< CV_32S
  std::vector<GrainShape> grains;  ///< whole ones, row by row; numbered from 1 in the overlay
  std::vector<GrainShape> cut;     ///< by the edge
  int specks = 0;                  ///< smaller than least_px
};

/// Throws when no whole grain is found.
Segmentation segment(const Micrograph& micrograph, const SegmentationOptions& options);

/// The picture with outlines and numbers: whole grains orange, those left out blue; PNG.
std::string overlay_png(const Micrograph& micrograph, const Segmentation& found);

}  // namespace powderlink::analysis
