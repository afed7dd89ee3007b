// SPDX-License-Identifier: GPL-3.0-or-later
/// Clusters of grains in the part that counts: neighbouring slices with more than `threshold` times
/// the mean number per length, over a length or more (cluster_runs.h). Of each state: how many, their
/// length, the velocity of the grains in them (by mass) and the share of the mass that they hold;
/// beside it how many independent grains would show by chance.
#include <fmt/format.h>

#include <cmath>

#include "analysis/flow/observables/cluster_runs.h"
#include "analysis/flow/observables/flow_observables.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kSliceRounding = 1e-6;  // of a slice

class Clusters : public FlowObservable {
 public:
  FlowFindings find(const FlowScene& scene) override {
    FlowFindings found;
    const FlowMeasures& measures = scene.measures;
    check(measures);
    const auto part = slices(scene);
    if (!part) return found;
    const auto [first, end] = *part;
    const auto count = static_cast<std::size_t>(end - first);
    const double ds = scene.window().slice_m;
    double grains = 0.0, mass = 0.0, momentum = 0.0;
    std::size_t states = 0;
    for_states(scene, [&](const FlowStatistics::State& state) {
      ++states;
      for (long k = first; k < end; ++k) {
        const SliceState slice = at(state, k);
        grains += static_cast<double>(slice.count);
        mass += slice.mass_kg;
        momentum += slice.momentum_kg_m_s;
      }
    });
    if (!(grains > 0.0)) return found;
    const double mean = grains / static_cast<double>(states * count);
    const double threshold = measures.cluster_threshold * mean;
    const auto shortest = static_cast<std::size_t>(
        std::max(1.0, std::ceil(measures.cluster_length_m / ds - kSliceRounding)));
    const char letter = scene.window().axis.letter();
    std::string table = fmt::format(
        "# slices of {:g} m with more than {:g} times the mean of {:.6g} grains, "
        "over {:g} m or more\n"
        "time_s,{}_m,length_m,count,mass_kg,velocity_m_s\n",
        ds, measures.cluster_threshold, mean, static_cast<double>(shortest) * ds, letter);
    std::size_t clusters = 0;
    double lengths = 0.0, held = 0.0, carried = 0.0;
    for_states(scene, [&](const FlowStatistics::State& state) {
      std::vector<double> numbers;
      for (long k = first; k < end; ++k) {
        numbers.push_back(static_cast<double>(at(state, k).count));
      }
      for (const ClusterRun& run : cluster_runs(numbers, threshold, shortest)) {
        SliceState all;
        for (std::size_t i = run.first; i < run.end; ++i) {
          const SliceState slice = at(state, first + static_cast<long>(i));
          all.count += slice.count;
          all.mass_kg += slice.mass_kg;
          all.momentum_kg_m_s += slice.momentum_kg_m_s;
        }
        const double length = static_cast<double>(run.end - run.first) * ds;
        const double low = static_cast<double>(first + static_cast<long>(run.first)) * ds;
        table +=
            fmt::format("{:.9g},{:.6g},{:.6g},{},{:.6g},{:.6g}\n", state.time_s, low + 0.5 * length,
                        length, all.count, all.mass_kg, all.momentum_kg_m_s / all.mass_kg);
        ++clusters;
        lengths += length;
        held += all.mass_kg;
        carried += all.momentum_kg_m_s;
      }
    });
    const auto number = static_cast<double>(clusters);
    const double per_state = number / static_cast<double>(states);
    const auto when_some = [&](double value) {
      return clusters > 0 ? std::optional(value) : std::nullopt;
    };
    const double by_chance = runs_by_chance(mean, threshold, shortest, count);
    found.numbers = {{"cluster_count", per_state},
                     {"cluster_count_by_chance", by_chance},
                     {"cluster_length_m", when_some(lengths / number)},
                     {"cluster_velocity_m_s", when_some(carried / held)},
                     {"cluster_velocity_over_mean", when_some(carried / held * mass / momentum)},
                     {"cluster_mass_percent", 100.0 * held / mass}};
    found.tables.emplace_back("clusters.csv", table);
    found.figures.push_back({"clusters", "", clusters == 0 ? "no state has a cluster" : ""});
    found.text = fmt::format(
        "clusters: {:.3g} at a time (independent grains: {:.3g}){}\n", per_state, by_chance,
        clusters == 0 ? ""
                      : fmt::format(", {:.3g} mm long, at {:.3g} m/s, with {:.3g} % of the mass",
                                    1e3 * lengths / number, carried / held, 100.0 * held / mass));
    return found;
  }

 private:
  static void check(const FlowMeasures& measures) {
    if (!(measures.cluster_threshold > 1.0 && std::isfinite(measures.cluster_threshold))) {
      throw InvalidInput("option --cluster-threshold", number_text(measures.cluster_threshold),
                         "above 1: times the mean number per length", "such as 1.5");
    }
    if (!(measures.cluster_length_m > 0.0 && std::isfinite(measures.cluster_length_m))) {
      throw InvalidInput("option --cluster-length", number_text(measures.cluster_length_m) + " m",
                         "above 0 m", "such as 2e-3");
    }
  }

  /// Whole slices of the part that counts, within the channel.
  static std::optional<std::pair<long, long>> slices(const FlowScene& scene) {
    const FlowWindow& window = scene.window();
    if (scene.particles->profile().empty()) return {};
    double from = window.from_m, to = window.to_m;
    const double ds = window.slice_m;
    const double first = static_cast<double>(scene.particles->profile().begin()->first) * ds;
    const double last = static_cast<double>(scene.particles->profile().rbegin()->first + 1) * ds;
    from = std::max(from, scene.reach_m ? scene.reach_m->from : first);
    to = std::min(to, scene.reach_m ? scene.reach_m->to : last);
    const long low = std::lround(std::ceil(from / ds - kSliceRounding));
    const long high = std::lround(std::floor(to / ds + kSliceRounding));
    if (high <= low) return {};
    return std::pair(low, high);
  }

  static SliceState at(const FlowStatistics::State& state, long k) {
    const auto slice = state.slices.find(k);
    return slice == state.slices.end() ? SliceState{} : slice->second;
  }

  template <class Use>
  static void for_states(const FlowScene& scene, const Use& use) {
    for (const auto& state : scene.particles->states()) {
      if (state.time_s >= scene.window().from_s) use(state);
    }
  }
};

}  // namespace

std::unique_ptr<FlowObservable> make_clusters(const FlowWindow& /*window*/,
                                              const FlowChannelShape& /*shape*/) {
  return std::make_unique<Clusters>();
}

}  // namespace powderlink::analysis
