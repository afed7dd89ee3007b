// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adhesion_fit.h"

#include <fmt/format.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "analysis/critical_diameter.h"

namespace powderlink::analysis {

namespace {

constexpr double kUnknownRelativeSigma = 0.05;
constexpr int kScan = 25;  // values over the bounds before the minimum is refined
constexpr int kBits = 12;  // of log Gamma: d_c itself is known to 1e-4
constexpr double kAtBound = 1e-3;

double log_error(const Study& study, const KatRow& row, double energy) {
  const ReducedModel model(row_setup(study, row, energy));
  const double diameter = critical_diameter(model, row.impact_velocity_m_s).diameter_m;
  return std::log(diameter * 1e6 / *row.critical_diameter_um);
}

}  // namespace

AdhesionFit fit_adhesive_energy(const Study& study) {
  for (const KatRow& row : study.rows) {
    if (!row.critical_diameter_um) {
      throw InvalidInput(study.file.string() + ", [fit] adhesive_energy_J_m2",
                         "bounds, but no measured diameters to fit to",
                         "one number, or a measurement file",
                         "give a number to fix the adhesive energy");
    }
  }
  const auto chi2 = [&](double log_energy) {
    double sum = 0.0;
    for (const KatRow& row : study.rows) {
      const double sigma = row.critical_diameter_sigma_um
                               ? *row.critical_diameter_sigma_um / *row.critical_diameter_um
                               : kUnknownRelativeSigma;
      sum += std::pow(log_error(study, row, std::exp(log_energy)) / sigma, 2);
    }
    return sum;
  };
  // A scan first: where nothing or everything detaches, chi^2 is flat and has no slope to follow.
  const double low = std::log(study.adhesive_energy.lower_J_m2);
  const double high = std::log(study.adhesive_energy.upper_J_m2);
  const double stride = (high - low) / (kScan - 1);
  double best = low;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kScan; ++i) {
    const double value = chi2(low + i * stride);
    if (value < least) {
      least = value;
      best = low + i * stride;
    }
  }
  const auto [log_energy, minimum] = boost::math::tools::brent_find_minima(
      chi2, std::max(low, best - stride), std::min(high, best + stride), kBits);

  AdhesionFit fit;
  fit.adhesive_energy_J_m2 = std::exp(log_energy);
  fit.chi2 = minimum;
  fit.at_bound = log_energy - low < kAtBound || high - log_energy < kAtBound;
  for (const KatRow& row : study.rows) {
    fit.rms_relative_error +=
        std::pow(std::expm1(log_error(study, row, fit.adhesive_energy_J_m2)), 2);
  }
  fit.rms_relative_error =
      std::sqrt(fit.rms_relative_error / static_cast<double>(study.rows.size()));
  return fit;
}

RowEnergies row_energies(const Study& study) {
  RowEnergies energies;
  if (study.rows.front().adhesive_energy_J_m2) {
    energies.origin = "of the measurement file";
    for (const KatRow& row : study.rows)
      energies.adhesive_energy_J_m2.push_back(*row.adhesive_energy_J_m2);
  } else if (study.adhesive_energy.fixed()) {
    energies.origin = "fixed in the study";
    energies.adhesive_energy_J_m2.assign(study.rows.size(), study.adhesive_energy.lower_J_m2);
  } else {
    const AdhesionFit fit = fit_adhesive_energy(study);
    energies.fitted = true;
    energies.origin =
        fmt::format("fitted to all rows with the reduced model, within [{:g}, {:g}]{}",
                    study.adhesive_energy.lower_J_m2, study.adhesive_energy.upper_J_m2,
                    fit.at_bound ? ", and stuck at a bound" : "");
    energies.adhesive_energy_J_m2.assign(study.rows.size(), fit.adhesive_energy_J_m2);
  }
  return energies;
}

}  // namespace powderlink::analysis
