// SPDX-License-Identifier: GPL-3.0-or-later
/// Mass flow through the outlet, from the counts of the grains that left, and the irregularity of a
/// stream with its interval and its counting floor (counting_floor.h).
///   flow(t) = (M(t + w/2) - M(t - w/2))/w,   M the mass that has left
///   rms     = RMS deviation of flow(t) from its mean, in per cent of it
/// The mean is M(end) - M(from) over the time between; its interval is that of K = T/w independent
/// windows, t_{K-1} rms/sqrt(K).
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/flow/observables/counting_floor.h"
#include "analysis/flow/observables/flow_observables.h"
#include "analysis/flow/observables/moving_average.h"
#include "analysis/flow/run/run_tables.h"

namespace powderlink::analysis {

namespace {

namespace acc = boost::accumulators;

constexpr double kSure = 0.975;         // both tails: 95 %
constexpr double kFewWindows = 5.0;     // fewer say nothing about an rms
constexpr double kTimeRounding = 1e-9;  // of times, which are printed with 6 digits or more
constexpr std::size_t kFewRows = 3;

/// Left mass at the times of the counts, linear between.
struct LeftMass {
  std::vector<double> times_s, mass_kg;

  double at(double time_s) const {
    const auto above = std::lower_bound(times_s.begin() + 1, times_s.end() - 1, time_s);
    const auto i = static_cast<std::size_t>(above - times_s.begin());
    const double part = (time_s - times_s[i - 1]) / (times_s[i] - times_s[i - 1]);
    return mass_kg[i - 1] + part * (mass_kg[i] - mass_kg[i - 1]);
  }

  /// Flow over windows around the times of the counts whose window is within the record.
  std::vector<std::optional<double>> flow_kg_s(double window_s) const {
    std::vector<std::optional<double>> flow(times_s.size());
    const double hair_s = kTimeRounding * window_s;
    for (std::size_t i = 0; i < times_s.size(); ++i) {
      const double from = times_s[i] - 0.5 * window_s, to = times_s[i] + 0.5 * window_s;
      if (from < times_s.front() - hair_s || to > times_s.back() + hair_s) continue;
      flow[i] = (at(to) - at(from)) / window_s;
    }
    return flow;
  }
};

class OutletFlow : public FlowObservable {
 public:
  void add(double /*time_s*/, const DumpState& state) override {
    for (const DumpParticle& p : state.particles) mass_kg_(p.mass_kg);
  }

  FlowFindings find(const FlowScene& scene) override {
    FlowFindings found;
    add_slice(scene, found);
    LeftMass left;
    std::vector<double> left_count;
    if (!read(scene, left, left_count, found)) return found;
    const double window_s = scene.measures.average_s;
    const double record_s = left.times_s.back() - left.times_s.front();
    const double rate_1_s = (left_count.back() - left_count.front()) / record_s;
    const double mean_kg_s = (left.mass_kg.back() - left.mass_kg.front()) / record_s;
    const auto flow = left.flow_kg_s(window_s);
    const auto rms = irregularity(flow);
    const double windows = std::floor(record_s / window_s + kTimeRounding);
    std::optional<Interval> of_mean;
    if (rms && windows >= 2.0) {
      const boost::math::students_t t(windows - 1.0);
      const double error =
          quantile(t, kSure) * rms->rms_percent / 100.0 * mean_kg_s / std::sqrt(windows);
      of_mean = Interval{mean_kg_s - error, mean_kg_s + error};
    }
    found.numbers.push_back({"outlet_flow_kg_s", mean_kg_s, of_mean});
    found.numbers.push_back({"outlet_grains_1_s", rate_1_s});
    if (!rms) {
      found.notes.push_back(
          fmt::format("no RMS of the flow through the outlet: "
                      "{} counts in {:g} s leave fewer than two averages over {:g} s, "
                      "or no grain left; run longer, or give a shorter --average",
                      left.times_s.size(), record_s, window_s));
    }
    const std::optional<double> floor =
        rate_1_s > 0.0 ? std::optional(100.0 * counting_floor(rate_1_s, window_s, variation(), 0))
                       : std::nullopt;
    found.numbers.push_back(
        {"outlet_flow_rms_percent", rms ? std::optional(rms->rms_percent) : std::nullopt,
         rms ? rms_interval(rms->rms_percent, record_s, window_s) : std::nullopt});
    found.numbers.push_back({"outlet_flow_rms_floor_percent", floor});
    if (rms && floor) {
      found.text = fmt::format(
          "outlet: {:.5g} kg/s, RMS {:.3g} % over {:g} s in {:.0f} windows; "
          "independent grains alone give {:.3g} %\n",
          mean_kg_s, rms->rms_percent, window_s, windows, *floor);
    }
    std::string table = fmt::format(
        "# mass that left over {:g} s around each time; mean {:.9g} kg/s\n"
        "time_s,left_kg,flow_kg_s\n",
        window_s, mean_kg_s);
    for (std::size_t i = 0; i < flow.size(); ++i) {
      table += fmt::format("{:.9g},{:.9g},{}\n", left.times_s[i], left.mass_kg[i],
                           flow[i] ? fmt::format("{:.9g}", *flow[i]) : "");
    }
    found.tables.emplace_back("outlet_flow.csv", table);
    found.figures.push_back({"outlet_flow",
                             fmt::format("mean_flow={:.9g}; rms={:.9g}; floor={:.9g}", mean_kg_s,
                                         rms ? rms->rms_percent : -1.0, floor.value_or(-1.0)),
                             rms ? "" : "there are fewer than two averages of the flow"});
    add_windows(left, rate_1_s, record_s, found);
    return found;
  }

