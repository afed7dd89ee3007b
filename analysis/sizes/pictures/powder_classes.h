// SPDX-License-Identifier: GPL-3.0-or-later
/// \file powder_classes.h
/// A sample of grains as a few sizes, for programs that draw from single sizes.
///   share = grains of the class/all grains,   d^3 = mean of the class's d^3
/// so that at every limit between classes the shares finer by number and by mass are those of the
/// sample, whatever its distribution is. Limits are where they take most off the scatter of ln d within
/// classes, each grain with the mean of its shares by number and by mass; gaps between populations are
/// thus limits first, and neither dust nor the few largest grains fill one class alone.
/// Symbols: d diameter [um]. Valid for any sample; one size makes one class.
/// Source: W. D. Fisher, J. Am. Stat. Assoc. 53 (1958) 789 (grouping for least scatter), here by
/// halving, one class at a time. Tests: tests/analysis/sizes/powder_inputs_test.cpp
#pragma once

#include <vector>

#include "analysis/sizes/size_distribution.h"

namespace powderlink::analysis {

struct PowderClass {
  double diameter_um = 0.0;
  double share_number = 0.0, share_mass = 0.0;
  double smallest_um = 0.0, largest_um = 0.0;  ///< grains in it
};

/// Rising; `most` of them, or as many as there are different sizes.
std::vector<PowderClass> powder_classes(const SizeDistribution& sample, std::size_t most);

}  // namespace powderlink::analysis
