// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/fluid_lenders.h"

#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace powderlink::host {

namespace index = boost::geometry::index;

namespace {

using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Entry = std::pair<Point, std::size_t>;
constexpr std::size_t kEntriesPerNode = 16;

Point point_of(const double* x) { return Point(x[0], x[1], x[2]); }

}  // namespace

struct FluidLenders::Tree {
  explicit Tree(const std::vector<Entry>& entries) : entries(entries) {}
  index::rtree<Entry, index::linear<kEntriesPerNode>> entries;
};

FluidLenders::FluidLenders() = default;
FluidLenders::~FluidLenders() = default;

void FluidLenders::clear() {
  positions_m_.clear();
  loans_.clear();
  tree_.reset();
}

void FluidLenders::add(const double* position_m, const FluidLoan& loan) {
  positions_m_.insert(positions_m_.end(), position_m, position_m + 3);
  loans_.push_back(loan);
}

void FluidLenders::order() {
  std::vector<Entry> entries;
  entries.reserve(loans_.size());
  for (std::size_t n = 0; n < loans_.size(); ++n) {
    entries.emplace_back(point_of(&positions_m_[3 * n]), n);
  }
  tree_ = std::make_unique<Tree>(entries);
}

const FluidLoan* FluidLenders::nearest(const double* position_m) const {
  const auto found = tree_->entries.qbegin(index::nearest(point_of(position_m), 1));
  return found == tree_->entries.qend() ? nullptr : &loans_[found->second];
}

}  // namespace powderlink::host
