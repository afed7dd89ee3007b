// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/report_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/evidence/quantity.h"
#include "analysis/evidence/residual_checks.h"
#include "analysis/report/column_title.h"
#include "analysis/report/typeset.h"
#include "analysis/report/value_range.h"
#include "base/text/units.h"

namespace powderlink::analysis {

namespace {

enum class Fit { too_small, fits, too_large };

Fit fit_of(double residual_sigma) {
  return residual_sigma > kOutside_sigma    ? Fit::too_large
         : residual_sigma < -kOutside_sigma ? Fit::too_small
                                            : Fit::fits;
}

/// "3 to 5", or "3" where both print alike.
std::string range_text(double low, double high, int digits) {
  const std::string a = fmt::format("{:.{}g}", low, digits);
  const std::string b = fmt::format("{:.{}g}", high, digits);
  return a == b ? a : fmt::format("{} to {}", a, b);
}

std::string group_text(const StudyResult& r, const std::vector<std::size_t>& rows, Fit fit) {
  const Quantity& quantity = quantity_of(r.observations.list[rows.front()].row.kind());
  const bool relative = quantity.kind == KatRow::Kind::critical_diameter;
  const std::string own_unit = typeset(quantity.unit);
  ValueRange velocity, measured, size, off, sigmas;
  for (const std::size_t i : rows) {
    const Observation& o = r.observations.list[i];
    velocity.add(o.row.impact_velocity_m_s);
    measured.add(o.measured);
    size.add(o.row.diameter_um.value_or(NAN));
    off.add(std::fabs(o.error(r.comparison.model[i])) * (relative ? 100.0 : 1.0));
    sigmas.add(std::fabs(r.comparison.residuals[i]));
  }
  const std::string where = fmt::format(
      "At {} m/s{} ({} {}{}) the model ", range_text(velocity.low, velocity.high, 3),
      std::isfinite(size.low) ? fmt::format(" and {} µm", range_text(size.low, size.high, 3)) : "",
      quantity.name, range_text(measured.low, measured.high, 3), own_unit);
  const std::string unit = relative ? " %" : own_unit;
  if (fit == Fit::fits)
    return where + fmt::format("fits: it is off by {:.2g}{} at most, {:.1f} sigmas.", off.high,
                               unit, sigmas.high);
  return where + fmt::format("is too {} by {}{}, {} sigmas.",
                             fit == Fit::too_large ? "large" : "small",
                             range_text(off.low, off.high, 2), unit,
                             range_text(sigmas.low, sigmas.high, 2));
}

std::string list_text(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

void add_held(const Candidate& c, std::vector<std::string>& words) {
  for (const ParameterEstimate& p : c.parameters) {
    if (p.role != ParameterEstimate::Role::held) continue;
    words.push_back(
        fmt::format("The value of {} in {}: it was left at its typical value, {}; "
                    "with another one (and another Gamma) the rows are described as well.",
                    p.name, p.effect, value_text(p.value, unit_of(p.name))));
  }
}

}  // namespace

std::string value_text(double value, const std::string& unit) {
  return fmt::format("{:.3g}{}{}", value, unit == "-" ? "" : " ", unit == "-" ? "" : unit);
}

std::string headline(const StudyResult& r) {
  std::string text;
  switch (r.comparison.verdict) {
    case Comparison::Verdict::agrees:
      text = "The model describes these measurements.";
      break;
    case Comparison::Verdict::fails:
      text = "The model does not describe these measurements.";
      break;
    case Comparison::Verdict::undecided:
      text = "Whether the model is right cannot be judged from these measurements.";
      break;
  }
  if (!r.diagnosis) return text + " What is missing was not diagnosed.";
  const Diagnosis& d = *r.diagnosis;
  switch (d.verdict) {
    case Verdict::no_missing_effect:
      return text + " No effect is missing that they could show.";
    case Verdict::missing_effect:
      return text + fmt::format(" One effect is missing: {}.", d.best);
    case Verdict::unexplained:
      return text + " No effect of the catalogue, and no two of them, explain the difference.";
    case Verdict::ambiguous:
      break;
  }
  if (d.best.empty()) {
    return text + " The fit ended at a bound: whether an effect is missing cannot be told.";
  }
  const auto values = [](bool possible) {
    return possible ? "with possible values" : "with values that are not possible";
  };
  std::vector<std::string> likewise, other;  // as possible as the best, and not
  const bool possible = d.get(d.best).plausible;
  for (const std::string& name : d.indistinguishable) {
    if (name == d.best) continue;
    (d.get(name).plausible == possible ? likewise : other).push_back(name);
  }
  text += fmt::format(" {} would explain the difference {}", d.best, values(possible));
  if (!likewise.empty()) text += fmt::format("; so would {}", list_text(likewise));
  if (!other.empty())
    text += fmt::format("; {} would too, {}", list_text(other), values(!possible));
  return text + (likewise.empty() && other.empty() ? "; this is not certain." : ".");
}

std::vector<std::string> fit_words(const StudyResult& r) {
  std::vector<std::size_t> order(r.observations.list.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto velocity = [&](std::size_t i) {
    return r.observations.list[i].row.impact_velocity_m_s;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto& list = r.observations.list;
    return std::make_pair(list[a].row.kind(), velocity(a)) <
           std::make_pair(list[b].row.kind(), velocity(b));
  });
  std::vector<std::string> words;
  std::vector<std::size_t> group;
  for (std::size_t k = 0; k < order.size(); ++k) {
    group.push_back(order[k]);
    const Fit fit = fit_of(r.comparison.residuals[order[k]]);
    const auto kind = [&](std::size_t i) { return r.observations.list[i].row.kind(); };
    if (k + 1 < order.size() && fit_of(r.comparison.residuals[order[k + 1]]) == fit &&
        kind(order[k + 1]) == kind(order[k]))
      continue;
    words.push_back(group_text(r, group, fit));
    group.clear();
  }
  return words;
}

std::vector<std::string> trend_words(const StudyResult& r) {
  std::vector<std::string> words;
  for (const TrendTest& t : r.comparison.tests) {
    if (!t.counts || t.p_corrected >= kAlarm) continue;
    const std::string variable = column_words(t.variable);
    const std::string what = t.test == "curve"  ? "over " + variable + " they lie on a curve"
                             : t.test == "rank" ? "they rise or fall with " + variable
                             : t.test == "runs"
                                 ? "neighbours in " + variable + " have the same sign too often"
                                 : "they are larger than the stated noise allows";
    words.push_back(
        fmt::format("The residuals are not chance: {} (p = {:.1g}).", what, t.p_corrected));
  }
  return words;
}

std::vector<std::string> open_questions(const StudyResult& r) {
  std::vector<std::string> words;
  const std::size_t rows = r.observations.list.size();
  for (const TableNoise& t : r.observations.tables) {
    if (t.origin == NoiseOrigin::assumed)
      words.push_back("The size of the noise of " + std::string(quantity_of(t.kind).plural) + ": " +
                      t.text() + ".");
  }
  if (!r.diagnosis) words.push_back("Which effect is missing: " + r.no_diagnosis + ".");
  const std::vector<const Candidate*> leading = r.leading();
  if (leading.size() > 1) {
    std::vector<std::string> names;
    for (const Candidate* c : leading) names.push_back(c->name);
    const double apart = leading.back()->bic - leading.front()->bic;
    words.push_back(
        fmt::format("Which of {} acts: their BIC differ by {:.1f} over {} rows, and {}.",
                    list_text(names), apart, rows,
                    apart < kApart ? fmt::format("differences below {:g} do not decide", kApart)
                                   : "the one that fits best needs values that are not possible"));
  }
  for (const Candidate* c : leading) add_held(*c, words);
  add_held(r.comparison.fit, words);
  for (std::size_t i = 0; i < r.comparison.intervals.size(); ++i) {
    const ProfileInterval& p = r.comparison.intervals[i];
    const std::string& name = r.comparison.fit.problem.parameters[i].name;
    if (p.open_low || p.open_high) {
      words.push_back(
          fmt::format("The {} end of {}: "
                      "every value up to the bound of the fit is within one sigma.",
                      p.open_low && p.open_high ? "lower and upper"
                      : p.open_low              ? "lower"
                                                : "upper",
                      name));
    }
  }
  for (const std::string& direction : r.comparison.uncertainty.flat)
    words.push_back(fmt::format("The values of {}.", direction));
  return words;
}

}  // namespace powderlink::analysis
