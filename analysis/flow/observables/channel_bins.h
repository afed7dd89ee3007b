// SPDX-License-Identifier: GPL-3.0-or-later
/// \file channel_bins.h
/// A hundred equal bins along a channel, downstream or not: bin i is [low + i d, low + (i + 1) d).
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <optional>

#include "analysis/flow/run/flow_statistics.h"

namespace powderlink::analysis {

class ChannelBins {
 public:
  static constexpr std::size_t kCount = 100;

  explicit ChannelBins(const Interval& reach_m) : reach_m_(reach_m) {}

  double width_m() const { return (reach_m_.to - reach_m_.from) / kCount; }
  double centre_m(std::size_t bin) const {
    return reach_m_.from + width_m() * (static_cast<double>(bin) + 0.5);
  }
  /// Empty beyond the channel.
  std::optional<std::size_t> of(double place_m) const {
    const double bin = (place_m - reach_m_.from) / width_m();
    if (!(bin >= 0.0 && bin < kCount)) return {};
    return static_cast<std::size_t>(bin);
  }

 private:
  Interval reach_m_;
};

}  // namespace powderlink::analysis
