// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/run/flow_statistics.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <random>

#include "analysis/flow/observables/moving_average.h"
#include "tests/analysis/flow/flow_case.h"

namespace powderlink::analysis {
namespace {

const double kPi = std::acos(-1.0);

TEST(MovingAverage, SineKeepsTheShareOfSinc) {
  // 20 periods, 200 samples in each; the polygon's error is (pi/200)^2/3, below 1e-4.
  constexpr double kPolygon = 1e-4;
  for (const double window : {0.1, 0.5, 0.9, 1.3}) {  // in periods
    std::vector<double> times, values;
    times.reserve(4001);
    values.reserve(4001);
    for (int i = 0; i <= 4000; ++i) {
      times.push_back(i / 200.0);
      values.push_back(1.0 + 0.2 * std::sin(2.0 * kPi * times.back()));
    }
    // Cuts off what the window cannot reach, so that whole periods remain.
    const auto averages = moving_average(times, values, window);
    std::vector<std::optional<double>> whole(averages.begin() + 200, averages.begin() + 3800);
    const auto found = irregularity(whole);
    const double share = std::abs(std::sin(kPi * window) / (kPi * window));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->mean, 1.0, kPolygon);
    EXPECT_NEAR(found->rms_percent, 20.0 * share / std::sqrt(2.0), 20.0 * kPolygon) << window;
  }
}

TEST(MovingAverage, ExactForALineAndUnevenTimes) {
  const std::vector<double> times{0.0, 0.1, 0.35, 0.4, 0.8, 1.0};
  std::vector<double> values;
  for (const double t : times) values.push_back(2.0 - 3.0 * t);
  const auto averages = moving_average(times, values, 0.4);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool inside = times[i] >= 0.2 && times[i] <= 0.8 + 1e-12;
    ASSERT_EQ(static_cast<bool>(averages[i]), inside) << i;
    if (inside) {
      EXPECT_NEAR(*averages[i], values[i], 1e-14);
    }
  }
}

TEST(MovingAverage, SaysNothingWithoutAWholeWindow) {
  EXPECT_FALSE(irregularity(moving_average({0.0, 1.0}, {1.0, 2.0}, 3.0)));
  EXPECT_FALSE(irregularity(moving_average({0.0}, {1.0}, 3.0)));
  EXPECT_FALSE(irregularity(moving_average({}, {}, 3.0)));
}

FlowStatistics stream(const FlowWindow& window) {
  FlowStatistics statistics(window);
  for (long step = 0; step <= 5000; step += 500) {
    statistics.add(kStreamTimeStep_s * static_cast<double>(step), {step, {}, stream_at(step)});
  }
  return statistics;
}

TEST(FlowStatistics, UniformStream) {
  FlowWindow window;
  window.from_m = 0.2;
  const FlowStatistics s = stream(window);
  const auto slice = s.flow_slice_m({});
  ASSERT_TRUE(slice);
  EXPECT_NEAR(slice->to - slice->from, 0.01, 1e-12);
  EXPECT_NEAR(0.5 * (slice->to + slice->from), 0.25, 1e-3);
  for (const double flow : s.solids_flow_kg_s(*slice)) {
    EXPECT_NEAR(flow, kStreamFlow_kg_s, 1e-9 * kStreamFlow_kg_s);
  }
  EXPECT_EQ(s.mean_particles(), kStreamParticles);
  EXPECT_NEAR(*s.velocity_mean_m_s(), kStreamSpeed_m_s, 1e-12);
  EXPECT_NEAR(*s.velocity_deviation_m_s(), 0.0, 1e-9);
  // Ten particles per slice of 1 mm.
  for (const auto& state : s.states()) {
    const SliceState& middle = state.slices.at(150);
    EXPECT_EQ(middle.count, 10U);
    EXPECT_NEAR(middle.mass_kg, 10.0 * kStreamMass_kg, 1e-20);
  }
}

TEST(FlowStatistics, CountsOnlyTheEstablishedPart) {
  FlowWindow window;
  window.from_s = 2e-3;
  const FlowStatistics s = stream(window);
  EXPECT_EQ(s.established_times_s().size(), 7U);
  EXPECT_EQ(s.states().size(), 11U);
  const auto slice = s.flow_slice_m(Interval{0.1, 0.105});
  EXPECT_EQ(s.solids_flow_kg_s(*slice).size(), 7U);
  EXPECT_EQ(s.profile().at(150).up.count(), 70U);
}

