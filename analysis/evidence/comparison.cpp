// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/evidence/candidate_parameters.h"
#include "analysis/evidence/diagnosis.h"
#include "analysis/evidence/quantity.h"
#include "analysis/evidence/residual_checks.h"
#include "analysis/kat/reduced/critical_diameter.h"

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
        "the velocities of the rows differ by less than 5 %: how d_c changes cannot be judged");
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

/// Model over measured, or the inverse, in the middle one of the critical diameters; 1 without any.
double middle_factor(const std::vector<double>& model, const Observations& measured) {
  std::vector<double> off;
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (measured.list[i].row.kind() == KatRow::Kind::critical_diameter)
      off.push_back(std::fabs(std::log(model[i] / measured.list[i].measured)));
  }
  if (off.empty()) return 1.0;
  const auto middle = off.begin() + static_cast<long>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  return std::exp(*middle);
}

/// Critical diameters in another unit fit some other Gamma, or none within its bounds: where the model
/// is far off, the same rows are fitted again a thousand and a million times larger and smaller.
std::string doubtful_unit(const Comparison& c, const Study& study, const Observations& measured) {
  constexpr double far = 3.0, close = 2.0;  // factors; a model that lacks an effect is off by less
  if (middle_factor(c.model, measured) < far) return "";
  struct Scale {
    double factor;
    const char* unit;
  };
  std::string question;
  double best = close;
  for (const Scale& s : {Scale{1e3, "millimetres"}, Scale{1e-3, "nanometres"}, Scale{1e6, "metres"},
                         Scale{1e-6, "picometres"}}) {
    Study scaled = study;
    for (KatRow& row : scaled.rows) {
      if (row.critical_diameter_um) *row.critical_diameter_um *= s.factor;
      if (row.critical_diameter_sigma_um) *row.critical_diameter_sigma_um *= s.factor;
    }
    const Observations observations = observe(scaled);
    const Candidate fit = fit_candidate(scaled, observations, {});
    const double off = middle_factor(fit.predicted, observations);
    if (off >= best) continue;
    best = off;
    question = fmt::format(
        "with critical diameters {:g} times as large the model is off by {:.1f} % only: "
        "were {} given where micrometres are meant?",
        s.factor, 100.0 * rms_relative_error(fit.rms), s.unit);
  }
  return question;
}

/// "2 m/s (66.4 um)", "2 m/s, grains of 50 um (share 0.4)", "2 m/s, grains of 50 um (0.7 m/s)".
std::string row_text(const Observation& o) {
  const bool share = o.row.kind() == KatRow::Kind::retained_share;
  return fmt::format(
      "{:g} m/s{} ({}{:.3g}{})", o.row.impact_velocity_m_s,
      o.row.diameter_um ? fmt::format(", grains of {:.3g} um", *o.row.diameter_um) : "",
      share ? "share " : "", o.measured, quantity_of(o.row.kind()).unit);
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
  std::vector<double> errors;
  const std::size_t n = model.size();
  for (std::size_t i = 0; i < n; ++i) {
    c.residuals.push_back(residual(observations.list[i], model[i]));
    errors.push_back(observations.list[i].error(model[i]));
  }
  const double chi2 = sum_of_squares(c.residuals);
  c.rms = rms_errors(observations, errors);
  const int degrees = static_cast<int>(n) - c.fit.fitted();
  c.chi2_per_dof = degrees > 0 ? chi2 / degrees : std::numeric_limits<double>::quiet_NaN();
  FitSolution judged = c.fit.solution;
  judged.residuals = c.residuals;
  c.tests = residual_tests(observations, model, judged);

  const std::vector<std::string> doubtful = doubts(c, study);
  const bool fails = residuals_fail(c.tests, c.residuals, observations);
  // Scatter at one velocity tells of the noise, not of the model.
  const bool can_fail = n >= kFewestRows && velocities_spread(study);
  c.verdict = fails && can_fail  ? Comparison::Verdict::fails
              : doubtful.empty() ? Comparison::Verdict::agrees
                                 : Comparison::Verdict::undecided;
  c.words = {"judged with " + observations.noise_text};
  if (const std::string doubt = doubtful_unit(c, study, observations); !doubt.empty())
    c.words.push_back(doubt);
  c.words.insert(c.words.end(), doubtful.begin(), doubtful.end());
  std::vector<std::string> far;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::fabs(c.residuals[i]) > kWorthNaming) {
      far.push_back(row_text(observations.list[i]) + fmt::format(": {:+.1f}", c.residuals[i]));
    }
  }
  if (!far.empty())
    c.words.push_back(fmt::format("beyond 2 sigma (model - measured): {}", fmt::join(far, "; ")));
  for (const TrendTest& t : c.tests) {
    if (t.p_corrected >= kAlarm) continue;
    c.words.push_back(fmt::format(
        "the residuals show a {} over {} (p = {:.1g}){}", t.test, t.variable, t.p_corrected,
        t.counts
            ? ""
            : "; no evidence against the model, as that column may depend on the measured value"));
  }
  if (fails && !observations.known() && !beyond_assumed(c.residuals, observations)) {
    c.words.push_back(
        "what fails is the trend, not the size of the residuals, and the noise was assumed, "
        "not measured: errors of reading that change with velocity look the same; "
        "repeated drops or a column critical_diameter_sigma_um would tell");
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
  const double rise = observations.known() ? 1.0 : scatter;
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
