// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/study_fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/evidence/candidate.h"

namespace powderlink::analysis {

namespace {

bool energy_of_rows(const Study& study) {
  return study.rows.front().adhesive_energy_J_m2.has_value();
}

bool anything_free(const Study& study) {
  const bool energy = !energy_of_rows(study) && !study.adhesive_energy.fixed();
  return energy || std::any_of(study.effects.begin(), study.effects.end(),
                               [](const EffectChoice& e) { return !e.free.empty(); });
}

}  // namespace

StudyFit with_values_of(const Study& study, const Candidate& fit) {
  StudyFit result{study, {}, "", false, fit.held_back()};
  result.study.effects = fit.hypothesis.effects;
  for (const KatRow& row : study.rows) {
    result.adhesive_energy_J_m2.push_back(
        row.adhesive_energy_J_m2.value_or(fit.hypothesis.adhesive_energy_J_m2));
  }
  result.fitted = fit.fitted() > 0;
  if (energy_of_rows(study)) {
    result.origin = "of the measurement file";
  } else if (study.adhesive_energy.fixed()) {
    result.origin = "fixed in the study";
  } else {
    result.origin = fmt::format("fitted to all rows with the reduced model, within [{:g}, {:g}]{}",
                                study.adhesive_energy.lower_J_m2, study.adhesive_energy.upper_J_m2,
                                result.at_bound ? ", and stuck at a bound" : "");
  }
  return result;
}

StudyFit fit_study(const Study& study) {
  if (anything_free(study)) {
    const Observations observations = observe(study);
    return with_values_of(study, fit_candidate(study, observations, {}));
  }
  Candidate given;
  given.hypothesis = {study.effects, study.adhesive_energy.lower_J_m2};
  return with_values_of(study, given);
}

}  // namespace powderlink::analysis
