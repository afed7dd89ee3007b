// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/flow_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace acc = boost::accumulators;

namespace {

constexpr double kFlowSlice_m = 0.01;
constexpr double kClassesPerRadius = 64.0;  // percentiles to 1.6 % of a particle's radius
constexpr double kMostSlices = 1e6;
constexpr double kSliceRounding = 1e-6;  // of a slice: 0.2/0.001 is not quite 200

long slice_of(double place_m, double slice_m, double rounding = 0.0) {
  return static_cast<long>(std::floor(place_m / slice_m + rounding));
}

}  // namespace

FlowStatistics::FlowStatistics(const FlowWindow& window) : window_(window) {
  const auto refuse = [](const char* option, double value, const char* allowed) {
    throw InvalidInput(std::string("option ") + option, number_text(value), allowed,
                       "correct the option; lengths are in metres, times in seconds");
  };
  if (!std::isfinite(window.from_s)) refuse("--from", window.from_s, "a time in seconds");
  if (!(window.from_m < std::numeric_limits<double>::infinity())) {
    refuse("--from-z", window.from_m, "a place in metres");
  }
  if (!(window.to_m > window.from_m)) refuse("--to-z", window.to_m, "above --from-z");
  if (!(window.slice_m > 0.0 && std::isfinite(window.slice_m))) {
    refuse("--slice-thickness", window.slice_m, "a length above 0 m");
  }
}

void FlowStatistics::add(double time_s, const DumpState& dumped) {
  if (!states_.empty() && !(time_s > states_.back().time_s)) {
    throw InvalidInput(
        "times of the dumps", fmt::format("{:g} s after {:g} s", time_s, states_.back().time_s),
        "increasing times, one state each", "remove the dumps of an earlier run from post/");
  }
  const bool established = time_s >= window_.from_s;
  if (class_width_m_ == 0.0 && !dumped.particles.empty()) {
    double sum = 0.0;
    for (const DumpParticle& p : dumped.particles) sum += p.radius_m;
    class_width_m_ = sum / static_cast<double>(dumped.particles.size()) / kClassesPerRadius;
  }
  State state{time_s, dumped.particles.size(), {}};
  const FlowAxis& axis = window_.axis;
  for (const DumpParticle& p : dumped.particles) {
    const Place place = place_of(p);
    const double along_m = axis.place_m(place), v_m_s = axis.velocity_m_s(p);
    if (!(std::abs(along_m) < kMostSlices * window_.slice_m)) {
      throw InvalidInput("place of particle " + std::to_string(p.id),
                         fmt::format("{} = {:g} m", axis.letter(), along_m),
                         fmt::format("at most {:g} slices of {:g} m", kMostSlices, window_.slice_m),
                         "give a larger --slice-thickness, or look for a particle that flew away");
    }
    const long k = slice_of(along_m, window_.slice_m);
    SliceState& slice = state.slices[k];
    ++slice.count;
    slice.mass_kg += p.mass_kg;
    slice.momentum_kg_m_s += p.mass_kg * v_m_s;
    if (!established) continue;
    SliceProfile& profile = profile_.try_emplace(k, class_width_m_).first->second;
    profile.across.add(place.at(axis.across()));
    profile.up.add(place.at(axis.up()));
    profile.velocity_m_s(v_m_s);
    velocity_everywhere_(v_m_s);
    if (window_.holds(along_m)) velocity_(v_m_s);
  }
  states_.push_back(std::move(state));
}

void FlowStatistics::widen() {
  window_.from_m = -std::numeric_limits<double>::infinity();
  window_.to_m = std::numeric_limits<double>::infinity();
  velocity_ = velocity_everywhere_;
}

std::optional<Interval> FlowStatistics::flow_slice_m(std::optional<Interval> wanted) const {
  const double dz = window_.slice_m;
  if (wanted) {
    if (!(wanted->to > wanted->from && std::isfinite(wanted->to - wanted->from))) {
      throw InvalidInput("option --slice", fmt::format("{:g} {:g}", wanted->from, wanted->to),
                         "two places on the axis in metres, the lower one first",
                         "such as 0.24 0.25");
    }
    return Interval{dz * static_cast<double>(slice_of(wanted->from, dz, kSliceRounding)),
                    dz * std::ceil(wanted->to / dz - kSliceRounding)};
  }
  if (profile_.empty()) return {};
  const double first_m =
      std::max(window_.from_m, dz * static_cast<double>(profile_.begin()->first));
  const long first = slice_of(first_m, dz, kSliceRounding);
  const double last_m = std::min(window_.to_m, dz * static_cast<double>(profile_.rbegin()->first));
  const long last = slice_of(last_m, dz, kSliceRounding);
  if (last < first) return {};
  const long all = last - first + 1;
  const long thick = std::clamp(std::lround(kFlowSlice_m / dz), 1L, all);
  const long from = first + (all - thick) / 2;
  return Interval{dz * static_cast<double>(from), dz * static_cast<double>(from + thick)};
}

std::vector<double> FlowStatistics::solids_flow_kg_s(const Interval& slice) const {
  const long first = slice_of(slice.from, window_.slice_m, 0.5);
  const long end = slice_of(slice.to, window_.slice_m, 0.5);
  const double thickness_m = static_cast<double>(end - first) * window_.slice_m;
  std::vector<double> flow;
  for (const State& state : states_) {
    if (state.time_s < window_.from_s) continue;
    double momentum = 0.0;
    for (auto at = state.slices.lower_bound(first); at != state.slices.end() && at->first < end;
         ++at) {
      momentum += at->second.momentum_kg_m_s;
    }
    flow.push_back(momentum / thickness_m);
  }
  return flow;
}

std::vector<double> FlowStatistics::established_times_s() const {
  std::vector<double> times;
  for (const State& state : states_) {
    if (state.time_s >= window_.from_s) times.push_back(state.time_s);
  }
  return times;
}

std::optional<double> FlowStatistics::mean_particles() const {
  acc::accumulator_set<double, acc::stats<acc::tag::mean>> count;
  for (const State& state : states_) {
    if (state.time_s >= window_.from_s) count(static_cast<double>(state.particles));
  }
  if (acc::count(count) == 0) return {};
  return acc::mean(count);
}

std::optional<double> FlowStatistics::velocity_mean_m_s() const {
  if (acc::count(velocity_) == 0) return {};
  return acc::mean(velocity_);
}

std::optional<double> FlowStatistics::velocity_deviation_m_s() const {
  if (acc::count(velocity_) < 2) return {};
  return std::sqrt(std::max(0.0, acc::variance(velocity_)));
}

}  // namespace powderlink::analysis
