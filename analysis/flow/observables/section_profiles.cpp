// SPDX-License-Identifier: GPL-3.0-or-later
/// Profiles over the section in the part that counts, all established states together: over the
/// height, and over the distance r from the channel's axis.
///   share per height  N_i/(N dh) [1/m],  share per area  N_i/(N pi (r_2^2 - r_1^2)) [1/m^2]
///   velocity along the axis of the grains there: mean and standard deviation by number
/// A uniform stream in a round pipe has 1/(pi R^2) per area at every r.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "analysis/flow/observables/flow_observables.h"

namespace powderlink::analysis {

namespace {

namespace acc = boost::accumulators;

constexpr std::size_t kBins = 25;
constexpr std::size_t kEnough = 20;  // grains, for a mean that is drawn

using Bins = std::vector<SliceProfile::Moments>;

std::string row(double place_m, const SliceProfile::Moments& bin, double share) {
  const bool some = acc::count(bin) > 0;
  return fmt::format(
      "{:.6g},{},{:.6g},{},{}\n", place_m, acc::count(bin), share,
      some ? fmt::format("{:.6g}", acc::mean(bin)) : "",
      some ? fmt::format("{:.6g}", std::sqrt(std::max(0.0, acc::variance(bin)))) : "");
}

std::string why_not(const Bins& bins) {
  const auto full = std::count_if(bins.begin(), bins.end(),
                                  [](const auto& bin) { return acc::count(bin) >= kEnough; });
  if (full >= 2) return "";
  return fmt::format("fewer than two parts of the section hold {} particles or more", kEnough);
}

class SectionProfiles : public FlowObservable {
 public:
  SectionProfiles(const FlowWindow& window, const FlowChannelShape& shape)
      : window_(window), shape_(shape), height_(kBins), radius_(kBins) {
    if (shape.radius_m) half_m_ = *shape.radius_m;
  }

  void add(double /*time_s*/, const DumpState& state) override {
    const FlowAxis& axis = window_.axis;
    for (const DumpParticle& p : state.particles) {
      const Place place = place_of(p);
      if (!window_.holds(axis.place_m(place))) continue;
      const double up = place.at(axis.up()) - shape_.centre_m.at(axis.up());
      const double across = place.at(axis.across()) - shape_.centre_m.at(axis.across());
      const double r = std::hypot(up, across);
      // Without a mesh the first grains tell how wide the channel is.
      if (half_m_ == 0.0) half_m_ = widest(state);
      ++all_;
      add_to(height_, (up + half_m_) / (2.0 * half_m_), axis.velocity_m_s(p));
      add_to(radius_, r / half_m_, axis.velocity_m_s(p));
    }
  }

  FlowFindings find(const FlowScene& scene) override {
    FlowFindings found;
    const FlowAxis& axis = scene.window().axis;
    const char up = "xyz"[axis.up()];
    std::string heights =
        fmt::format("{}_m,count,share_1_m,velocity_mean_m_s,velocity_std_m_s\n", up);
    std::string radii = "r_m,count,share_1_m2,velocity_mean_m_s,velocity_std_m_s\n";
    const double wide = 2.0 * half_m_ / kBins, thin = half_m_ / kBins;
    const auto grains = static_cast<double>(all_);
    for (std::size_t i = 0; i < kBins && all_ > 0; ++i) {
      const double below = thin * static_cast<double>(i), above = below + thin;
      heights +=
          row(shape_.centre_m.at(axis.up()) - half_m_ + wide * (static_cast<double>(i) + 0.5),
              height_[i], static_cast<double>(acc::count(height_[i])) / grains / wide);
      const double area = boost::math::constants::pi<double>() * (above * above - below * below);
      radii += row(0.5 * (below + above), radius_[i],
                   static_cast<double>(acc::count(radius_[i])) / grains / area);
    }
    found.tables.emplace_back("section_height.csv", heights);
    found.tables.emplace_back("section_radius.csv", radii);
    found.figures.push_back({"section_height", "", why_not(height_)});
    found.figures.push_back({"section_radius", "", why_not(radius_)});
    return found;
  }

 private:
  double widest(const DumpState& state) const {
    double most = 0.0;
    for (const DumpParticle& p : state.particles) {
      const Place place = place_of(p);
      const double up = place.at(window_.axis.up()) - shape_.centre_m.at(window_.axis.up());
      const double across =
          place.at(window_.axis.across()) - shape_.centre_m.at(window_.axis.across());
      most = std::max(most, std::hypot(up, across) + p.radius_m);
    }
    return most;
  }

  /// Centres beyond the wall's own half width, of which there should be none, count at its edge.
  static void add_to(Bins& bins, double part, double velocity_m_s) {
    const double place = std::clamp(part * kBins, 0.0, kBins - 1.0);
    bins[static_cast<std::size_t>(place)](velocity_m_s);
  }

  FlowWindow window_;
  FlowChannelShape shape_;
  double half_m_ = 0.0;
  std::uint64_t all_ = 0;
  Bins height_, radius_;
};

}  // namespace

std::unique_ptr<FlowObservable> make_section_profiles(const FlowWindow& window,
                                                      const FlowChannelShape& shape) {
  return std::make_unique<SectionProfiles>(window, shape);
}

}  // namespace powderlink::analysis
