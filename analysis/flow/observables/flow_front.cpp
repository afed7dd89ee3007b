// SPDX-License-Identifier: GPL-3.0-or-later
/// The front at which grains that were thrown in rebound, jam and go on slower.
///   v(s) mean velocity along the axis in a hundred bins (channel_bins.h), weighed by mass
///   front: the first place downstream of the largest v at which v has fallen half-way to the mean
///   over the part that counts, linear between the bins
/// There is one only where v falls by kFall of its largest value. The value is that of all
/// established states together; its interval holds 95 % of the places in single states, so it says
/// how far the front moves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/flow/observables/channel_bins.h"
#include "analysis/flow/observables/flow_observables.h"

namespace powderlink::analysis {

namespace {

constexpr double kFall = 0.2;              // of the largest velocity
constexpr std::size_t kEnoughGrains = 20;  // grains in a bin, and states for an interval
constexpr double kFrontTail = 0.025;

struct Motion {
  std::array<std::size_t, ChannelBins::kCount> count{};
  std::array<double, ChannelBins::kCount> mass{}, momentum{};
};

class FlowFront : public FlowObservable {
 public:
  FlowFront(const FlowWindow& window, const FlowChannelShape& shape) : window_(window) {
    if (shape.reach_m) bins_.emplace(*shape.reach_m);
  }

  void add(double time_s, const DumpState& state) override {
    if (!bins_) return;
    Motion now;
    for (const DumpParticle& p : state.particles) {
      const auto bin = bins_->of(window_.axis.place_m(place_of(p)));
      if (!bin) continue;
      for (Motion* motion : {&now, &all_}) {
        ++motion->count[*bin];
        motion->mass[*bin] += p.mass_kg;
        motion->momentum[*bin] += p.mass_kg * window_.axis.velocity_m_s(p);
      }
    }
    if (const auto place = front_m(now)) places_.emplace_back(time_s, *place);
  }

  FlowFindings find(const FlowScene& /*scene*/) override {
    FlowFindings found;
    if (!bins_) return found;
    const auto front = front_m(all_);
    std::optional<Interval> moves;
    if (front && places_.size() >= kEnoughGrains) {
      std::vector<double> sorted;
      for (const auto& entry : places_) sorted.push_back(entry.second);
      std::sort(sorted.begin(), sorted.end());
      const auto rank = [&](double share) {
        return sorted[static_cast<std::size_t>(
            std::lround(share * static_cast<double>(sorted.size() - 1)))];
      };
      moves = Interval{rank(kFrontTail), rank(1.0 - kFrontTail)};
    }
    found.numbers.push_back({"front_m", front, moves});
    if (front) {
      found.text = fmt::format(
          "front, where the grains have lost half of their excess velocity: "
          "{} = {:.4g} mm\n",
          window_.axis.letter(), 1e3 * *front);
    }
    std::string text = fmt::format("time_s,{}_m\n", window_.axis.letter());
    for (const auto& [time_s, place_m] : places_) {
      text += fmt::format("{:.9g},{:.6g}\n", time_s, place_m);
    }
    found.tables.emplace_back("front.csv", text);
    found.figures.push_back({"front", "",
                             places_.size() < 2
                                 ? "grains do not slow down along the channel in two states or more"
                                 : ""});
    return found;
  }

 private:
  std::optional<double> front_m(const Motion& motion) const {
    // Downstream, whichever way the axis points.
    std::vector<std::pair<double, double>> profile;
    double mass = 0.0, momentum = 0.0;
    for (std::size_t i = 0; i < ChannelBins::kCount; ++i) {
      const std::size_t bin = window_.axis.way > 0 ? i : ChannelBins::kCount - 1 - i;
      if (motion.count[bin] < kEnoughGrains) continue;
      const double place = bins_->centre_m(bin);
      profile.emplace_back(place, motion.momentum[bin] / motion.mass[bin]);
      if (!window_.holds(place)) continue;
      mass += motion.mass[bin];
      momentum += motion.momentum[bin];
    }
    if (profile.empty() || !(mass > 0.0)) return {};
    auto at = std::max_element(profile.begin(), profile.end(),
                               [](const auto& a, const auto& b) { return a.second < b.second; });
    const double most = at->second, later = momentum / mass;
    if (!(most > 0.0 && most - later > kFall * most)) return {};
    const double half = 0.5 * (most + later);
    auto before = at;
    while (++at != profile.end() && at->second > half) before = at;
    if (at == profile.end()) return {};
    const double part = (before->second - half) / (before->second - at->second);
    return before->first + part * (at->first - before->first);
  }

  FlowWindow window_;
  std::optional<ChannelBins> bins_;
  Motion all_;
  std::vector<std::pair<double, double>> places_;
};

}  // namespace

std::unique_ptr<FlowObservable> make_flow_front(const FlowWindow& window,
                                                const FlowChannelShape& shape) {
  return std::make_unique<FlowFront>(window, shape);
}

}  // namespace powderlink::analysis
