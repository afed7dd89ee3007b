// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate_setting.h"

#include <algorithm>
#include <cmath>

#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

constexpr double kScale = 30.0;  // upper over lower bound of a parameter with a scale

/// Decades that a value is outside its plausible range.
double decades_off(double value, const Slot& slot) {
  if (value > slot.plausible_upper && slot.plausible_upper > 0.0)
    return std::log10(value / slot.plausible_upper);
  if (value < slot.plausible_lower)
    return std::log10(slot.plausible_lower / std::max(value, 1e-300));
  return 0.0;
}

void add_slot(Setting& s, Slot slot, const std::string& name, double lower, double upper,
              double start) {
  slot.lower = lower;
  slot.upper = upper;
  s.slots.push_back(slot);
  const bool scale = lower > 0.0 && upper > kScale * lower;
  s.problem.parameters.push_back({name, lower, upper, start, scale});
}

}  // namespace

void apply(Hypothesis& h, const std::vector<Slot>& slots, const std::vector<double>& values) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].effect < 0)
      h.adhesive_energy_J_m2 = values[i];
    else
      h.effects[static_cast<std::size_t>(slots[i].effect)].parameters[slots[i].parameter] =
          values[i];
  }
}

void define_residuals(Setting& s, const Study& study, const Observations& observations) {
  s.problem.residuals = [&study, &observations, hypothesis = s.hypothesis,
                         slots = s.slots](const std::vector<double>& values) {
    Hypothesis h = hypothesis;
    apply(h, slots, values);
    std::vector<double> r;
    r.reserve(observations.list.size());
    for (const Observation& o : observations.list)
      r.push_back(residual(o, predicted(study, h, o.row)));
    return r;
  };
  s.problem.prior = [slots = s.slots](const std::vector<double>& values) {
    std::vector<double> r;
    r.reserve(slots.size());
    for (std::size_t j = 0; j < slots.size(); ++j) r.push_back(decades_off(values[j], slots[j]));
    return r;
  };
}

Setting make_setting(const Study& study, const Observations& observations,
                     const std::vector<std::string>& added) {
  Setting s;
  s.hypothesis.effects = study.effects;
  s.hypothesis.estimated = added.size() > 1;
  const EnergyRange& energy = study.adhesive_energy;
  s.hypothesis.adhesive_energy_J_m2 = std::sqrt(energy.lower_J_m2 * energy.upper_J_m2);
  const bool of_rows = study.rows.front().adhesive_energy_J_m2.has_value();
  if (!of_rows && !energy.fixed()) {
    add_slot(s, {-1, 0, false, 0.0, kPlausibleEnergy_J_m2}, kEnergy, energy.lower_J_m2,
             energy.upper_J_m2, s.hypothesis.adhesive_energy_J_m2);
  }
  for (std::size_t e = 0; e < study.effects.size(); ++e) {
    const auto& info = *physics::find_effect(study.effects[e].name).info;
    for (const FreeRange& range : study.effects[e].free) {
      if (given_by_rows(study, study.effects[e].name, range.parameter)) continue;
      const physics::EffectParameter& p = info.parameters[range.parameter];
      add_slot(s,
               {static_cast<int>(e), range.parameter, false, p.plausible_lower, p.plausible_upper},
               p.name, range.lower, range.upper, study.effects[e].parameters[range.parameter]);
    }
  }
  for (const std::string& name : added) {
    const auto& info = *physics::find_effect(name).info;
    EffectChoice choice{name, {}};
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      const physics::EffectParameter& p = info.parameters[i];
      choice.parameters.push_back(p.typical);
      if (given_by_rows(study, name, i)) continue;
      add_slot(s,
               {static_cast<int>(s.hypothesis.effects.size()), i, true, p.plausible_lower,
                p.plausible_upper},
               p.name, p.lower, p.upper, p.typical);
    }
    s.hypothesis.effects.push_back(choice);
  }
  define_residuals(s, study, observations);
  return s;
}

}  // namespace powderlink::analysis
