// SPDX-License-Identifier: GPL-3.0-or-later
/// \file stop_pulse.h
/// How the anvil stops the plate of a Kinetic Adhesion Test.
///
/// The plate arrives with speed v and leaves with -e_p v; its deceleration A(t) obeys
///   integral of A dt = v (1 + e_p).
///   instant        all at once: a kick of v (1 + e_p) to the particles in the plate's frame
///   half_sine tau  A = pi v (1 + e_p)/(2 tau) sin(pi t/tau)
///   hertz tau      A ~ sin^(3/2)(pi t/tau), the force of a Hertzian impact
///   measured       piecewise linear through (t, A), scaled so that the integral holds
///
/// Symbols: v impact speed [m/s], tau duration [s], e_p rebound of the plate [-], A [m/s^2], t since
/// the first touch of the anvil [s].
/// Sign: A > 0 slows the plate; in its frame it pushes the particles away from it, along the fall.
/// Validity: the plate is stiff and much heavier than the powder on it.
/// Source: thesis of L. Pedrolli, Section 4.3; sin^(3/2): Johnson, Contact Mechanics, Section 11.4.
/// Tests: tests/physics/stop_pulse_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/invalid_input.h"

namespace powderlink::physics {

class StopPulse {
 public:
  enum class Shape { instant, half_sine, hertz, measured };

  StopPulse() = default;

  static StopPulse instant(double rebound = 0.0) { return {Shape::instant, 0.0, rebound}; }
  static StopPulse half_sine(double tau_s, double rebound = 0.0) {
    return {Shape::half_sine, tau_s, rebound};
  }
  static StopPulse hertz(double tau_s, double rebound = 0.0) {
    return {Shape::hertz, tau_s, rebound};
  }
  /// times_s strictly increasing, at least two rows; only the shape counts, see above.
  static StopPulse measured(std::vector<double> times_s, std::vector<double> decelerations,
                            double rebound = 0.0) {
    if (times_s.size() < 2 || times_s.size() != decelerations.size()) {
      throw InvalidInput("measured stop", std::to_string(times_s.size()) + " rows",
                         "at least 2 rows of time and deceleration", "give the whole pulse");
    }
    double area = 0.0;
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      const double dt = times_s[i] - times_s[i - 1];
      if (!(dt > 0.0)) {
        throw InvalidInput("measured stop: time of row " + std::to_string(i + 1),
                           number_text(times_s[i]) + " s", "strictly increasing times",
                           "sort the rows and remove doubles");
      }
      area += 0.5 * dt * (decelerations[i] + decelerations[i - 1]);
    }
    if (!(area > 0.0 && std::isfinite(area))) {
      throw InvalidInput("measured stop: integral of the deceleration", number_text(area) + " m/s",
                         "> 0 and finite (a pulse that slows the plate)",
                         "check the sign of the column");
    }
    StopPulse p(Shape::measured, times_s.back() - times_s.front(), rebound);
    const double t0 = times_s.front();
    for (double& t : times_s) t -= t0;
    p.times_ = std::move(times_s);
    p.values_ = std::move(decelerations);
    p.measured_speed_change_m_s_ = area;
    for (double& a : p.values_) a /= area;
    return p;
  }

  Shape shape() const { return shape_; }
  double duration_s() const { return tau_; }
  double rebound() const { return rebound_; }
  /// Speed change that the measured table itself integrates to; 0 for the analytic shapes [m/s].
  double measured_speed_change_m_s() const { return measured_speed_change_m_s_; }

  double speed_change_m_s(double impact_speed) const { return impact_speed * (1.0 + rebound_); }
  /// Kick of the particles against the plate at t = 0 [m/s]; zero unless instant.
  double kick_m_s(double impact_speed) const {
    return shape_ == Shape::instant ? speed_change_m_s(impact_speed) : 0.0;
  }
  /// Deceleration of the plate at time t after first touch of the anvil [m/s^2].
  double deceleration_m_s2(double t, double impact_speed) const {
    if (shape_ == Shape::instant || t < 0.0 || t > tau_) return 0.0;
    return speed_change_m_s(impact_speed) * density(t);
  }
  double peak_deceleration_m_s2(double impact_speed) const {
    double peak = 0.0;
    if (shape_ == Shape::measured) {
      for (const double a : values_) peak = std::max(peak, a);
    } else if (shape_ != Shape::instant) {
      peak = density(0.5 * tau_);
    }
    return peak * speed_change_m_s(impact_speed);
  }

 private:
  StopPulse(Shape shape, double tau_s, double rebound)
      : shape_(shape), tau_(tau_s), rebound_(rebound) {
    if (shape != Shape::instant && !(tau_s > 0.0 && std::isfinite(tau_s))) {
      throw InvalidInput("stop duration", number_text(tau_s) + " s", "> 0 s",
                         "give tau in seconds, e.g. 1e-4, or stop instantly");
    }
    if (!(rebound >= 0.0 && rebound <= 1.0)) {
      throw InvalidInput("plate rebound", number_text(rebound), "0 <= e_p <= 1",
                         "0 is a plate that stays on the anvil");
    }
  }

  /// A(t) / (v (1 + e_p)), integral 1 [1/s].
  double density(double t) const {
    constexpr double pi = 3.14159265358979323846;
    if (shape_ == Shape::half_sine) return 0.5 * pi / tau_ * std::sin(pi * t / tau_);
    if (shape_ == Shape::hertz) {
      // mean of sin^(3/2) over half a period: Gamma(5/4) / (sqrt(pi) Gamma(7/4))
      static const double mean = std::tgamma(1.25) / (std::sqrt(pi) * std::tgamma(1.75));
      const double sine = std::max(0.0, std::sin(pi * t / tau_));
      return sine * std::sqrt(sine) / (mean * tau_);
    }
    const auto after = std::upper_bound(times_.begin(), times_.end(), t);
    if (after == times_.begin()) return values_.front();
    if (after == times_.end()) return values_.back();
    const auto i = static_cast<std::size_t>(after - times_.begin());
    const double w = (t - times_[i - 1]) / (times_[i] - times_[i - 1]);
    return (1.0 - w) * values_[i - 1] + w * values_[i];
  }

  Shape shape_ = Shape::instant;
  double tau_ = 0.0;
  double rebound_ = 0.0;
  double measured_speed_change_m_s_ = 0.0;
  std::vector<double> times_, values_;
};

}  // namespace powderlink::physics
