// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/added_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace powderlink::analysis {

Candidate fit_single(const Study& study, const Observations& observations,
                     const std::string& effect, const Candidate& baseline) {
  return fit_candidate(study, observations, {effect}, {&baseline});
}

Candidate fit_pair(const Study& study, const Observations& observations, const Candidate& one,
                   const Candidate& other) {
  const bool in_order = one.bic <= other.bic;
  const Candidate& first = in_order ? one : other;
  const Candidate& second = in_order ? other : one;
  return fit_candidate(study, observations, {first.name, second.name}, {&first, &second});
}

Candidate fit_added(const Study& study, const Observations& observations,
                    const std::vector<std::string>& effects) {
  constexpr std::size_t most = 2;
  if (effects.empty() || effects.size() > most) {
    throw InvalidInput("effects to add", fmt::format("'{}'", fmt::join(effects, "+")),
                       "one, or two as a+b",
                       "add two, then others to the new study with 'powderlink add'");
  }
  const Candidate baseline = fit_candidate(study, observations, {});
  const Candidate first = fit_single(study, observations, effects.front(), baseline);
  if (effects.size() == 1) return first;
  return fit_pair(study, observations, first,
                  fit_single(study, observations, effects.back(), baseline));
}

}  // namespace powderlink::analysis
