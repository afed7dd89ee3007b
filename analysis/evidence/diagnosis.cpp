// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/evidence/added_effects.h"
#include "analysis/evidence/residual_checks.h"
#include "analysis/evidence/verdict_words.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

constexpr double kSameAsBaseline = 1e-6;   // relative: the effect cannot be seen
constexpr double kPlausibleWithin = 4.0;   // of BIC
constexpr std::size_t kPairsFromBest = 3;  // pairs are made of these and all others

std::pair<double, double> velocity_range(const Study& study) {
  const auto [slowest, fastest] = std::minmax_element(
      study.rows.begin(), study.rows.end(), [](const KatRow& a, const KatRow& b) {
        return a.impact_velocity_m_s < b.impact_velocity_m_s;
      });
  return {slowest->impact_velocity_m_s, fastest->impact_velocity_m_s};
}

void require_rows(const Study& study) {
  const std::size_t n = study.rows.size();
  if (n < kFewestRows) {
    throw InvalidInput(
        study.file.string() + ": rows to diagnose", fmt::format("{} row{}", n, n == 1 ? "" : "s"),
        fmt::format("at least {}: with fewer every effect explains everything", kFewestRows),
        "measure at more velocities; 'powderlink compare' works with fewer rows");
  }
  if (!velocities_spread(study)) {
    const auto [slowest, fastest] = velocity_range(study);
    throw InvalidInput(study.file.string() + ": impact velocities",
                       fmt::format("{:g} to {:g} m/s", slowest, fastest),
                       "velocities that differ by 5 % and more",
                       "effects show in how d_c changes with velocity: measure at others too");
  }
}

bool same_predictions(const Candidate& a, const Candidate& b) {
  for (std::size_t i = 0; i < a.predicted.size(); ++i) {
    const double scale = std::max(std::fabs(a.predicted[i]), std::fabs(b.predicted[i]));
    if (std::fabs(a.predicted[i] - b.predicted[i]) > kSameAsBaseline * scale) return false;
  }
  return true;
}

/// Trends tell little where the size of the noise is not known: there the scatter of the other rows
/// alone is asked for.
bool suffices(const Candidate& c, const Candidate& baseline, const Observations& o) {
  if (!c.acts || c.bic > baseline.bic - kClears) return false;
  const bool known = o.known();
  const bool passes = std::all_of(c.tests.begin(), c.tests.end(), [&](const TrendTest& t) {
    return !t.counts || t.p_corrected >= kSuffices || !(known || t.test == "scatter");
  });
  return passes && !beyond_assumed(c.solution.residuals, o);
}

void sort_by_bic(std::vector<Candidate>& list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const Candidate& a, const Candidate& b) { return a.bic < b.bic; });
}

const Pattern* best_pattern(const std::vector<Pattern>& patterns, const Observations& o) {
  const Pattern* best = nullptr;
  for (const Pattern& p : patterns) {
    if (best == nullptr || pattern_bic(p, o) < pattern_bic(*best, o)) best = &p;
  }
  return best;
}

std::size_t most_parameters(const Study& study, const std::vector<std::string>& added) {
  std::size_t k = 1;
  for (const std::string& name : added) k += physics::find_effect(name).info->parameters.size();
  for (const EffectChoice& e : study.effects) k += e.free.size();
  return k;
}

std::vector<Candidate> fit_pairs(const Study& study, const Observations& observations,
                                 const std::vector<Candidate>& ranking) {
  std::vector<const Candidate*> singles;
  for (const Candidate& c : ranking) {
    if (!c.added.empty() && c.acts) singles.push_back(&c);
  }
  std::vector<Candidate> pairs;
  for (std::size_t i = 0; i < std::min(kPairsFromBest, singles.size()); ++i) {
    for (std::size_t j = i + 1; j < singles.size(); ++j) {
      const std::vector<std::string> added = {singles[i]->name, singles[j]->name};
      // A pair needs rows to spare.
      if (most_parameters(study, added) + 1 > observations.list.size()) continue;
      pairs.push_back(fit_pair(study, observations, *singles[i], *singles[j]));
    }
  }
  sort_by_bic(pairs);
  return pairs;
}

}  // namespace

double pattern_bic(const Pattern& p, const Observations& o) {
  if (p.residuals.empty()) return std::numeric_limits<double>::infinity();
  return score(o, p.residuals) + p.parameters * std::log(static_cast<double>(o.list.size()));
}

bool velocities_spread(const Study& study) {
  constexpr double least_spread = 1.05;
  for (const KatRow& row : study.rows) {
    if (row.kind() != KatRow::Kind::critical_diameter) return true;
  }
  const auto [slowest, fastest] = velocity_range(study);
  return fastest >= least_spread * slowest;
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_missing_effect:
      return "no_missing_effect";
    case Verdict::missing_effect:
      return "missing_effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      break;
  }
  return "unexplained";
}

