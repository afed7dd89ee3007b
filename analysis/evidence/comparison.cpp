// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/critical_diameter.h"
#include "analysis/evidence/candidate_parameters.h"
#include "analysis/evidence/diagnosis.h"
#include "analysis/evidence/residual_checks.h"

namespace powderlink::analysis {

namespace {

constexpr double kWorthNaming = 2.0;  // sigmas
constexpr double kCorrelated = 0.9;

std::vector<std::string> doubts(const Comparison& c, const Study& study) {
  std::vector<std::string> words;
  if (c.residuals.size() < kFewestRows) {
    words.push_back(fmt::format("{} rows cannot test a model: at least {} are needed",
                                c.residuals.size(), kFewestRows));
  }
  if (!velocities_spread(study)) {
    words.push_back(
        "the velocities of the rows differ by less than 5 %: how d_c changes cannot be "
        "judged");
  }
  for (const ParameterEstimate& p : c.fit.parameters) {
    if (p.at_bound) words.push_back(bound_text(p));
  }
  std::size_t at_end = 0;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    constexpr double margin = 1.001;
    const double d_m = 1e-6 * c.model[i];
    if (study.rows[i].kind() == KatRow::Kind::critical_diameter &&
        (d_m <= margin * kSmallestDiameter_m || d_m * margin >= kLargestDiameter_m))
      ++at_end;
  }
  if (at_end > 0) {
    words.push_back(fmt::format(
        "in {} of {} rows the model leaves nothing or everything on the plate, whatever the size: "
        "widen the bounds of the fit, or check units and materials",
        at_end, study.rows.size()));
  }
  return words;
}

}  // namespace

std::string to_string(Comparison::Verdict verdict) {
  switch (verdict) {
    case Comparison::Verdict::agrees:
      return "agrees";
    case Comparison::Verdict::fails:
      return "fails";
    case Comparison::Verdict::undecided:
      break;
  }
  return "undecided";
}

void judge(Comparison& c, const Study& study, const Observations& observations,
           const std::vector<double>& model) {
  c.model = model;
  c.residuals.clear();
  double squares = 0.0;
  double chi2 = 0.0;
  const std::size_t n = model.size();
  for (std::size_t i = 0; i < n; ++i) {
    c.residuals.push_back(residual(observations.list[i], model[i]));
    chi2 += c.residuals[i] * c.residuals[i];
    squares += std::pow(observations.list[i].error(model[i]), 2);
  }
  c.rms_relative_error = std::sqrt(squares / static_cast<double>(n));
  const int degrees = static_cast<int>(n) - c.fit.fitted();
  c.chi2_per_dof = degrees > 0 ? chi2 / degrees : std::numeric_limits<double>::quiet_NaN();
  c.tests = residual_tests(study, observations, c.residuals, c.fit.fitted());

  const std::vector<std::string> doubtful = doubts(c, study);
  const bool fails = residuals_fail(c.tests, c.residuals, observations.noise);
  // Scatter at one velocity tells of the noise, not of the model.
  const bool can_fail = n >= kFewestRows && velocities_spread(study);
  c.verdict = fails && can_fail  ? Comparison::Verdict::fails
              : doubtful.empty() ? Comparison::Verdict::agrees
                                 : Comparison::Verdict::undecided;
  c.words = {"judged with " + observations.noise.text()};
  c.words.insert(c.words.end(), doubtful.begin(), doubtful.end());
  std::vector<std::string> far;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::fabs(c.residuals[i]) > kWorthNaming) {
      far.push_back(fmt::format("{:g} m/s ({:.3g} um): {:+.1f}", study.rows[i].impact_velocity_m_s,
                                observations.list[i].measured, c.residuals[i]));
    }
  }
  if (!far.empty())
    c.words.push_back(fmt::format("beyond 2 sigma (model - measured): {}", fmt::join(far, "; ")));
  for (const TrendTest& t : c.tests) {
    if (t.counts && t.p_corrected < kAlarm) {
      c.words.push_back(fmt::format("the residuals show a {} over {} (p = {:.1g})", t.test,
                                    t.variable, t.p_corrected));
    }
  }
  const double mean_square = chi2 / static_cast<double>(n);
  if (fails && !observations.noise.known() && mean_square <= kRmsOverAssumed * kRmsOverAssumed) {
    c.words.push_back(
        "what fails is the trend, not the size of the residuals, and the noise was assumed, not "
        "measured: errors of reading that change with velocity look the same; repeated drops or "
        "a column critical_diameter_sigma_um would tell");
  }
  for (const std::string& direction : c.uncertainty.flat)
    c.words.push_back("the data leave open: " + direction);
  const auto& correlation = c.uncertainty.correlation;
  for (long i = 0; i < correlation.rows(); ++i) {
    for (long j = 0; j < i; ++j) {
      if (std::fabs(correlation(i, j)) < kCorrelated) continue;
      c.words.push_back(fmt::format(
          "{} and {} are correlated ({:+.2f}): the data fix their combination",
          c.fit.problem.parameters[static_cast<std::size_t>(j)].name,
          c.fit.problem.parameters[static_cast<std::size_t>(i)].name, correlation(i, j)));
    }
  }
  if (!c.fit.plausible) c.words.push_back("implausible: " + c.fit.why);
}

std::vector<ProfileInterval> intervals_of(const Candidate& c, const Observations& observations) {
  const int degrees = static_cast<int>(observations.list.size()) - c.fitted();
  const double scatter = degrees > 0 ? c.solution.chi2 / degrees : 1.0;
  const double rise = observations.noise.known() ? 1.0 : scatter;
  std::vector<ProfileInterval> intervals;
  for (std::size_t j = 0; j < c.solution.values.size(); ++j)
    intervals.push_back(profile_interval(c.problem, c.solution, j, rise));
  return intervals;
}

Comparison compare(const Study& study, const Observations& observations) {
  Comparison c;
  c.fit = fit_candidate(study, observations, {});
  c.intervals = intervals_of(c.fit, observations);
  c.uncertainty = uncertainty(c.fit.problem, c.fit.solution);
  judge(c, study, observations, c.fit.predicted);
  return c;
}

}  // namespace powderlink::analysis
