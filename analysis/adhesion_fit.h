// SPDX-License-Identifier: GPL-3.0-or-later
/// \file adhesion_fit.h
/// One adhesive energy for all rows of a study: weighted least squares on log d_c,
///
///   chi^2(Gamma) = sum ((ln d_model - ln d_measured) / (sigma/d))^2,
///
/// with the reduced model, inside the study's bounds. sigma/d is 0.05 where it was not measured.
/// Units: J/m^2. Errors: InvalidInput when there is nothing to fit to.
/// Tests: tests/analysis/adhesion_fit_test.cpp
#pragma once

#include <vector>

#include "analysis/study.h"

namespace powderlink::analysis {

struct AdhesionFit {
  double adhesive_energy_J_m2 = 0.0;
  double chi2 = 0.0;
  double rms_relative_error = 0.0;
  bool at_bound = false;  ///< the best value is at an end of the bounds
};

AdhesionFit fit_adhesive_energy(const Study& study);

/// Gamma of every row: of its own column, the study's fixed value, or one fit for all.
struct RowEnergies {
  std::vector<double> adhesive_energy_J_m2;
  std::string origin;  ///< "of the measurement file" | "fixed in the study" | "fitted ..."
  bool fitted = false;
};
RowEnergies row_energies(const Study& study);

}  // namespace powderlink::analysis
