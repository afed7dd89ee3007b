// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/observation.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "analysis/critical_diameter.h"

namespace powderlink::analysis {

namespace {

constexpr double kFewestReplicates = 3.0;    // degrees of freedom that make an estimate of its own
constexpr double kWeightOfAssumption = 2.0;  // degrees of freedom, beside those of replicates

/// Squares around the means of rows that repeat a velocity, and their degrees of freedom.
struct PureError {
  double sum = 0.0;
  double degrees_of_freedom = 0.0;
};

PureError pure_error(const std::vector<KatRow>& rows) {
  std::map<double, std::vector<double>> groups;
  for (const KatRow& row : rows)
    groups[row.impact_velocity_m_s].push_back(std::log(*row.critical_diameter_um));
  PureError e;
  for (const auto& [velocity, values] : groups) {
    double mean = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values) e.sum += (v - mean) * (v - mean);
    e.degrees_of_freedom += static_cast<double>(values.size()) - 1.0;
  }
  return e;
}

}  // namespace

std::string Noise::text() const {
  const std::string form =
      fmt::format(" and {:.2g} % for the model's own form", 100.0 * discrepancy);
  switch (origin) {
    case Origin::stated:
      return fmt::format("noise of the table ({:.2g} % on average){}", 100.0 * relative, form);
    case Origin::replicates:
      return fmt::format("noise of {:.2g} % from repeated drops ({:g} degrees of freedom){}",
                         100.0 * relative, degrees_of_freedom, form);
    case Origin::assumed:
      break;
  }
  return fmt::format(
      "no sigma in the table and no repeated drops: {:.2g} % assumed; chi^2 is no test then, only "
      "trends and the comparison of effects count",
      100.0 * relative);
}

Observations observe(const Study& study) {
  Observations o;
  bool stated = true;
  for (const KatRow& row : study.rows) {
    if (!row.critical_diameter_um) {
      throw InvalidInput(study.file.string() + ", [study] measurements",
                         "no measured diameters to fit to or compare with",
                         "a file with the column critical_diameter_um",
                         "name the measurement file, or for 'powderlink kat run' give a number to "
                         "fix the adhesive energy");
    }
    stated = stated && row.critical_diameter_sigma_um.has_value();
  }
  o.noise.discrepancy = study.model_discrepancy;
  if (!stated) {
    const PureError e = pure_error(study.rows);
    o.noise.origin = e.degrees_of_freedom >= kFewestReplicates ? Noise::Origin::replicates
                                                               : Noise::Origin::assumed;
    o.noise.degrees_of_freedom = e.degrees_of_freedom;
    o.noise.relative = o.noise.origin == Noise::Origin::assumed
                           ? kAssumedRelativeNoise
                           : std::sqrt((e.sum + kWeightOfAssumption * kAssumedRelativeNoise *
                                                    kAssumedRelativeNoise) /
                                       (e.degrees_of_freedom + kWeightOfAssumption));
  }
  const double n = static_cast<double>(study.rows.size());
  for (const KatRow& row : study.rows) {
    double noise = o.noise.relative;
    if (stated) {
      noise = *row.critical_diameter_sigma_um / *row.critical_diameter_um;
      o.noise.relative += noise / n;
    }
    const double form = o.noise.known() ? o.noise.discrepancy : 0.0;
    o.list.push_back({row, *row.critical_diameter_um, std::hypot(noise, form)});
  }
  return o;
}

double predicted_diameter_um(const Study& study, const Hypothesis& hypothesis, const KatRow& row) {
  const ReducedModel model(
      row_setup(study, hypothesis.effects, row,
                row.adhesive_energy_J_m2.value_or(hypothesis.adhesive_energy_J_m2)));
  double diameter = quick_critical_diameter(model, row.impact_velocity_m_s).diameter_m;
  for (const auto& effect : model.setup().effects) diameter = effect->observed_diameter_m(diameter);
  return diameter * 1e6;
}

double residual(const Observation& o, double predicted) {
  return (predicted / o.measured - 1.0) / o.sigma;
}

}  // namespace powderlink::analysis
