// SPDX-License-Identifier: GPL-3.0-or-later
/// \file observation.h
/// What was measured, what a hypothesis predicts for it, and the residual between them.
///
///   critical diameter   r = (d_model/d_measured - 1)/sigma,  sigma relative
///
/// sigma^2 = noise^2 + discrepancy^2. The discrepancy is what the model's own form may be off when
/// every effect is right (the shape of a pulse, the force law of a bridge): stated, not fitted.
/// Noise: of the table; else of rows that repeat a drop; else assumed, and then chi^2 is no test.
/// Units: um, m/s. Tests: tests/analysis/evidence_fit_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/study.h"

namespace powderlink::analysis {

/// What is taken to act: effects with their parameters, and the interface's work of adhesion.
struct Hypothesis {
  std::vector<EffectChoice> effects;
  double adhesive_energy_J_m2 = 0.0;
};

struct Observation {
  KatRow row;
  double measured = 0.0;  ///< [um]
  double sigma = 0.0;     ///< relative, with the discrepancy
};

struct Noise {
  enum class Origin { stated, replicates, assumed };
  Origin origin = Origin::stated;
  double relative = 0.0;            ///< typical value
  double degrees_of_freedom = 0.0;  ///< behind an estimate from replicates
  double discrepancy = 0.0;         ///< of the model's form, relative
  /// chi^2 can be compared with its distribution only where the noise is known.
  bool known() const { return origin != Origin::assumed; }
  std::string text() const;
};

struct Observations {
  std::vector<Observation> list;
  Noise noise;
};

inline constexpr double kAssumedRelativeNoise = 0.05;

/// Throws InvalidInput for a study without measured diameters.
Observations observe(const Study& study);

/// d_c that would be read [um]; the end of the searched range when nothing or everything leaves.
double predicted_diameter_um(const Study& study, const Hypothesis& hypothesis, const KatRow& row);

/// In sigmas.
double residual(const Observation& observation, double predicted);

}  // namespace powderlink::analysis