TEST(FlowStatistics, SlicesAreWidenedToWholeOnes) {
  FlowWindow window;
  window.from_m = 0.2;
  const FlowStatistics s = stream(window);
  const auto slice = s.flow_slice_m(Interval{0.2004, 0.2041});
  EXPECT_NEAR(slice->from, 0.200, 1e-12);
  EXPECT_NEAR(slice->to, 0.205, 1e-12);
  // Edges that are whole slices but for rounding stay.
  EXPECT_NEAR(s.flow_slice_m(Interval{0.2, 0.3})->from, 0.2, 1e-12);
  EXPECT_NEAR(s.flow_slice_m(Interval{0.2, 0.3})->to, 0.3, 1e-12);
}

TEST(FlowStatistics, WidthOfAGaussianStream) {
  // Intervals of a normal distribution: 2 sigma quantile((1 + f)/2).
  constexpr double kSigma_m = 4e-4, kCentre_m = 1e-3;
  constexpr int kParticles = 200000;
  std::mt19937 random(7);
  std::normal_distribution<double> place(kCentre_m, kSigma_m), other(0.0, 2.0 * kSigma_m);
  DumpState state;
  for (int i = 0; i < kParticles; ++i) {
    DumpParticle p;
    p.x_m = place(random);
    p.y_m = other(random);
    p.z_m = 5e-4;
    p.radius_m = 3e-5;
    p.mass_kg = 1e-9;
    state.particles.push_back(p);
  }
  FlowStatistics s({});
  s.add(0.0, state);
  const SliceProfile& slice = s.profile().at(0);
  const boost::math::normal normal;
  for (const double share : {0.5, 0.9, 0.99}) {
    const double half = quantile(normal, 0.5 * (1.0 + share));
    // Standard error of a quantile, both ends: sqrt(2 q(1 - q)/n)/density; four of them.
    const double q = 0.5 * (1.0 + share);
    const double error = 4.0 * std::sqrt(2.0 * q * (1.0 - q) / kParticles) / pdf(normal, half);
    EXPECT_NEAR(slice.across.central_width(share) / kSigma_m, 2.0 * half, error) << share;
    EXPECT_NEAR(slice.up.central_width(share) / kSigma_m, 4.0 * half, 2.0 * error) << share;
  }
  EXPECT_NEAR(slice.across.quantile(0.5), kCentre_m, 4.0 * 1.26 * kSigma_m / std::sqrt(kParticles));
}

TEST(PlaceDistribution, QuantilesOfAUniformOneWithinAClass) {
  PlaceDistribution places(1e-3);
  for (int i = 999; i >= -1000; --i) places.add(1e-3 * (i + 0.5));  // grows to both sides
  for (const double share : {0.0, 0.05, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(places.quantile(share), 2.0 * share - 1.0, 1e-3 + 1e-12) << share;
  }
  EXPECT_TRUE(std::isnan(PlaceDistribution(1.0).quantile(0.5)));
  expect_refusal([&] { places.add(1e12); }, {"1e+12 m"});
}

TEST(FlowStatistics, RefusesUnusableWindowsAndTimes) {
  const auto with = [](auto change) {
    FlowWindow window;
    change(window);
    return [window] { FlowStatistics s(window); };
  };
  expect_refusal(with([](FlowWindow& w) { w.slice_m = 0.0; }), {"--slice-thickness"});
  expect_refusal(with([](FlowWindow& w) { w.from_m = 0.2, w.to_m = 0.1; }), {"--to-z"});
  expect_refusal(with([](FlowWindow& w) { w.from_s = std::nan(""); }), {"--from"});
  FlowStatistics s({});
  s.add(0.0, {0, {}, stream_at(0)});
  expect_refusal([&] { s.add(0.0, {1, {}, stream_at(1)}); }, {"earlier run"});
  DumpState far{2, {}, stream_at(0)};
  far.particles[0].z_m = 1e6;
  expect_refusal([&] { s.add(1.0, far); }, {"flew away"});
  expect_refusal([&] { s.flow_slice_m(Interval{0.3, 0.2}); }, {"--slice"});
}

}  // namespace
}  // namespace powderlink::analysis
