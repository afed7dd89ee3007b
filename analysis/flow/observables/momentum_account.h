// SPDX-License-Identifier: GPL-3.0-or-later
/// \file momentum_account.h
/// Momentum of the grains between two places of an axis, and what crosses its ends, from states one
/// after the other. Grains are known by their id and mass.
///   P(t) = sum(m v) of those inside
///   a grain that is inside in one state and outside in the other carries m v at the end that it
///   crossed: v there is linear in place between the two states
/// So P(t_2) - P(t_1) = entered - left + impulses of all forces on the grains inside, but for what a
/// crossing grain gets within the interval in which it crosses.
/// A grain that appears or vanishes inside (inserted, deleted) enters or leaves with its own v.
/// Tests: tests/analysis/flow/flow_observables_test.cpp
#pragma once

#include <unordered_map>

#include "analysis/flow/run/flow_statistics.h"

namespace powderlink::analysis {

class MomentumAccount {
 public:
  MomentumAccount(const FlowAxis& axis, const Interval& part_m) : axis_(axis), part_m_(part_m) {}

  /// Times must increase.
  void add(double time_s, const DumpState& state);

  std::size_t states() const { return states_; }
  double first_s() const { return first_s_; }
  double last_s() const { return last_s_; }
  double first_kg_m_s() const { return first_; }  ///< P of the first state
  double last_kg_m_s() const { return last_; }
  double entered_kg_m_s() const { return entered_; }
  double left_kg_m_s() const { return left_; }
  double mean_mass_kg() const;  ///< of the grains inside
  /// Longest way of a grain between two states, over the length of the part.
  double longest_step() const { return longest_step_; }

 private:
  struct Grain {
    double place_m = 0.0, velocity_m_s = 0.0, mass_kg = 0.0;
  };
  bool holds(const Grain& g) const { return g.place_m >= part_m_.from && g.place_m < part_m_.to; }
  double crossing_m_s(const Grain& before, const Grain& after) const;

  FlowAxis axis_;
  Interval part_m_;
  std::unordered_map<long, Grain> before_;
  std::size_t states_ = 0;
  double first_s_ = 0.0, last_s_ = 0.0, first_ = 0.0, last_ = 0.0;
  double entered_ = 0.0, left_ = 0.0, mass_sum_ = 0.0, longest_step_ = 0.0;
};

}  // namespace powderlink::analysis
