// SPDX-License-Identifier: GPL-3.0-or-later
/// \file observation.h
/// What was measured, what a hypothesis predicts for it, and the residual between them.
///
///   critical diameter   r = (d_model/d_measured - 1)/sigma,  sigma relative
///   retained share      r^2 = deviance of k of n grains under the share p:
///                       2 (k ln(k/(n p)) + (n - k) ln((n - k)/(n (1 - p)))), r > 0 where p > k/n;
///                       two samples of areas 1 : a have k after, n before and after together, and
///                       p = a s/(1 + a s) for the share s
///   residual speed      r = (u_model - u_measured)/sigma
///
/// Retained share of a size class: mean of Phi(ln(d_c/d)/w) over ln d within the class, w = s/q, with s
/// the scatter of ln Gamma and q = dln Gamma/dln d_c; a quarter of a grain per class goes the wrong way.
/// sigma^2 = noise^2 + discrepancy^2. The discrepancy is what the model's own form may be off when
/// every effect is right (the shape of a pulse, the force law of a bridge): stated, not fitted.
/// Noise: noise.h, for every row on its own. Units: um, m/s.
/// Tests: tests/analysis/evidence/study_fit_test.cpp, tests/analysis/evidence/retention_test.cpp
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/evidence/noise.h"
#include "analysis/kat/study/study.h"

namespace powderlink::analysis {

/// What a drop has of its own beside its velocity: contact time [us], Gamma [J/m^2].
using RowConditions = std::pair<std::optional<double>, std::optional<double>>;
inline RowConditions conditions_of(const KatRow& row) {
  return {row.contact_time_us, row.adhesive_energy_J_m2};
}

/// What is taken to act: effects with their parameters, and the interface's work of adhesion.
struct Hypothesis {
  std::vector<EffectChoice> effects;
  double adhesive_energy_J_m2 = 0.0;
  bool estimated = false;  ///< sums of effects are estimated (critical_speed.h)
  /// ln(d_c integrated/estimated) over v [m/s], for each contact time and Gamma that rows have of their
  /// own; between its velocities linear in ln v. Where there is none the estimate stays.
  std::map<RowConditions, std::map<double, double>> correction{};
  double corrected(double diameter_m, const KatRow& row) const;
};

struct Observation {
  KatRow row;
  double measured = 0.0;  ///< [um], share, or [m/s]
  double noise = 0.0;     ///< of measured: relative for a diameter, of the share, or [m/s]
  double sigma = 0.0;     ///< the same with the discrepancy
  NoiseOrigin origin = NoiseOrigin::stated;
  /// chi^2 can be compared with its distribution only where the noise is known.
  bool known() const { return origin != NoiseOrigin::assumed; }
  /// Model over measured less one; for shares and speeds, which may be 0, their difference.
  double error(double predicted) const;
};

struct Observations {
  std::vector<Observation> list;
  std::vector<TableNoise> tables;
  std::string noise_text;
  bool known() const;  ///< the noise of all rows
  /// Mean of the diameters' noise; 0 without diameters.
  double relative_noise() const;
};

/// Throws InvalidInput for a study without measurements.
Observations observe(const Study& study);

/// d_c that would be read [um]; the end of the searched range when nothing or everything leaves.
double predicted_diameter_um(const Study& study, const Hypothesis& hypothesis, const KatRow& row);

/// What the row's measurement is compared with: d_c [um], retained share, residual speed [m/s].
double predicted(const Study& study, const Hypothesis& hypothesis, const KatRow& row);

/// In sigmas.
double residual(const Observation& observation, double predicted);

}  // namespace powderlink::analysis
