// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate_solve.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/kat/reduced/critical_diameter.h"
#include "analysis/kat/reduced/critical_speed.h"

namespace powderlink::analysis {

namespace {

using Correction = decltype(Hypothesis::correction);

/// Hypothesis::correction at these values.
Correction correction_at(const Study& study, const Setting& s, const std::vector<double>& values) {
  constexpr double tolerance = 3e-4;  // of d_c
  Hypothesis h = s.hypothesis;
  apply(h, s.slots, values);
  Correction correction;
  for (const KatRow& row : study.rows) {
    if (row.kind() == KatRow::Kind::residual_speed) continue;
    const double v = row.impact_velocity_m_s;
    std::map<double, double>& over_v = correction[conditions_of(row)];
    if (over_v.count(v) > 0) continue;
    const ReducedModel model(row_setup(study, h.effects, row,
                                       row.adhesive_energy_J_m2.value_or(h.adhesive_energy_J_m2)));
    const CriticalDiameter integrated = critical_diameter(model, v, tolerance);
    const CriticalDiameter estimate = quick_critical_diameter(model, v, true);
    const bool both = integrated.found() && estimate.found();
    over_v[v] = both ? std::log(integrated.diameter_m / estimate.diameter_m) : 0.0;
  }
  return correction;
}

/// Largest difference between two corrections of the same rows.
double largest_change(const Correction& from, const Correction& to) {
  double largest = 0.0;
  for (const auto& [conditions, over_v] : from) {
    for (const auto& [v, was] : over_v)
      largest = std::max(largest, std::fabs(to.at(conditions).at(v) - was));
  }
  return largest;
}

/// Do corrected estimates change with Gamma as the integration does?
bool follows_energy(const Study& study, const Setting& s, std::vector<double> values) {
  constexpr double step = 0.1;       // of ln Gamma
  constexpr double of_slope = 0.12;  // of dln d_c/dln Gamma, which is 0.5 to 1 where Gamma counts
  if (s.slots.empty() || s.slots[0].effect >= 0) return true;
  const FitParameter& p = s.problem.parameters[0];
  values[0] *= std::exp(values[0] * std::exp(step) < p.upper ? step : -step);
  return largest_change(s.hypothesis.correction, correction_at(study, s, values)) < of_slope * step;
}

}  // namespace

bool cheap(const Study& study, const Hypothesis& h) {
  for (const KatRow& row : study.rows) {
    const ReducedModel model(row_setup(study, h.effects, row, 1.0));
    if (!CriticalSpeed(model, h.estimated).available()) return false;
  }
  return true;
}

FitSolution solve(Setting& s, const std::vector<std::vector<double>>& starts, const Study& study,
                  const Observations& observations) {
  constexpr int most_turns = 4;
  constexpr double settled = 1e-3;  // of d_c: the accuracy of all that is quick
  FitSolution solution = least_squares(s.problem, starts);
  for (int turn = 0; s.calibrated && turn < most_turns; ++turn) {
    const Correction before = s.hypothesis.correction;
    s.hypothesis.correction = correction_at(study, s, solution.values);
    if (!before.empty() && largest_change(before, s.hypothesis.correction) < settled) break;
    define_residuals(s, study, observations);
    solution = least_squares(s.problem, solution.values);
  }
  if (s.calibrated && !follows_energy(study, s, solution.values)) {
    s.calibrated = s.hypothesis.estimated = false;
    s.hypothesis.correction.clear();
    define_residuals(s, study, observations);
    solution = least_squares(s.problem, solution.values);
  }
  return solution;
}

}  // namespace powderlink::analysis
