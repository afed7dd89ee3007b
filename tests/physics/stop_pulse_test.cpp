// SPDX-License-Identifier: GPL-3.0-or-later
// The stop of the plate: momentum, peaks, a sampled pulse against its analytic shape, bad tables.
#include "physics/kat/stop_pulse.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "tests/physics/refuses.h"

namespace powderlink {
namespace {

using physics::StopPulse;
using test::refuses;

constexpr double kPi = 3.14159265358979323846;
constexpr double kQuadrature = 1e-12;  // double-exponential rule on a smooth pulse
constexpr double kRounding = 1e-13;
constexpr double kTau = 1e-4;
constexpr double kSpeed = 2.3;

double speed_change_by_quadrature(const StopPulse& p, double speed) {
  boost::math::quadrature::tanh_sinh<double> integrator;
  return integrator.integrate([&](double t) { return p.deceleration_m_s2(t, speed); }, 0.0,
                              p.duration_s());
}

StopPulse sampled_half_sine(int rows, double rebound, double scale = 1.0, double start = 0.0) {
  std::vector<double> t, a;
  for (int i = 0; i < rows; ++i) {
    t.push_back(start + kTau * i / (rows - 1));
    a.push_back(scale * std::sin(kPi * i / (rows - 1)));
  }
  return StopPulse::measured(t, a, rebound);
}

TEST(StopPulse, TakesTheMomentumOfThePlate) {
  for (const double rebound : {0.0, 0.4, 1.0}) {
    const double change = kSpeed * (1 + rebound);
    for (const StopPulse& p :
         {StopPulse::half_sine(kTau, rebound), StopPulse::hertz(kTau, rebound)}) {
      EXPECT_NEAR(speed_change_by_quadrature(p, kSpeed), change, kQuadrature * change);
      EXPECT_EQ(p.kick_m_s(kSpeed), 0.0);
      EXPECT_EQ(p.duration_s(), kTau);
      EXPECT_EQ(p.measured_speed_change_m_s(), 0.0);
    }
    const StopPulse instant = StopPulse::instant(rebound);
    EXPECT_NEAR(instant.kick_m_s(kSpeed), change, kRounding * change);
    EXPECT_EQ(instant.deceleration_m_s2(0.0, kSpeed), 0.0);
    EXPECT_EQ(instant.peak_deceleration_m_s2(kSpeed), 0.0);
  }
}

TEST(StopPulse, MeasuredTableTakesTheMomentumOfThePlate) {
  // Rows of different length and a stretch of the wrong sign, as accelerometers give them.
  const std::vector<double> t = {2e-5, 3e-5, 3.5e-5, 6e-5, 9e-5, 1.2e-4};
  const std::vector<double> a = {0.0, 40.0, 900.0, 1000.0, 300.0, -20.0};
  const StopPulse p = StopPulse::measured(t, a, 0.25);
  double change = 0.0, own = 0.0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    // Gauss's rule is exact on each straight piece.
    change += boost::math::quadrature::gauss<double, 7>::integrate(
        [&](double x) { return p.deceleration_m_s2(x, kSpeed); }, t[i - 1] - t[0], t[i] - t[0]);
    own += 0.5 * (a[i] + a[i - 1]) * (t[i] - t[i - 1]);
  }
  EXPECT_NEAR(change, 1.25 * kSpeed, kRounding * kSpeed);
  EXPECT_NEAR(p.measured_speed_change_m_s(), own, kRounding * own);
  EXPECT_NEAR(p.duration_s(), 1e-4, kRounding * 1e-4);
  const double scale = 1.25 * kSpeed / own;
  EXPECT_NEAR(p.peak_deceleration_m_s2(kSpeed), 1000.0 * scale, kRounding * 1000.0 * scale);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double middle = 0.5 * (t[i] + t[i + 1]) - t[0];
    EXPECT_NEAR(p.deceleration_m_s2(middle, kSpeed), 0.5 * (a[i] + a[i + 1]) * scale, 1e-9 * scale)
        << i;
  }
}

TEST(StopPulse, PeakValues) {
  for (const double rebound : {0.0, 0.7}) {
    const double half_sine = kPi * kSpeed * (1 + rebound) / (2 * kTau);
    EXPECT_NEAR(StopPulse::half_sine(kTau, rebound).peak_deceleration_m_s2(kSpeed), half_sine,
                kRounding * half_sine);
    boost::math::quadrature::tanh_sinh<double> integrator;
    const double mean =
        integrator.integrate([](double x) { return std::pow(std::sin(kPi * x), 1.5); }, 0.0, 1.0);
    const double hertz = kSpeed * (1 + rebound) / (kTau * mean);
    EXPECT_NEAR(StopPulse::hertz(kTau, rebound).peak_deceleration_m_s2(kSpeed), hertz,
                kQuadrature * hertz);
  }
}

