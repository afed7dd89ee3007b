// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/frame_choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/render/plate.h"

namespace powderlink::render {
namespace {

constexpr double kGravity = 9.81;

std::map<long, bool> attached_by_id(const State& state) {
  std::map<long, bool> flags;
  for (const Grain& grain : state.grains) flags[grain.id] = grain.attached;
  return flags;
}

struct Extent {
  double low = 0.0, high = 0.0;
  double length() const { return high - low; }
};

template <class Coordinate>
Extent extent(const std::vector<Grain>& grains, Coordinate coordinate) {
  Extent found{HUGE_VAL, -HUGE_VAL};
  for (const Grain& grain : grains) {
    found.low = std::min(found.low, coordinate(grain) - 0.5 * grain.diameter_um);
    found.high = std::max(found.high, coordinate(grain) + 0.5 * grain.diameter_um);
  }
  return found;
}

}  // namespace

std::size_t State::attached() const {
  return static_cast<std::size_t>(std::count_if(grains.begin(), grains.end(),
                                                [](const Grain& grain) { return grain.attached; }));
}

State read_state(const RunDirectory& run, std::size_t index, const std::string& fix) {
  const DumpFile& file = run.particles.at(index);
  const double clock = run.time_step_s ? run.time_s(file.step) : static_cast<double>(file.step);
  return {file.step, clock, 0.0, 1e6 * plate_height_m(run, file.step),
          grains_of(read_particles(file.path, fix))};
}

State fly(const State& last, double duration_s) {
  State later = last;
  later.clock += duration_s;
  later.flight_s += duration_s;
  for (Grain& grain : later.grains) {
    if (grain.attached) continue;
    grain.z_um -= 1e6 * duration_s * (grain.speed_m_s + 0.5 * kGravity * duration_s);
    grain.speed_m_s += kGravity * duration_s;
  }
  return later;
}

double flight_time_s(const State& last, const State& before, const ViewWindow& window,
                     double share) {
  ViewWindow bottomless = window;
  bottomless.depth_um = HUGE_VAL;
  double shortest = HUGE_VAL;
  for (const Grain& grain : grains_in(last, before, bottomless)) {
    if (grain.attached) continue;
    const double left_m =
        1e-6 * (share * window.depth_um - (last.plate_z_um - grain.z_um + 0.5 * grain.diameter_um));
    const double v = std::max(0.0, grain.speed_m_s);
    const double time =
        left_m <= 0.0 ? 0.0 : (std::sqrt(v * v + 2.0 * kGravity * left_m) - v) / kGravity;
    shortest = std::min(shortest, time);
  }
  return std::isfinite(shortest) ? shortest : 0.0;
}

std::size_t state_before(const std::vector<State>& states) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i].attached() >= states[best].attached()) best = i;
  }
  return best;
}

ViewWindow choose_window(const State& before, const State& end, double columns,
                         double breadth_over_width, double depth_over_width) {
  ViewWindow window;
  if (before.grains.empty()) return window;
  const Extent x = extent(before.grains, [](const Grain& g) { return g.x_um; });
  const Extent y = extent(before.grains, [](const Grain& g) { return g.y_um; });
  const double pitch = std::sqrt(std::max(x.length() * y.length(), 1e-12) /
                                 static_cast<double>(before.grains.size()));
  window.width_um = std::min(columns * pitch, x.length());
  window.breadth_um = std::min(breadth_over_width * columns * pitch, y.length());
  // A row or a few grains: keep room for the largest one.
  double largest = 0.0;
  for (const Grain& grain : before.grains) largest = std::max(largest, grain.diameter_um);
  window.width_um = std::max(window.width_um, 6.0 * largest);
  window.breadth_um = std::max(window.breadth_um, 2.0 * largest);
  window.depth_um = depth_over_width * window.width_um;

  const auto flags = attached_by_id(end);
  constexpr int kPlaces = 9;
  double best = -1.0;
  ViewWindow candidate = window;
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const double u = (i + 0.5) / kPlaces, v = (j + 0.5) / kPlaces;
      const double free_x = std::max(0.0, x.length() - window.width_um);
      const double free_y = std::max(0.0, y.length() - window.breadth_um);
      candidate.x_um = 0.5 * (x.low + x.high) + (u - 0.5) * free_x;
      candidate.y_um = 0.5 * (y.low + y.high) + (v - 0.5) * free_y;
      double stay = 0.0, leave = 0.0;
      for (const Grain& grain : before.grains) {
        const auto flag = flags.find(grain.id);
        if (!candidate.holds(grain)) continue;
        (flag != flags.end() && flag->second ? stay : leave) += 1.0;
      }
      // Both kinds count; the middle of the plate wins between equals.
      const double score =
          std::sqrt(stay * leave) + 1e-3 * (stay + leave) - 1e-3 * std::hypot(u - 0.5, v - 0.5);
      if (score > best) {
        best = score;
        window = candidate;
      }
    }
  }
  return window;
}

std::vector<Grain> grains_in(const State& state, const State& before, const ViewWindow& window) {
  std::vector<long> watched;
  for (const Grain& grain : before.grains) {
    if (window.holds(grain)) watched.push_back(grain.id);
  }
  std::sort(watched.begin(), watched.end());
  const double lowest = state.plate_z_um - window.depth_um;
  std::vector<Grain> shown;
  for (const Grain& grain : state.grains) {
    if (grain.z_um - 0.5 * grain.diameter_um >= lowest &&
        std::binary_search(watched.begin(), watched.end(), grain.id)) {
      shown.push_back(grain);
    }
  }
  return shown;
}

std::vector<std::size_t> choose_states(const std::vector<State>& states, const ViewWindow& window,
                                       std::size_t count) {
  const std::size_t first = state_before(states);
  const auto end = attached_by_id(states.back());
  std::size_t leaving = 0;
  const auto leaves = [&](const Grain& grain) {
    const auto flag = end.find(grain.id);
    return flag == end.end() || !flag->second;
  };
  for (const Grain& grain : states[first].grains) {
    if (window.holds(grain) && leaves(grain)) ++leaving;
  }
  // The last state that still shows most of what leaves.
  std::size_t last = std::min(first + 1, states.size() - 1);
  for (std::size_t i = last; i < states.size(); ++i) {
    const auto shown = grains_in(states[i], states[first], window);
    const auto visible =
        static_cast<std::size_t>(std::count_if(shown.begin(), shown.end(), leaves));
    if (4 * visible >= 3 * leaving) last = i;
  }
  if (count <= 1) return {last};
  std::vector<std::size_t> chosen;
  const double start = states[first].clock;
  const double span = states[last].clock - start;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = start + span * static_cast<double>(k) / static_cast<double>(count - 1);
    std::size_t nearest = first;
    for (std::size_t i = first; i <= last; ++i) {
      if (std::abs(states[i].clock - wanted) < std::abs(states[nearest].clock - wanted)) {
        nearest = i;
      }
    }
    if (chosen.empty() || chosen.back() != nearest) chosen.push_back(nearest);
  }
  return chosen;
}

}  // namespace powderlink::render
