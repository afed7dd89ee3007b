// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/grain_sample.h"

#include <algorithm>
#include <cmath>

namespace powderlink::analysis {

GrainSample::GrainSample(const std::vector<double>& before_um,
                         const std::vector<double>& after_um) {
  for (const double d : before_um) classes_.push_back({std::log(d), 1.0, 0.0});
  for (const double d : after_um) classes_.push_back({std::log(d), 0.0, 1.0});
  std::sort(classes_.begin(), classes_.end(), [](const GrainClass& a, const GrainClass& b) {
    return a.log_diameter < b.log_diameter;
  });
  // Diameters from pixels repeat.
  std::size_t last = 0;
  for (std::size_t i = 1; i < classes_.size(); ++i) {
    if (classes_[i].log_diameter == classes_[last].log_diameter) {
      classes_[last].before += classes_[i].before;
      classes_[last].after += classes_[i].after;
    } else {
      classes_[++last] = classes_[i];
    }
  }
  if (!classes_.empty()) classes_.resize(last + 1);
  sum_up();
}

GrainSample::GrainSample(std::vector<GrainClass> sorted_classes)
    : classes_(std::move(sorted_classes)) {
  sum_up();
}

void GrainSample::sum_up() {
  before_.assign(1, 0.0);
  after_.assign(1, 0.0);
  for (const GrainClass& c : classes_) {
    before_.push_back(before_.back() + c.before);
    after_.push_back(after_.back() + c.after);
  }
}

std::size_t GrainSample::below(double log_diameter) const {
  const auto found =
      std::lower_bound(classes_.begin(), classes_.end(), log_diameter,
                       [](const GrainClass& c, double x) { return c.log_diameter < x; });
  return static_cast<std::size_t>(found - classes_.begin());
}

double GrainSample::largest_after() const {
  const auto found = std::find_if(classes_.rbegin(), classes_.rend(),
                                  [](const GrainClass& c) { return c.after > 0.0; });
  return found->log_diameter;
}

GrainSample GrainSample::joined(double centre, double resolution, double growth) const {
  std::vector<GrainClass> list;
  double first = 0.0;
  for (const GrainClass& c : classes_) {
    const double width = resolution + growth * std::fabs(c.log_diameter - centre);
    // Never across the centre: it separates what stays from what leaves.
    const bool same_side = (first < centre) == (c.log_diameter < centre);
    if (list.empty() || !same_side || c.log_diameter - first > width) {
      list.push_back(c);
      first = c.log_diameter;
      continue;
    }
    GrainClass& to = list.back();
    const double sum = to.count() + c.count();
    to.log_diameter += (c.log_diameter - to.log_diameter) * c.count() / sum;
    to.before += c.before;
    to.after += c.after;
  }
  return GrainSample(std::move(list));
}

}  // namespace powderlink::analysis
