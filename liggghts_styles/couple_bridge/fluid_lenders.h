// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fluid_lenders.h
/// The particles of this rank that the solver knows, with their values: a new particle finds the nearest
/// one. Time n log n for n of them, log n for each new one.
/// Tests: tests/liggghts_styles/couple_bridge_traffic_test.cpp
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "liggghts_styles/couple_bridge/fluid_loan.h"

namespace powderlink::host {

class FluidLenders {
 public:
  FluidLenders();
  ~FluidLenders();

  void clear();
  void add(const double* position_m, const FluidLoan& loan);
  /// After the last one was added.
  void order();
  bool ordered() const { return tree_ != nullptr; }
  std::size_t count() const { return loans_.size(); }

  /// Of the nearest one; null when there is none. Of equally near ones any.
  const FluidLoan* nearest(const double* position_m) const;

 private:
  struct Tree;
  std::vector<double> positions_m_;
  std::vector<FluidLoan> loans_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace powderlink::host
