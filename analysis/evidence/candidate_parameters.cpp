// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text/units.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

/// An implausible fit whose Gamma lies at a bound that the study set within the plausible range: with a
/// wider bound it might look otherwise.
void mark_bound_of_study(Candidate& c, const Study& study) {
  constexpr double margin = 1.001;
  const EnergyRange& bounds = study.adhesive_energy;
  const bool implausible = std::any_of(c.parameters.begin(), c.parameters.end(),
                                       [](const ParameterEstimate& p) { return !p.plausible(); });
  if (!implausible || bounds.fixed() || bounds.upper_J_m2 >= kPlausibleEnergy_J_m2) return;
  for (ParameterEstimate& p : c.parameters) {
    if (p.effect.empty() && p.role == ParameterEstimate::Role::fitted &&
        p.value * margin >= bounds.upper_J_m2)
      p.at_bound = p.held_back = true;
  }
}

}  // namespace

std::string bound_text(const ParameterEstimate& p) {
  return fmt::format("{} = {:.4g} stopped at a bound of the fit, {:g} to {:g}{}", p.name, p.value,
                     p.lower, p.upper, p.held_back ? "" : "; the data do not mind");
}

void list_parameters(Candidate& c, const Setting& s, const Study& study) {
  const auto slot_of = [&](int effect, std::size_t parameter) -> std::optional<std::size_t> {
    for (std::size_t j = 0; j < s.slots.size(); ++j) {
      if (s.slots[j].effect == effect && (effect < 0 || s.slots[j].parameter == parameter))
        return j;
    }
    return std::nullopt;
  };
  const auto fitted = [&](ParameterEstimate& p, std::size_t j) {
    p.role = ParameterEstimate::Role::fitted;
    p.lower = s.problem.parameters[j].lower;
    p.upper = s.problem.parameters[j].upper;
    // The end of a plausible range is no bound of the data: it counts when they push against it.
    const bool at_lower = p.value - p.lower < p.upper - p.value;
    const bool narrowed = at_lower ? p.lower > s.slots[j].lower : p.upper < s.slots[j].upper;
    p.at_bound = c.solution.at_bound[j] && (!narrowed || c.solution.pushed);
    // Beyond the registry's own bounds an effect often acts no more: the data need not mind.
    p.held_back = p.at_bound && (!s.slots[j].of_added || c.solution.pushed);
  };
  if (!study.rows.front().adhesive_energy_J_m2) {
    ParameterEstimate p;
    p.name = kEnergy;
    p.value = c.hypothesis.adhesive_energy_J_m2;
    p.plausible_upper = kPlausibleEnergy_J_m2;
    p.source = "work of adhesion of dry solids, 0.01 to 1 J/m^2 as a rule";
    if (const auto j = slot_of(-1, 0)) fitted(p, *j);
    c.parameters.push_back(p);
  }
  for (std::size_t e = 0; e < c.hypothesis.effects.size(); ++e) {
    const EffectChoice& choice = c.hypothesis.effects[e];
    const auto& info = *physics::find_effect(choice.name).info;
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      if (given_by_rows(study, choice.name, i)) continue;
      const physics::EffectParameter& known = info.parameters[i];
      ParameterEstimate p;
      p.name = known.name;
      p.effect = choice.name;
      p.value = choice.parameters[i];
      p.plausible_lower = known.plausible_lower;
      p.plausible_upper = known.plausible_upper;
      p.source = known.source;
      if (const auto j = slot_of(static_cast<int>(e), i))
        fitted(p, *j);
      else if (e >= study.effects.size())
        p.role = ParameterEstimate::Role::held;
      c.parameters.push_back(p);
    }
  }
}

void judge_plausibility(Candidate& c, const Study& study) {
  mark_bound_of_study(c, study);
  std::vector<std::string> reasons;
  for (const ParameterEstimate& p : c.parameters) {
    if (!p.plausible()) {
      const std::string unit = unit_of(p.name);
      reasons.push_back(fmt::format("{} = {:.3g}{} is outside {:g} to {:g} ({})", p.name, p.value,
                                    unit == "-" ? "" : " " + unit, p.plausible_lower,
                                    p.plausible_upper, p.source));
    }
    if (p.at_bound) reasons.push_back(bound_text(p));
    c.plausible = c.plausible && p.plausible();
  }
  c.why = reasons.empty() ? "all parameters are within their plausible ranges"
                          : fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace powderlink::analysis
