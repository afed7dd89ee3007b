// SPDX-License-Identifier: GPL-3.0-or-later
/// \file flow_statistics.h
/// Statistics of particles that flow along an axis s, from one dumped state after the other.
///   solids flow through a slice of thickness ds  = sum(m_i v_i)/ds             [kg/s]
///   concentration in a slice                     = N/ds [1/m], sum(m_i)/ds     [kg/m]
///   velocity: mean and standard deviation of v over the particles of the window (by number)
///   v is the velocity along the axis, positive downstream (flow_axis.h)
///   height: percentiles of `up` in a slice; width: central interval that holds a share of the
///   particles of a slice in `across` and in `up`. Both over all established states together.
/// Slices are [k ds, (k + 1) ds). Memory grows with slices times states, not with particles.
/// Tests: tests/analysis/flow/flow_statistics_test.cpp
#pragma once

#include <boost/accumulators/accumulators.hpp>
#include <boost/accumulators/statistics/mean.hpp>
#include <boost/accumulators/statistics/stats.hpp>
#include <boost/accumulators/statistics/variance.hpp>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "analysis/flow/run/flow_axis.h"
#include "analysis/flow/run/particle_dump.h"
#include "analysis/flow/run/place_distribution.h"

namespace powderlink::analysis {

struct FlowWindow {
  double from_s = 0.0;  ///< established from here on
  FlowAxis axis;
  double from_m = -std::numeric_limits<double>::infinity();
  double to_m = std::numeric_limits<double>::infinity();  ///< part that counts, places on the axis
  double slice_m = 1e-3;                                  ///< thickness of the slices

  bool holds(double place_m) const { return place_m >= from_m && place_m <= to_m; }
};

struct Interval {
  double from = 0.0, to = 0.0;
};

/// One slice at one time.
struct SliceState {
  std::size_t count = 0;
  double mass_kg = 0.0, momentum_kg_m_s = 0.0;
};

/// One slice over all established states.
struct SliceProfile {
  using Moments = boost::accumulators::accumulator_set<
      double, boost::accumulators::stats<boost::accumulators::tag::mean,
                                         boost::accumulators::tag::variance>>;
  explicit SliceProfile(double class_width_m) : across(class_width_m), up(class_width_m) {}
  PlaceDistribution across, up;
  Moments velocity_m_s;
};

class FlowStatistics {
 public:
  struct State {
    double time_s = 0.0;
    std::size_t particles = 0;
    std::map<long, SliceState> slices;
  };

  explicit FlowStatistics(const FlowWindow& window);  ///< refuses windows that hold nothing

  /// Times must increase.
  void add(double time_s, const DumpState& state);

  const FlowWindow& window() const { return window_; }
  /// From now on the part that counts is everything.
  void widen();
  const std::vector<State>& states() const { return states_; }
  const std::map<long, SliceProfile>& profile() const { return profile_; }
  double centre_m(long slice) const { return (static_cast<double>(slice) + 0.5) * window_.slice_m; }

  /// Slices that a flow is taken through: the option's, widened to whole slices; else the middle of
  /// the established part, 10 mm thick at most. Empty without particles there.
  std::optional<Interval> flow_slice_m(std::optional<Interval> wanted) const;
  /// Through [from, to] at every established state.
  std::vector<double> solids_flow_kg_s(const Interval& slice) const;
  std::vector<double> established_times_s() const;
  std::optional<double> mean_particles() const;  ///< everywhere, over the established states
  std::optional<double> velocity_mean_m_s() const, velocity_deviation_m_s() const;

 private:
  FlowWindow window_;
  std::vector<State> states_;
  std::map<long, SliceProfile> profile_;
  SliceProfile::Moments velocity_, velocity_everywhere_;
  double class_width_m_ = 0.0;
};

}  // namespace powderlink::analysis
