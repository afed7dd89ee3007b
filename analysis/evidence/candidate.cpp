// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/evidence/candidate_parameters.h"
#include "analysis/evidence/candidate_setting.h"
#include "analysis/evidence/candidate_solve.h"
#include "analysis/evidence/candidate_starts.h"
#include "analysis/evidence/residual_checks.h"
#include "base/statistics/fit_uncertainty.h"

namespace powderlink::analysis {

namespace {

constexpr double kNoiseFreedom = 2.0;  // nu of an assumed noise

/// Holds parameters of added effects at their typical values while BIC does not rise.
void hold_what_is_not_needed(Setting& s, FitSolution& solution, const Study& study,
                             const Observations& observations) {
  const double per_parameter = std::log(static_cast<double>(observations.list.size()));
  for (std::size_t j = s.slots.size(); j-- > 0;) {
    if (!s.slots[j].of_added) continue;
    Setting less = s;
    std::vector<double> start = solution.values;
    apply(less.hypothesis, {s.slots[j]}, {s.problem.parameters[j].start});
    less.slots.erase(less.slots.begin() + static_cast<long>(j));
    less.problem.parameters.erase(less.problem.parameters.begin() + static_cast<long>(j));
    start.erase(start.begin() + static_cast<long>(j));
    define_residuals(less, study, observations);
    FitSolution held =
        less.slots.empty()
            ? least_squares(less.problem, start)
            : solve(less, {suit_energy(less, observations, start, 8).first}, study, observations);
    const double worse = score(observations, held.residuals) + held.prior -
                         score(observations, solution.residuals) - solution.prior;
    if (worse > per_parameter) continue;
    s = std::move(less);
    solution = std::move(held);
  }
}

/// \param s  its bounds may be narrower than the registry's
Candidate fit(const Study& study, const Observations& observations, Setting s,
              const std::vector<std::string>& added, const std::vector<const Candidate*>& near) {
  const std::size_t n = observations.list.size();
  Candidate c;
  c.added = added;
  c.name = added.empty() ? "none" : fmt::format("{}", fmt::join(added, "+"));
  // Effects on top of others: estimates are searched and corrected, as integrating takes minutes.
  if (Hypothesis estimates = s.hypothesis; !estimates.estimated && !cheap(study, estimates)) {
    estimates.estimated = true;
    s.calibrated = cheap(study, estimates);
    if (s.calibrated) s.hypothesis = estimates;
    define_residuals(s, study, observations);
  }
  std::vector<std::vector<double>> starts;
  if (!near.empty()) starts = near_starts(s, observations, near);
  if (added.size() < 2) {
    const auto more = searched_starts(study, s, observations, cheap(study, s.hypothesis));
    starts.insert(starts.end(), more.begin(), more.end());
  }
  c.solution = solve(s, starts, study, observations);
  hold_what_is_not_needed(s, c.solution, study, observations);

  c.hypothesis = s.hypothesis;
  apply(c.hypothesis, s.slots, c.solution.values);
  c.problem = s.problem;
  list_parameters(c, s, study);
  std::vector<double> errors;
  std::vector<double> left_out;
  const std::vector<double> loo = leave_one_out(c.solution);
  for (std::size_t i = 0; i < n; ++i) {
    const Observation& o = observations.list[i];
    c.predicted.push_back(predicted(study, c.hypothesis, o.row));
    errors.push_back(o.error(c.predicted.back()));
    left_out.push_back(loo[i] * o.sigma);
  }
  c.rms = rms_errors(observations, errors);
  c.left_out = rms_errors(observations, left_out);
  c.bic = score(observations, c.solution.residuals) + c.solution.prior +
          c.fitted() * std::log(static_cast<double>(n));
  c.tests = residual_tests(observations, c.predicted, c.solution);
  judge_plausibility(c, study);
  return c;
}

}  // namespace

double score(const Observations& o, const std::vector<double>& residuals) {
  double known = 0.0;
  std::map<KatRow::Kind, std::pair<double, double>> assumed;  // rows and chi^2
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double square = residuals[i] * residuals[i];
    if (o.list[i].known()) {
      known += square;
      continue;
    }
    auto& [rows, chi2] = assumed[o.list[i].row.kind()];
    rows += 1.0;
    chi2 += square;
  }
  for (const auto& [kind, sums] : assumed)
    known += (sums.first + kNoiseFreedom) * std::log1p(sums.second / kNoiseFreedom);
  return known;
}

double Candidate::chi2_per_dof() const {
  const int degrees = static_cast<int>(predicted.size()) - fitted();
  return degrees > 0 ? solution.chi2 / degrees : std::numeric_limits<double>::quiet_NaN();
}

const ParameterEstimate* Candidate::find(const std::string& wanted) const {
  for (const ParameterEstimate& p : parameters) {
    if (p.name == wanted) return &p;
  }
  return nullptr;
}

bool Candidate::held_back() const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const ParameterEstimate& p) { return p.held_back; });
}

Candidate fit_candidate(const Study& study, const Observations& observations,
                        const std::vector<std::string>& added,
                        const std::vector<const Candidate*>& near) {
  Setting s = make_setting(study, observations, added);
  const std::size_t n = observations.list.size();
  if (s.slots.size() > n) {
    throw InvalidInput(study.file.string(),
                       fmt::format("{} free parameters and {} rows", s.slots.size(), n),
                       "at least as many rows as free parameters",
                       "measure at more velocities, or fix parameters");
  }
  Candidate free = fit(study, observations, s, added, near);
  if (free.plausible || added.size() != 1) return free;
  for (std::size_t j = 0; j < s.slots.size(); ++j) {
    FitParameter& p = s.problem.parameters[j];
    const ParameterEstimate& known = *free.find(p.name);
    p.lower = std::max(p.lower, known.plausible_lower);
    p.upper = std::min(p.upper, known.plausible_upper);
    if (!(p.lower < p.upper)) return free;
    p.start = std::clamp(p.start, p.lower, p.upper);
  }
  Candidate plausible = fit(study, observations, s, added, near);
  return plausible.bic <= free.bic + kApart ? plausible : free;
}

}  // namespace powderlink::analysis
