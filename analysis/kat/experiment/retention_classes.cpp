// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/retention_classes.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>

namespace powderlink::analysis {

namespace {

constexpr double kTail = 0.025;

double fraction_of(double share, double area_ratio) { return share / (area_ratio * (1.0 - share)); }

}  // namespace

double RetentionClass::middle_um() const { return std::sqrt(low_um * high_um); }

double RetentionClass::fraction_low(double area_ratio) const {
  if (after == 0.0) return 0.0;
  const boost::math::beta_distribution<> jeffreys(after + 0.5, before + 0.5);
  return fraction_of(boost::math::quantile(jeffreys, kTail), area_ratio);
}

double RetentionClass::fraction_high(double area_ratio) const {
  const boost::math::beta_distribution<> jeffreys(after + 0.5, before + 0.5);
  return fraction_of(boost::math::quantile(boost::math::complement(jeffreys, kTail)), area_ratio);
}

std::vector<RetentionClass> retention_classes(const std::vector<double>& before_um,
                                              const std::vector<double>& after_um,
                                              double relative_width, double fewest) {
  double smallest = before_um.front();
  for (const auto* list : {&before_um, &after_um})
    for (const double d : *list) smallest = std::min(smallest, d);
  const double step = std::log1p(relative_width);
  const auto place = [&](double d) {
    return static_cast<std::size_t>(std::max(0.0, std::log(d / smallest) / step));
  };
  std::vector<RetentionClass> fine;
  const auto at = [&](double d) -> RetentionClass& {
    const std::size_t i = place(d);
    while (fine.size() <= i) {
      const double low = smallest * std::exp(step * static_cast<double>(fine.size()));
      fine.push_back({low, low * std::exp(step), 0.0, 0.0});
    }
    return fine[i];
  };
  for (const double d : before_um) at(d).before += 1.0;
  for (const double d : after_um) at(d).after += 1.0;

  std::vector<RetentionClass> joined;
  bool open = false;  // the last class still wants grains
  for (const RetentionClass& c : fine) {
    if (open) {
      joined.back().high_um = c.high_um;
      joined.back().before += c.before;
      joined.back().after += c.after;
    } else {
      joined.push_back(c);
    }
    open = joined.back().before < fewest;
  }
  if (open && joined.size() > 1) {
    const RetentionClass last = joined.back();
    joined.pop_back();
    joined.back().high_um = last.high_um;
    joined.back().before += last.before;
    joined.back().after += last.after;
  }
  return joined;
}

}  // namespace powderlink::analysis
