// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/place_distribution.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr std::int64_t kMostClasses = 10'000'000;  // 40 MB; 5 m with classes of half a micrometre

}  // namespace

void PlaceDistribution::add(double value_m) {
  const double place = std::floor(value_m / width_);
  const auto size = static_cast<std::int64_t>(classes_.size());
  const double offset = size == 0 ? 0.0 : place - static_cast<double>(first_);
  if (!(std::abs(place) < 1e15 && std::abs(offset) < static_cast<double>(kMostClasses))) {
    throw InvalidInput("place of a particle", fmt::format("{:g} m", value_m),
                       fmt::format("all within {:g} m", width_ * static_cast<double>(kMostClasses)),
                       "look for a particle that flew away, or a dump that is not in metres");
  }
  const auto k = static_cast<std::int64_t>(place);
  if (size == 0) {
    first_ = k;
    classes_.push_back(0);
  } else if (k < first_) {
    classes_.insert(classes_.begin(), static_cast<std::size_t>(first_ - k), 0);
    first_ = k;
  } else if (k >= first_ + size) {
    classes_.resize(static_cast<std::size_t>(k - first_ + 1), 0);
  }
  ++classes_[static_cast<std::size_t>(k - first_)];
  ++count_;
}

double PlaceDistribution::quantile(double fraction) const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  const double wanted = fraction * static_cast<double>(count_);
  double below = 0.0;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    const double here = classes_[i];
    if (here > 0.0 && below + here >= wanted) {
      const double share = (wanted - below) / here;
      return width_ * (static_cast<double>(first_) + static_cast<double>(i) + share);
    }
    below += here;
  }
  return width_ * static_cast<double>(first_ + static_cast<std::int64_t>(classes_.size()));
}

double PlaceDistribution::central_width(double fraction) const {
  return quantile(0.5 * (1.0 + fraction)) - quantile(0.5 * (1.0 - fraction));
}

}  // namespace powderlink::analysis
