// SPDX-License-Identifier: GPL-3.0-or-later
/// \file moving_average.h
/// Centred moving average of a sampled signal over a window w, and its irregularity.
///   a(t) = 1/w int_{t-w/2}^{t+w/2} f dt',   f linear between the samples
///   irregularity = 100 sqrt(<(a - <a>)^2>)/<a>   [%], over the sampled times
/// Only times whose whole window is sampled count. A sine of frequency f keeps the share
/// sin(pi f w)/(pi f w) of its amplitude. Samples need not be equally far apart.
/// Tests: tests/analysis/flow/flow_statistics_test.cpp
#pragma once

#include <optional>
#include <vector>

namespace powderlink::analysis {

/// The average at each sample; empty where the window reaches beyond the samples.
/// \param times   increasing
/// \param window  > 0, in the unit of `times`
std::vector<std::optional<double>> moving_average(const std::vector<double>& times,
                                                  const std::vector<double>& values, double window);

/// Mean of the averages that exist, and their RMS deviation from it in per cent; empty with fewer
/// than two, or a mean of 0.
struct Irregularity {
  double mean = 0.0, rms_percent = 0.0;
};
std::optional<Irregularity> irregularity(const std::vector<std::optional<double>>& averages);

}  // namespace powderlink::analysis
