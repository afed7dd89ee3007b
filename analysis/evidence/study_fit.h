// SPDX-License-Identifier: GPL-3.0-or-later
/// \file study_fit.h
/// What a study leaves free, fitted: the adhesive energy and parameters given as [low, high].
/// Errors: InvalidInput when there is nothing to fit to. Tests: tests/analysis/evidence/study_fit_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/study/study.h"

namespace powderlink::analysis {

struct StudyFit {
  Study study;                               ///< with the fitted values in its effects
  std::vector<double> adhesive_energy_J_m2;  ///< per row
  std::string origin;  ///< "of the measurement file" | "fixed in the study" | "fitted ..."
  bool fitted = false;
  bool at_bound = false;
};

StudyFit fit_study(const Study& study);

/// The same from a fit that was made already.
struct Candidate;
StudyFit with_values_of(const Study& study, const Candidate& fit);

}  // namespace powderlink::analysis
