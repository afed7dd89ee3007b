// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/reduced/critical_diameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "analysis/kat/reduced/critical_speed.h"
#include "physics/kat/kat_theory.h"

namespace powderlink::analysis {

std::string CriticalDiameter::text_um() const {
  switch (state) {
    case State::nothing_detaches:
      return fmt::format("> {:.0f} (nothing detaches)", diameter_m * 1e6);
    case State::everything_detaches:
      return fmt::format("< {:.1f} (everything detaches)", diameter_m * 1e6);
    case State::found:
      break;
  }
  return fmt::format("{:.2f}", diameter_m * 1e6);
}

TheoryDiameter theory_diameter(const ReducedModel& model, double impact_velocity) {
  const KatSetup& setup = model.setup();
  const double density = setup.particle.density_kg_m3;
  const TheoryDiameter instant{
      physics::critical_diameter_instant_m(model.smooth_law(), density,
                                           setup.stop.speed_change_m_s(impact_velocity)),
      "instant stop"};
  if (setup.stop.shape() == physics::StopPulse::Shape::instant) return instant;
  const TheoryDiameter slow{
      physics::critical_diameter_slow_m(setup.work_of_adhesion_J_m2, density,
                                        setup.stop.peak_deceleration_m_s2(impact_velocity)),
      "slow stop"};
  // No stop is more violent than the instant one, so the slow limit counts only above it.
  return slow.diameter_m > instant.diameter_m ? slow : instant;
}

CriticalDiameter critical_diameter(const ReducedModel& model, double impact_velocity,
                                   double relative_tolerance) {
  CriticalDiameter result;
  double attached = 0.0;
  double detached = 0.0;
  const auto leaves = [&](double diameter) {
    ++result.drops;
    const bool left = model.detaches(diameter, impact_velocity);
    (left ? detached : attached) = diameter;
    return left;
  };

  // From the closed form outwards in growing strides, until one is on either side.
  constexpr double first_stride = 1.02;
  double stride = first_stride;
  double diameter = std::clamp(theory_diameter(model, impact_velocity).diameter_m,
                               kSmallestDiameter_m, kLargestDiameter_m);
  while (true) {
    const bool left = leaves(diameter);
    if (attached > 0.0 && detached > 0.0) break;
    if (diameter == (left ? kSmallestDiameter_m : kLargestDiameter_m)) {
      result.state = left ? CriticalDiameter::State::everything_detaches
                          : CriticalDiameter::State::nothing_detaches;
      result.diameter_m = diameter;
      result.largest_attached_m = attached;
      result.smallest_detached_m = detached;
      return result;
    }
    diameter = std::clamp(left ? diameter / stride : diameter * stride, kSmallestDiameter_m,
                          kLargestDiameter_m);
    stride *= stride;
  }
  while (detached - attached > relative_tolerance * attached)
    leaves(std::sqrt(attached * detached));
  result.largest_attached_m = attached;
  result.smallest_detached_m = detached;
  result.diameter_m = std::sqrt(attached * detached);
  return result;
}

CriticalDiameter quick_critical_diameter(const ReducedModel& model, double impact_velocity,
                                         bool estimates) {
  constexpr double integrated_tolerance = 3e-4;
  constexpr double root_tolerance = 1e-8;  // of ln d
  constexpr boost::uintmax_t most_turns = 60;
  const CriticalSpeed critical(model, estimates);
  if (!critical.available()) return critical_diameter(model, impact_velocity, integrated_tolerance);

  const double speed_change = model.setup().stop.speed_change_m_s(impact_velocity);
  const auto excess = [&](double log_diameter) {
    constexpr double slowest = 1e-9;  // of the speed change: the logarithm must stay finite
    const double needed = critical.speed_change_m_s(std::exp(log_diameter));
    return std::log(std::max(needed / speed_change, slowest));
  };
  const double smallest = std::log(kSmallestDiameter_m);
  const double largest = std::log(kLargestDiameter_m);
  double low =
      std::clamp(std::log(theory_diameter(model, impact_velocity).diameter_m), smallest, largest);
  double high = low;
  double at_low = excess(low);
  double at_high = at_low;
  double stride = 0.05;
  CriticalDiameter result;
  while (at_low < 0.0 || at_high > 0.0) {  // large particles need less speed
    const bool too_large = at_low < 0.0;
    if (low == smallest && too_large) {
      result.state = CriticalDiameter::State::everything_detaches;
      result.diameter_m = kSmallestDiameter_m;
      return result;
    }
    if (high == largest && !too_large) {
      result.state = CriticalDiameter::State::nothing_detaches;
      result.diameter_m = kLargestDiameter_m;
      return result;
    }
    if (too_large) {
      high = low;
      at_high = at_low;
      low = std::max(low - stride, smallest);
      at_low = excess(low);
    } else {
      low = high;
      at_low = at_high;
      high = std::min(high + stride, largest);
      at_high = excess(high);
    }
    stride *= 2.0;
  }
  if (at_low != 0.0 && at_high != 0.0) {
    boost::uintmax_t turns = most_turns;
    const auto root = boost::math::tools::toms748_solve(
        excess, low, high, at_low, at_high,
        [](double a, double b) { return std::fabs(b - a) <= root_tolerance; }, turns);
    low = root.first;
    high = root.second;
  } else {
    (at_low == 0.0 ? high : low) = at_low == 0.0 ? low : high;
  }
  result.diameter_m = result.largest_attached_m = result.smallest_detached_m =
      std::exp(0.5 * (low + high));
  return result;
}

}  // namespace powderlink::analysis
