// SPDX-License-Identifier: GPL-3.0-or-later
/// \file candidate_setting.h
/// What a candidate fits: the free values of a study and of added effects, and the residuals they give.
///
/// Prior: a value outside its plausible range adds the decades that it is off to the residuals.
/// Errors: none; the study is valid.
/// Source: bounds and plausible ranges are those of physics/effects/effects.def.
/// Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/evidence/observation.h"
#include "base/statistics/least_squares.h"

namespace powderlink::analysis {

inline constexpr const char* kEnergy = "adhesive_energy_J_m2";

/// Upper end of the plausible range of the adhesive energy: dry solids do not go beyond it. It stands
/// here because Gamma is no parameter of an effect and so has no line in physics/effects/effects.def.
inline constexpr double kPlausibleEnergy_J_m2 = 10.0;

/// Where a fitted value goes.
struct Slot {
  int effect = -1;  ///< position in the hypothesis; -1 is the adhesive energy
  std::size_t parameter = 0;
  bool of_added = false;
  double plausible_lower = 0.0, plausible_upper = 0.0;
  double lower = 0.0, upper = 0.0;  ///< of the study or the registry; a fit may take narrower ones
};

struct Setting {
  Hypothesis hypothesis;
  std::vector<Slot> slots;
  FitProblem problem;
  bool calibrated = false;  ///< estimates, corrected by the integration where the fit is
};

/// Puts the values into their places.
void apply(Hypothesis& h, const std::vector<Slot>& slots, const std::vector<double>& values);

/// Residuals and prior of s.problem, for the hypothesis and slots that s has now.
/// \param study, observations  must outlive s
void define_residuals(Setting& s, const Study& study, const Observations& observations);

/// The adhesive energy comes first if it is free, then the study's own free values, then the added ones.
Setting make_setting(const Study& study, const Observations& observations,
                     const std::vector<std::string>& added);

}  // namespace powderlink::analysis