TEST(StopPulse, ShapesAreSymmetricPositiveAndEndWithThePulse) {
  for (const StopPulse& p : {StopPulse::half_sine(kTau), StopPulse::hertz(kTau)}) {
    const double peak = p.peak_deceleration_m_s2(kSpeed);
    for (int i = 0; i <= 20; ++i) {
      const double t = kTau * i / 20;
      const double a = p.deceleration_m_s2(t, kSpeed);
      EXPECT_GE(a, -kRounding * peak);
      EXPECT_LE(a, peak * (1 + kRounding));
      EXPECT_NEAR(a, p.deceleration_m_s2(kTau - t, kSpeed), kRounding * peak);
    }
    EXPECT_EQ(p.deceleration_m_s2(-1e-12, kSpeed), 0.0);
    EXPECT_EQ(p.deceleration_m_s2(kTau * 1.0001, kSpeed), 0.0);
  }
}

TEST(StopPulse, SampledPulseConvergesToTheAnalyticOne) {
  const StopPulse analytic = StopPulse::half_sine(kTau, 0.3);
  const double peak = analytic.peak_deceleration_m_s2(kSpeed);
  const auto largest_error = [&](int rows) {
    const StopPulse p = sampled_half_sine(rows, 0.3);
    double error = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = p.duration_s() * i / 1000;
      error = std::max(
          error, std::fabs(p.deceleration_m_s2(t, kSpeed) - analytic.deceleration_m_s2(t, kSpeed)));
    }
    return error / peak;
  };
  const double coarse = largest_error(51);
  const double fine = largest_error(201);
  // Straight pieces of length h: (pi h)^2/8 between the rows, and (pi h)^2/12 from the area.
  EXPECT_LT(coarse, std::pow(kPi / 50, 2) * (1.0 / 8 + 1.0 / 12));
  constexpr double order_error = 0.1;
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2.0, order_error) << "second order";
}

TEST(StopPulse, OnlyTheShapeOfATableCounts) {
  const StopPulse p = sampled_half_sine(41, 0.0);
  const StopPulse scaled = sampled_half_sine(41, 0.0, 9.81e3);
  const StopPulse later = sampled_half_sine(41, 0.0, 1.0, 7.0 * kTau);
  const double peak = p.peak_deceleration_m_s2(kSpeed);
  for (double t = 0; t < kTau; t += 0.037 * kTau) {
    EXPECT_NEAR(scaled.deceleration_m_s2(t, kSpeed), p.deceleration_m_s2(t, kSpeed),
                kRounding * peak);
    EXPECT_NEAR(later.deceleration_m_s2(t, kSpeed), p.deceleration_m_s2(t, kSpeed),
                100 * kRounding * peak);
  }
}

TEST(StopPulse, RefusesBadDurationsAndRebounds) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1e-4, nan, infinity}) {
    EXPECT_TRUE(refuses([bad] { StopPulse::half_sine(bad); }, "stop duration"));
    EXPECT_TRUE(refuses([bad] { StopPulse::hertz(bad); }, "stop duration"));
  }
  EXPECT_TRUE(refuses([] { StopPulse::hertz(-2e-9); }, "stop duration", "-2e-09"))
      << "small values must be readable";
  for (const double bad : {-0.1, 1.1, nan}) {
    EXPECT_TRUE(refuses([bad] { StopPulse::half_sine(1e-4, bad); }, "plate rebound"));
    EXPECT_TRUE(refuses([bad] { StopPulse::instant(bad); }, "plate rebound"));
    EXPECT_TRUE(refuses([bad] { StopPulse::measured({0, 1}, {1, 1}, bad); }, "plate rebound"));
  }
}

TEST(StopPulse, RefusesBadTables) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto table = [](const std::vector<double>& t, const std::vector<double>& a) {
    return [t, a] { StopPulse::measured(t, a); };
  };
  EXPECT_TRUE(refuses(table({}, {}), "measured stop", "0 rows"));
  EXPECT_TRUE(refuses(table({0}, {1}), "measured stop", "1 rows"));
  EXPECT_TRUE(refuses(table({0, 1}, {1}), "measured stop"));
  EXPECT_TRUE(refuses(table({0, 1e-5, 1e-5}, {1, 1, 1}), "time of row 3", "1e-05"));
  EXPECT_TRUE(refuses(table({0, 2e-5, 1e-5}, {1, 1, 1}), "time of row 3"));
  EXPECT_TRUE(refuses(table({0, nan}, {1, 1}), "time of row 2"));
  EXPECT_TRUE(refuses(table({0, 1}, {-1, -1}), "integral of the deceleration", "-1"));
  EXPECT_TRUE(refuses(table({0, 1}, {0, 0}), "integral of the deceleration"));
  EXPECT_TRUE(refuses(table({0, 1}, {1, nan}), "integral of the deceleration"));
  EXPECT_TRUE(refuses(table({0, 1}, {1, infinity}), "integral of the deceleration"));
  EXPECT_TRUE(refuses(table({0, infinity}, {1, 1}), ""));
}

}  // namespace
}  // namespace powderlink
