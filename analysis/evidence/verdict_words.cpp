// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/verdict_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/evidence/candidate_parameters.h"
#include "analysis/evidence/residual_checks.h"
#include "base/text/units.h"

namespace powderlink::analysis {

namespace {

std::string quality(const Candidate& c, const Observations& observations) {
  std::string text = "rms " + rms_text(c.rms);
  if (observations.known() && std::isfinite(c.chi2_per_dof()))
    text += fmt::format(", chi^2/dof {:.2g}", c.chi2_per_dof());
  return text;
}

std::string failing_tests(const Candidate& c) {
  std::vector<std::string> failing;
  for (const TrendTest& t : c.tests) {
    if (t.counts && t.p_corrected < kAlarm)
      failing.push_back(fmt::format("{} over {} (p = {:.1g})", t.test, t.variable, t.p_corrected));
  }
  return failing.empty() ? "its size" : fmt::format("{}", fmt::join(failing, ", "));
}

void tell_bounds(const Candidate& c, std::vector<std::string>& words) {
  for (const ParameterEstimate& p : c.parameters) {
    if (p.at_bound) {
      words.push_back(fmt::format("{}: {}{}", c.added.empty() ? "the study's own model" : c.name,
                                  bound_text(p),
                                  p.held_back ? ": widen the bounds or distrust it" : ""));
    }
  }
}

}  // namespace

std::string parameter_text(const Candidate& c) {
  std::vector<std::string> texts;
  for (const ParameterEstimate& p : c.parameters) {
    std::string text = fmt::format("{} = {:.3g}", p.name, p.value);
    if (unit_of(p.name) != "-") text += " " + unit_of(p.name);
    if (p.role == ParameterEstimate::Role::held) text += " (held: the data do not determine it)";
    if (p.role == ParameterEstimate::Role::fixed) text += " (given)";
    texts.push_back(text);
  }
  return texts.empty() ? "nothing to fit" : fmt::format("{}", fmt::join(texts, ", "));
}

std::vector<std::string> verdict_words(const Study& study, const Observations& observations,
                                       const Diagnosis& d, const Pattern* pattern) {
  const Candidate& none = d.baseline();
  std::vector<std::string> effects;
  for (const EffectChoice& e : study.effects) effects.push_back(e.name);
  const std::string model = effects.empty()
                                ? "JKR with one Gamma and an instant stop"
                                : fmt::format("the model with {}", fmt::join(effects, ", "));
  std::vector<std::string> words;
  words.push_back("judged with " + observations.noise_text);
  const bool undecided = d.verdict == Verdict::ambiguous && d.best.empty();
  if (d.verdict == Verdict::no_missing_effect || undecided) {
    words.push_back(fmt::format(
        "{} {} ({}){}. {}", model,
        undecided ? "agrees with the measurements" : "explains the measurements",
        quality(none, observations),
        undecided ? ", but only where its bounds end: whether an effect is missing cannot be told"
                  : "; no effect is missing that they could show",
        parameter_text(none)));
    tell_bounds(none, words);
    if (!none.plausible) {
      words.push_back("but: " + none.why +
                      ". The shape fits, the strength does not: "
                      "an effect that keeps the shape, or a wrong scale, may be hidden");
    }
    return words;
  }
  words.push_back(
      fmt::format("{} fails ({}): {}", model, quality(none, observations), failing_tests(none)));
  tell_bounds(none, words);
  const auto describe = [&](const std::string& name) {
    const Candidate& c = d.get(name);
    words.push_back(fmt::format("{}: {}, delta BIC {:+.1f}, {}; {}", name, quality(c, observations),
                                c.bic - none.bic, parameter_text(c),
                                c.plausible ? "plausible" : "IMPLAUSIBLE: " + c.why));
    tell_bounds(c, words);
  };
  switch (d.verdict) {
    case Verdict::missing_effect:
      words.push_back(d.best + " is missing: it alone explains the measurements");
      describe(d.best);
      break;
    case Verdict::ambiguous:
      words.push_back(d.indistinguishable.size() > 1
                          ? fmt::format("these measurements do not decide between {}",
                                        fmt::join(d.indistinguishable, ", "))
                          : d.best + " would explain them, but this is not certain");
      for (const std::string& name : d.indistinguishable) describe(name);
      if (d.best != d.indistinguishable.front()) {
        words.push_back(
            fmt::format("{} fits best, with values that are not possible; "
                        "{} is the leading plausible explanation",
                        d.indistinguishable.front(), d.best));
      }
      if (d.get(d.best).added.size() > 1)
        words.push_back("it takes two effects; so many parameters explain much and prove little");
      break;
    default:
      words.push_back("no effect of the catalogue, and no two of them, reach the noise");
      break;
  }
  if (pattern != nullptr) {
    const double bic = pattern_bic(*pattern, observations);
    const bool rival = d.best.empty() || bic < d.get(d.best).bic + kApart;
    if (rival && bic < none.bic - kClears) {
      words.push_back("what an effect would have to explain: " + pattern->text +
                      " against the baseline, which no effect of the catalogue makes");
    }
  }
  return words;
}

}  // namespace powderlink::analysis
