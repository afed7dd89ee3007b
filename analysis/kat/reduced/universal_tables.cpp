// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/reduced/universal_tables.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "analysis/kat/reduced/reduced_model.h"
#include "physics/effects/laws/rate_dependent_adhesion.h"

namespace powderlink::analysis {

using physics::StopPulse;

namespace {

// Any sphere will do: the factors do not depend on it.
constexpr double kDiameter_m = 50e-6;
constexpr double kTolerance = 3e-4;  // of the speed at a node
constexpr double kWidest = 1e12;     // brackets are not widened beyond this factor

KatSetup reference() {
  KatSetup s;
  s.particle = s.substrate = physics::Material{"reference", 2500.0, 7e10, 0.2};
  s.work_of_adhesion_J_m2 = 1.0;
  s.gravity_m_s2 = 0.0;
  return s;
}

/// The least impact speed that takes the sphere off, over its escape speed.
double factor_of(const KatSetup& setup) {
  constexpr double guess = 1.05;
  const ReducedModel model(setup);
  const double escape = model.at_rest(kDiameter_m).escape_speed_m_s;
  const auto leaves = [&](double factor) { return model.detaches(kDiameter_m, factor * escape); };
  double low = guess;
  double high = guess;
  double stride = 1.1;
  if (leaves(guess)) {
    while (leaves(low) && low > guess / kWidest) {
      high = low;
      low /= stride;
      stride *= stride;
    }
  } else {
    while (!leaves(high) && high < guess * kWidest) {
      low = high;
      high *= stride;
      stride *= stride;
    }
  }
  while (high - low > kTolerance * low) {
    const double middle = std::sqrt(low * high);
    (leaves(middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

/// Nodes of a function of two coordinates on a regular grid, filled on demand; cubic in between
/// (Catmull-Rom), so that its slope is continuous for the fits.
class LazyGrid {
 public:
  using Node = std::function<double(double x, double y)>;
  LazyGrid(double step_x, double step_y, Node node)
      : step_x_(step_x),
        step_y_(step_y),
        node_(std::move(node)),
        nodes_(static_cast<std::size_t>(4 * kHalf * kHalf)) {
    for (auto& node_value : nodes_) node_value = std::numeric_limits<double>::quiet_NaN();
  }

  double at(double x, double y) {
    const Place px = place(x / step_x_);
    const Place py = place(y / step_y_);
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double weight = px.weight[i] * py.weight[j];
        if (weight != 0.0) sum += weight * value(px.first + i, py.first + j);
      }
    }
    return std::exp(sum);
  }

 private:
  struct Place {
    int first;
    std::array<double, 4> weight;
  };
  static Place place(double at) {
    const double cell = std::floor(at);
    const double t = at - cell;
    return {static_cast<int>(cell) - 1,
            {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
             0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)}};
  }
  static constexpr int kHalf = 64;  // nodes on either side of zero; beyond, the edge's value holds

  std::atomic<double>& slot(int i, int j) {
    const auto row = static_cast<std::size_t>(std::clamp(i, -kHalf, kHalf - 1) + kHalf);
    const auto column = static_cast<std::size_t>(std::clamp(j, -kHalf, kHalf - 1) + kHalf);
    return nodes_[row * 2 * kHalf + column];
  }
  double value(int i, int j) {
    std::atomic<double>& node = slot(i, j);
    const double known = node.load(std::memory_order_relaxed);
    if (!std::isnan(known)) return known;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::isnan(node.load(std::memory_order_relaxed))) {
      i = std::clamp(i, -kHalf, kHalf - 1);
      j = std::clamp(j, -kHalf, kHalf - 1);
      node.store(std::log(node_(i * step_x_, j * step_y_)), std::memory_order_relaxed);
    }
    return node.load(std::memory_order_relaxed);
  }

  double step_x_, step_y_;
  Node node_;
  std::mutex mutex_;
  std::vector<std::atomic<double>> nodes_;
};

StopPulse pulse(StopPulse::Shape shape, double tau_s) {
  return shape == StopPulse::Shape::hertz ? StopPulse::hertz(tau_s) : StopPulse::half_sine(tau_s);
}

}  // namespace

double slowness_factor(StopPulse::Shape shape, double periods) {
  // Shorter stops are instant, longer ones slow, to better than the tolerance of the table.
  constexpr double instant_below = 0.02;
  constexpr double slow_above = 400.0;
  static constexpr double step = 0.15;  // of the logarithm
  const KatSetup setup = reference();
  static const ReducedModel model(setup);
  static const double period = model.at_rest(kDiameter_m).period_s;
  if (periods < instant_below) return 1.0;
  if (periods > slow_above) {
    const double radius = 0.5 * kDiameter_m;
    const physics::JkrLaw law = model.law(radius);
    const double mass =
        4.0 / 3.0 * physics::JkrLaw::kPi * radius * radius * radius * setup.particle.density_kg_m3;
    const double peak = pulse(shape, periods * period).peak_deceleration_m_s2(1.0);
    return law.pull_off_force_N(radius) / (mass * peak) /
           model.at_rest(kDiameter_m).escape_speed_m_s;
  }
  static const auto grid = [](StopPulse::Shape of) {
    return std::make_unique<LazyGrid>(step, 1.0, [of](double x, double) {
      KatSetup s = reference();
      s.stop = pulse(of, std::exp(x) * period);
      return factor_of(s);
    });
  };
  static const auto half_sine = grid(StopPulse::Shape::half_sine);
  static const auto hertz = grid(StopPulse::Shape::hertz);
  return (shape == StopPulse::Shape::hertz ? hertz : half_sine)->at(std::log(periods), 0.0);
}

double moving_edge_factor(double reduced_speed, double exponent) {
  constexpr double step_speed = 0.7;  // of the logarithms
  constexpr double step_exponent = 0.35;
  static LazyGrid grid(step_speed, step_exponent, [](double x, double y) {
    KatSetup s = reference();
    static const ReducedModel model(s);
    static const double radius = 0.5 * kDiameter_m;
    static const double unit = model.law(radius).equilibrium_contact_radius_m(radius) /
                               model.at_rest(kDiameter_m).period_s;
    const double exponent_of_node = std::exp(y);
    s.effects = {physics::RateDependentAdhesion::unbounded(std::exp(x) * unit, exponent_of_node)};
    return factor_of(s);
  });
  return grid.at(std::log(reduced_speed), std::log(exponent));
}

}  // namespace powderlink::analysis
