// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of predicted curves against J Sigma J^T in closed form, however the bounds are spelled.
#include "analysis/evidence/next_measurement.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "analysis/evidence/candidate.h"
#include "analysis/kat/study/material_library.h"

namespace powderlink::analysis {
namespace {

constexpr double kSigma = 0.03;
const std::vector<double> kVelocities = {1.5, 2.1, 3.0, 4.2, 6.0};

Study glass_study(double energy, const EffectChoice& effect) {
  Study s;
  s.file = "study.toml";
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.effects = {effect};
  s.adhesive_energy = {energy, energy};
  s.model_discrepancy = 0.0;
  for (const double v : kVelocities) {
    KatRow row{v};
    row.critical_diameter_um = predicted_diameter_um(s, {s.effects, energy}, row);
    row.critical_diameter_sigma_um = kSigma * *row.critical_diameter_um;
    s.rows.push_back(row);
  }
  return s;
}

/// Half the width of the band in ln d, with the first parameter of the effect free.
std::vector<double> half_band(Study s, double lower, double upper) {
  s.effects[0].free = {{0, lower, upper}};
  const Observations o = observe(s);
  const PredictedCurve curve = predicted_curve(s, fit_candidate(s, o, {}), kVelocities);
  std::vector<double> half;
  for (std::size_t i = 0; i < kVelocities.size(); ++i)
    half.push_back(0.5 * std::log(curve.high_um[i] / curve.low_um[i]));
  return half;
}

// Bounds beyond a factor 30 are taken in the logarithm, others not.
constexpr double kLinear = 29.0, kLogarithmic = 31.0;

TEST(PredictedBand, OfOnePowerIsTheErrorOfTheMean) {
  // A slow stop: d_c ~ tau^-p, so that ln d_c is known to sigma/sqrt(n) everywhere, whatever p is.
  const Study s = glass_study(0.09, {"finite_stop_pulse", {1e-4, 0.0}});
  constexpr double one_sided = 0.01;  // half a step of 1 %, times p + 1
  for (const double factor : {kLinear, kLogarithmic}) {
    for (const double h : half_band(s, 1e-5, factor * 1e-5))
      EXPECT_NEAR(h / (kSigma / std::sqrt(5.0)), 1.0, one_sided) << factor;
  }
}

TEST(PredictedBand, OfTwoParametersIsJSigmaJ) {
  // d^-q = d_c^-q + D^-q and d_c ~ Gamma: dln d = w dln Gamma + (1 - w) dln D, w = (d/d_c)^q.
  constexpr double energy = 50.0, largest_um = 50.0, q = 8.0;
  Study s = glass_study(energy, {"psd_cutoff", {largest_um, q}});
  s.adhesive_energy = {0.001, 1000.0};
  Eigen::MatrixXd slopes(5, 2);
  for (long i = 0; i < 5; ++i) {
    const KatRow& row = s.rows[static_cast<std::size_t>(i)];
    const double w =
        std::pow(*row.critical_diameter_um / predicted_diameter_um(s, {{}, energy}, row), q);
    slopes.row(i) << w, 1.0 - w;
  }
  const Eigen::MatrixXd covariance = kSigma * kSigma * (slopes.transpose() * slopes).inverse();
  const std::vector<double> linear = half_band(s, 30.0, kLinear * 30.0);
  const std::vector<double> logarithmic = half_band(s, 30.0, kLogarithmic * 30.0);
  constexpr double one_sided = 0.04;  // a step of 1 % moves w by up to q/4 of it; twice
  constexpr double spelled = 2e-3;    // the fits stop this close to each other
  for (long i = 0; i < 5; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double half = std::sqrt(slopes.row(i) * covariance * slopes.row(i).transpose());
    EXPECT_NEAR(linear[at] / half, 1.0, one_sided) << kVelocities[at];
    EXPECT_NEAR(linear[at] / logarithmic[at], 1.0, spelled) << kVelocities[at];
  }
}

TEST(PredictedBand, DoesNotVanishAtABound) {
  const Study s = glass_study(0.09, {"finite_stop_pulse", {1e-4, 0.0}});
  constexpr double one_sided = 0.01;
  for (const double h : half_band(s, 1e-5, 1e-4))
    EXPECT_NEAR(h / (kSigma / std::sqrt(5.0)), 1.0, one_sided);
}

}  // namespace
}  // namespace powderlink::analysis