const Candidate& Diagnosis::get(const std::string& name) const {
  for (const auto* list : {&ranking, &pairs}) {
    for (const Candidate& c : *list) {
      if (c.name == name) return c;
    }
  }
  throw InvalidInput("candidate", "'" + name + "'", "a name of the ranking", "see 'ranking'");
}

Diagnosis diagnose(const Study& study, const Observations& observations) {
  require_rows(study);
  Diagnosis d;
  d.ranking.push_back(fit_candidate(study, observations, {}));
  {
    const Candidate baseline = d.ranking.front();
    std::vector<double> velocity;
    std::vector<double> sigma;
    for (const Observation& o : observations.list) {
      if (o.row.kind() != KatRow::Kind::critical_diameter) continue;
      velocity.push_back(o.row.impact_velocity_m_s);
      sigma.push_back(o.sigma);
    }
    if (velocity.size() == observations.list.size())
      d.patterns = foreign_patterns(velocity, baseline.solution.residuals, sigma);
    for (const physics::EffectEntry& entry : physics::effect_registry()) {
      const std::string& name = entry.info->name;
      const bool there = std::any_of(study.effects.begin(), study.effects.end(),
                                     [&](const EffectChoice& e) { return e.name == name; });
      if (there || most_parameters(study, {name}) > observations.list.size()) continue;
      Candidate c = fit_single(study, observations, name, baseline);
      c.acts = !same_predictions(c, baseline);
      if (!c.acts) c.why = "it cannot be seen in these measurements, or its best fit is to vanish";
      d.ranking.push_back(std::move(c));
    }
  }
  sort_by_bic(d.ranking);
  // An effect that does nothing comes after the baseline, whatever rounding made of its BIC.
  const double bic_of_none = d.baseline().bic;
  std::stable_partition(d.ranking.begin(), d.ranking.end(), [&](const Candidate& c) {
    return c.added.empty() || (c.acts && c.bic < bic_of_none);
  });

  std::vector<const Candidate*> leading;
  const Pattern* pattern = best_pattern(d.patterns, observations);
  const bool fails =
      residuals_fail(d.baseline().tests, d.baseline().solution.residuals, observations);
  const bool held_back = d.baseline().held_back();
  if (!fails) {
    d.verdict = held_back ? Verdict::ambiguous : Verdict::no_missing_effect;
    // The simplest that suffices is the best, whatever a parameter more may gain by accident.
    std::stable_partition(d.ranking.begin(), d.ranking.end(),
                          [](const Candidate& c) { return c.added.empty(); });
    leading = {&d.baseline()};
    for (const Candidate& c : d.ranking) {
      if (c.acts && !c.added.empty()) {
        leading.push_back(&c);
        break;
      }
    }
  } else {
    const Candidate& none = d.baseline();
    std::vector<const Candidate*> enough;
    for (const Candidate& c : d.ranking) {
      if (!c.added.empty() && suffices(c, none, observations)) enough.push_back(&c);
    }
    if (enough.empty()) {
      d.pairs = fit_pairs(study, observations, d.ranking);
      for (const Candidate& c : d.pairs) {
        if (suffices(c, none, observations) && c.bic < d.ranking.front().bic - kClears)
          enough.push_back(&c);
      }
      d.verdict = enough.empty() ? Verdict::unexplained : Verdict::ambiguous;
    }
    if (!enough.empty()) {
      for (const Candidate* c : enough) {
        if (c->bic < enough.front()->bic + kApart) leading.push_back(c);
      }
      const bool single = enough.front()->added.size() == 1;
      if (single && !enough.front()->plausible) {
        // With an assumed noise BIC itself is uncertain: any plausible one that suffices is named.
        const double within = observations.known() ? enough.front()->bic + kPlausibleWithin
                                                   : std::numeric_limits<double>::infinity();
        const auto plausible = std::find_if(enough.begin(), enough.end(), [&](const Candidate* c) {
          return c->plausible && c->bic < within;
        });
        if (plausible != enough.end() &&
            std::find(leading.begin(), leading.end(), *plausible) == leading.end()) {
          leading.push_back(*plausible);
        }
      }
      const bool foreign =
          pattern != nullptr && pattern_bic(*pattern, observations) < enough.front()->bic + kApart;
      // A bound that holds the baseline back may make any effect look needed.
      const bool at_bound = enough.front()->held_back() || held_back;
      d.verdict = single && leading.size() == 1 && !at_bound && !foreign ? Verdict::missing_effect
                                                                         : Verdict::ambiguous;
      const auto plausible = std::find_if(leading.begin(), leading.end(),
                                          [](const Candidate* c) { return c->plausible; });
      d.best = (plausible != leading.end() ? *plausible : leading.front())->name;
      for (const Candidate* c : leading) d.indistinguishable.push_back(c->name);
    } else {
      leading = {&d.ranking.front()};
      if (d.ranking.size() > 1) leading.push_back(&d.ranking[1]);
    }
  }
  d.next = next_measurement(study, observations, leading);
  d.words = verdict_words(study, observations, d, pattern);
  return d;
}

}  // namespace powderlink::analysis
