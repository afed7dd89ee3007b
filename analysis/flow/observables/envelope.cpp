// SPDX-License-Identifier: GPL-3.0-or-later
/// Lowest and highest place of a grain's centre in each of a hundred bins along the channel
/// (channel_bins.h), over all established states.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "analysis/flow/observables/channel_bins.h"
#include "analysis/flow/observables/flow_observables.h"

namespace powderlink::analysis {

namespace {

class Envelope : public FlowObservable {
 public:
  Envelope(const FlowWindow& window, const FlowChannelShape& shape) : axis_(window.axis) {
    if (shape.reach_m) bins_.emplace(*shape.reach_m);
    lowest_.fill(std::numeric_limits<double>::infinity());
    highest_.fill(-std::numeric_limits<double>::infinity());
  }

  void add(double /*time_s*/, const DumpState& state) override {
    if (!bins_) return;
    for (const DumpParticle& p : state.particles) {
      const Place place = place_of(p);
      const auto bin = bins_->of(axis_.place_m(place));
      if (!bin) continue;
      ++count_[*bin];
      lowest_[*bin] = std::min(lowest_[*bin], place.at(axis_.up()));
      highest_[*bin] = std::max(highest_[*bin], place.at(axis_.up()));
    }
  }

  FlowFindings find(const FlowScene& /*scene*/) override {
    FlowFindings found;
    if (!bins_) return found;
    std::string text = fmt::format(
        "# centres of grains, all established states together\n"
        "{0}_m,count,{1}_lowest_m,{1}_highest_m\n",
        axis_.letter(), "xyz"[axis_.up()]);
    std::size_t some = 0;
    for (std::size_t i = 0; i < ChannelBins::kCount; ++i) {
      if (count_[i] == 0) {
        text += fmt::format("{:.6g},0,,\n", bins_->centre_m(i));
        continue;
      }
      ++some;
      text += fmt::format("{:.6g},{},{:.6g},{:.6g}\n", bins_->centre_m(i), count_[i], lowest_[i],
                          highest_[i]);
    }
    found.tables.emplace_back("envelope.csv", text);
    found.figures.push_back({"envelope", "", some < 2 ? "fewer than two bins hold a grain" : ""});
    return found;
  }

 private:
  FlowAxis axis_;
  std::optional<ChannelBins> bins_;
  std::array<std::size_t, ChannelBins::kCount> count_{};
  std::array<double, ChannelBins::kCount> lowest_{}, highest_{};
};

}  // namespace

std::unique_ptr<FlowObservable> make_envelope(const FlowWindow& window,
                                              const FlowChannelShape& shape) {
  return std::make_unique<Envelope>(window, shape);
}

}  // namespace powderlink::analysis