 private:
  double variation() const {
    if (acc::count(mass_kg_) < 2) return 0.0;
    return std::sqrt(std::max(0.0, acc::variance(mass_kg_))) / acc::mean(mass_kg_);
  }

  /// Interval and floor of the flow through the slice, whose mean and rms the report has.
  void add_slice(const FlowScene& scene, FlowFindings& found) const {
    std::optional<double> floor;
    std::optional<Interval> interval;
    const auto times = scene.particles->established_times_s();
    const auto speed = scene.particles->velocity_mean_m_s();
    const auto& slice = scene.flow_slice_m;
    if (slice && speed && *speed > 0.0 && scene.irregularity_percent) {
      const double thickness_m = slice->to - slice->from;
      double grains = 0.0;
      const double dz = scene.window().slice_m;
      for (const auto& state : scene.particles->states()) {
        if (state.time_s < scene.window().from_s) continue;
        for (const auto& [k, content] : state.slices) {
          const double centre = scene.particles->centre_m(k);
          if (centre > slice->from - 0.1 * dz && centre < slice->to + 0.1 * dz) {
            grains += static_cast<double>(content.count);
          }
        }
      }
      grains /= static_cast<double>(times.size());
      const double rate_1_s = grains * *speed / thickness_m;
      if (rate_1_s > 0.0) {
        floor = 100.0 * counting_floor(rate_1_s, scene.measures.average_s, variation(),
                                       thickness_m / *speed);
      }
      interval = rms_interval(*scene.irregularity_percent, times.back() - times.front(),
                              scene.measures.average_s);
    }
    found.numbers.push_back({"solids_flow_rms_interval_percent",
                             interval ? scene.irregularity_percent : std::nullopt, interval});
    found.numbers.push_back({"solids_flow_rms_floor_percent", floor});
    found.numbers.push_back({"grain_mass_variation",
                             acc::count(mass_kg_) < 2 ? std::nullopt : std::optional(variation())});
  }

  bool read(const FlowScene& scene, LeftMass& left, std::vector<double>& count,
            FlowFindings& found) const {
    const auto counts = read_counts(scene.folder);
    for (const char* column : {"time_s", "escaped", "escaped_kg"}) {
      if (counts.count(column) != 0) continue;
      found.notes.push_back(
          fmt::format("no flow through the outlet: post/particle_count.csv has no column {}; "
                      "print what fix massflow/mesh has counted, as in foam_cases/pipe",
                      column));
      return false;
    }
    for (std::size_t i = 0; i < counts.at("time_s").size(); ++i) {
      DumpState moment;
      moment.time_s = counts.at("time_s")[i];
      const double time_s = scene.clock->gas_time_s(moment);
      if (time_s < scene.window().from_s) continue;
      left.times_s.push_back(time_s);
      left.mass_kg.push_back(counts.at("escaped_kg")[i]);
      count.push_back(counts.at("escaped")[i]);
    }
    if (left.times_s.size() >= kFewRows) return true;
    found.notes.push_back(
        fmt::format("no flow through the outlet: "
                    "post/particle_count.csv has {} rows from --from on; "
                    "run longer, or give an earlier --from",
                    left.times_s.size()));
    return false;
  }

  /// A slope of -1/2 in logarithms means single grains only.
  void add_windows(const LeftMass& left, double rate_1_s, double record_s,
                   FlowFindings& found) const {
    std::string table =
        "# RMS deviation of the flow through the outlet over the window; "
        "95 % interval of independent windows; floor of independent grains\n"
        "window_s,rms_percent,low_percent,high_percent,floor_percent\n";
    std::size_t rows = 0;
    const double step_s = record_s / static_cast<double>(left.times_s.size() - 1);
    for (double window_s = 2.0 * step_s; record_s >= kFewWindows * window_s; window_s *= 1.5) {
      const auto rms = irregularity(left.flow_kg_s(window_s));
      if (!rms || !(rate_1_s > 0.0)) continue;
      const auto interval = rms_interval(rms->rms_percent, record_s, window_s);
      if (!interval) continue;
      ++rows;
      table += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", window_s, rms->rms_percent,
                           interval->from, interval->to,
                           100.0 * counting_floor(rate_1_s, window_s, variation(), 0.0));
    }
    found.tables.emplace_back("outlet_rms.csv", table);
    found.figures.push_back(
        {"outlet_rms", "", rows < 2 ? "the record is too short for two windows" : ""});
  }

  SliceProfile::Moments mass_kg_;
};

}  // namespace

std::unique_ptr<FlowObservable> make_outlet_flow(const FlowWindow& /*window*/,
                                                 const FlowChannelShape& /*shape*/) {
  return std::make_unique<OutletFlow>();
}

}  // namespace powderlink::analysis
