// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/next_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics/fit_uncertainty.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

constexpr int kPoints = 41;
constexpr double kAround = 2.0;   // beyond the measured velocities
constexpr double kDecides = 3.0;  // sigmas

/// A drop at a new velocity; its contact time from the nearest row.
KatRow row_at(const Study& study, double velocity) {
  const auto nearest =
      std::min_element(study.rows.begin(), study.rows.end(), [&](const KatRow& a, const KatRow& b) {
        return std::fabs(a.impact_velocity_m_s - velocity) <
               std::fabs(b.impact_velocity_m_s - velocity);
      });
  KatRow row;
  row.impact_velocity_m_s = velocity;
  row.contact_time_us = nearest->contact_time_us;
  row.adhesive_energy_J_m2 = nearest->adhesive_energy_J_m2;
  return row;
}

/// The fit with one of its parameters moved by a step of its coordinate.
struct Moved {
  Hypothesis hypothesis;
  double step = 0.0;
};

Moved moved(const Candidate& c, std::size_t fitted) {
  Hypothesis h = c.hypothesis;
  const FitParameter& p = c.problem.parameters[fitted];
  const double at = p.to_coordinate(c.solution.values[fitted]);
  const double step = p.step(at);
  const double value = p.to_value(at + step);
  std::size_t seen = 0;
  for (const ParameterEstimate& e : c.parameters) {
    if (e.role != ParameterEstimate::Role::fitted || seen++ != fitted) continue;
    if (e.effect.empty()) h.adhesive_energy_J_m2 = value;
    for (EffectChoice& choice : h.effects) {
      if (choice.name != e.effect) continue;
      const auto& known = physics::find_effect(choice.name).info->parameters;
      for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i].name == e.name) choice.parameters[i] = value;
      }
    }
  }
  return {h, step};
}

double typical_sigma(const Observations& o) {
  double sum = 0.0;
  double count = 0.0;
  for (const Observation& x : o.list) {
    if (x.row.kind() != KatRow::Kind::critical_diameter) continue;
    sum += x.sigma;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : kAssumedRelativeNoise;
}

struct Best {
  std::size_t point = 0;
  double separation = 0.0;
};

Best largest_separation(const PredictedCurve& a, const PredictedCurve& b, double sigma) {
  Best best;
  for (std::size_t i = 0; i < a.velocity_m_s.size(); ++i) {
    const double apart = std::fabs(std::log(a.diameter_um[i] / b.diameter_um[i]));
    const double of_a = 0.5 * std::log(a.high_um[i] / a.low_um[i]);
    const double of_b = 0.5 * std::log(b.high_um[i] / b.low_um[i]);
    const double separation = apart / std::sqrt(sigma * sigma + of_a * of_a + of_b * of_b);
    if (separation > best.separation) best = {i, separation};
  }
  return best;
}

std::string decisive_tests(const std::vector<const Candidate*>& leading) {
  std::string text;
  for (const Candidate* c : leading) {
    for (const std::string& name : c->added) {
      const std::string& test = physics::find_effect(name).info->decisive_test;
      if (!test.empty() && text.find(test) == std::string::npos)
        text += fmt::format("; {}: {}", name, test);
    }
  }
  return text;
}

}  // namespace

std::vector<double> velocities_around(const Study& study) {
  const auto [slowest, fastest] = std::minmax_element(
      study.rows.begin(), study.rows.end(), [](const KatRow& a, const KatRow& b) {
        return a.impact_velocity_m_s < b.impact_velocity_m_s;
      });
  const double low = std::log(slowest->impact_velocity_m_s / kAround);
  const double high = std::log(fastest->impact_velocity_m_s * kAround);
  std::vector<double> v;
  v.reserve(kPoints);
  for (int i = 0; i < kPoints; ++i) v.push_back(std::exp(low + (high - low) * i / (kPoints - 1)));
  return v;
}

PredictedCurve predicted_curve(const Study& study, const Candidate& c,
                               const std::vector<double>& velocities) {
  PredictedCurve curve;
  curve.name = c.name;
  const std::size_t k = c.solution.values.size();
  const Uncertainty u = uncertainty(c.problem, c.solution);
  std::vector<Moved> shifted;
  for (std::size_t j = 0; j < k; ++j) shifted.push_back(moved(c, j));
  for (const double v : velocities) {
    const KatRow row = row_at(study, v);
    const double d = predicted_diameter_um(study, c.hypothesis, row);
    std::vector<double> slope;
    slope.reserve(k);
    for (const Moved& m : shifted)
      slope.push_back(std::log(predicted_diameter_um(study, m.hypothesis, row) / d) / m.step);
    double variance = 0.0;
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j < k; ++j) {
        variance += slope[i] * slope[j] * u.sigma[i] * u.sigma[j] *
                    u.correlation(static_cast<long>(i), static_cast<long>(j));
      }
    }
    const double s = std::sqrt(std::max(0.0, variance));
    curve.velocity_m_s.push_back(v);
    curve.diameter_um.push_back(d);
    curve.low_um.push_back(d * std::exp(-s));
    curve.high_um.push_back(d * std::exp(s));
  }
  return curve;
}

NextMeasurement next_measurement(const Study& study, const Observations& observations,
                                 const std::vector<const Candidate*>& leading) {
  NextMeasurement next;
  const std::vector<double> velocities = velocities_around(study);
  for (const Candidate* c : leading) next.curves.push_back(predicted_curve(study, *c, velocities));
  if (leading.size() < 2) {
    next.text = "none needed to choose: there is one explanation" + decisive_tests(leading);
    return next;
  }
  const double sigma = typical_sigma(observations);
  // The pair that is hardest to tell apart decides which velocity is of most use.
  std::string detail;
  double worst = 0.0;
  for (std::size_t b = 1; b < next.curves.size(); ++b) {
    const Best best = largest_separation(next.curves[0], next.curves[b], sigma);
    const double v = velocities[best.point];
    detail += fmt::format(
        "{}{:.2g} m/s, where {} predicts {:.3g} um and {} {:.3g} um ({:.1f} sigma of one drop)",
        b > 1 ? "; " : "", v, next.curves[0].name, next.curves[0].diameter_um[best.point],
        next.curves[b].name, next.curves[b].diameter_um[best.point], best.separation);
    if (b == 1 || best.separation < worst) {
      worst = best.separation;
      next.velocity_m_s = v;
      next.separation_sigma = best.separation;
    }
  }
  next.text =
      (worst >= kDecides ? "a drop at " : "no single drop decides; the most telling is at ") +
      detail + decisive_tests(leading);
  return next;
}

}  // namespace powderlink::analysis
