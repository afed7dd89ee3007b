// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/critical_diameter.h"
#include "models/effect_registry.h"

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
  for (const KatRow& row : rows) {
    if (row.kind() != KatRow::Kind::critical_diameter) continue;
    groups[row.impact_velocity_m_s].push_back(std::log(*row.critical_diameter_um));
  }
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
      if (relative == 0.0) return "binomial counts and the noise of speeds";
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
    if (row.kind() != KatRow::Kind::critical_diameter) continue;
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
  double diameters = 0.0;
  for (const KatRow& row : study.rows)
    diameters += row.kind() == KatRow::Kind::critical_diameter ? 1.0 : 0.0;
  for (const KatRow& row : study.rows) {
    if (row.kind() == KatRow::Kind::retained_share) {
      const double n = *row.count_before;
      if (row.area_ratio) {
        // Both counts are Poisson.
        const double share = *row.count_after / (*row.area_ratio * n);
        const double relative = 1.0 / n + 1.0 / std::max(*row.count_after, 1.0);
        o.list.push_back(
            {row, share, std::max(share, 1.0 / (*row.area_ratio * n)) * std::sqrt(relative)});
        continue;
      }
      const double share = *row.count_after / n;
      o.list.push_back({row, share, std::sqrt(std::max(share * (1.0 - share), 0.25 / n) / n)});
      continue;
    }
    if (row.kind() == KatRow::Kind::residual_speed) {
      o.list.push_back({row, *row.residual_velocity_m_s,
                        row.residual_velocity_sigma_m_s.value_or(kAssumedRelativeNoise *
                                                                 row.impact_velocity_m_s)});
      continue;
    }
    double noise = o.noise.relative;
    if (stated) {
      noise = *row.critical_diameter_sigma_um / *row.critical_diameter_um;
      o.noise.relative += noise / diameters;
    }
    const double form = o.noise.known() ? o.noise.discrepancy : 0.0;
    o.list.push_back({row, *row.critical_diameter_um, std::hypot(noise, form)});
  }
  return o;
}

double Hypothesis::corrected(double diameter_m, const KatRow& row) const {
  const auto found = correction.find(conditions_of(row));
  if (found == correction.end()) return diameter_m;
  const std::map<double, double>& over_v = found->second;
  const double v = row.impact_velocity_m_s;
  const auto above = over_v.lower_bound(v);
  if (above == over_v.end()) return diameter_m * std::exp(over_v.rbegin()->second);
  if (above == over_v.begin()) return diameter_m * std::exp(above->second);
  const auto below = std::prev(above);
  const double part = std::log(v / below->first) / std::log(above->first / below->first);
  return diameter_m * std::exp(below->second + part * (above->second - below->second));
}

double predicted_diameter_um(const Study& study, const Hypothesis& hypothesis, const KatRow& row) {
  const ReducedModel model(
      row_setup(study, hypothesis.effects, row,
                row.adhesive_energy_J_m2.value_or(hypothesis.adhesive_energy_J_m2)));
  double diameter = hypothesis.corrected(
      quick_critical_diameter(model, row.impact_velocity_m_s, hypothesis.estimated).diameter_m,
      row);
  for (const auto& effect : model.setup().effects) diameter = effect->observed_diameter_m(diameter);
  return diameter * 1e6;
}

namespace {

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double retained_share(const Study& study, const Hypothesis& h, const KatRow& row) {
  constexpr double wrong_grains = 0.25;  // per class: moved, miscounted; keeps the deviance finite
  constexpr double half_class = 0.05;    // of the diameter, where the class has no limits
  constexpr double step = 0.05;          // of ln Gamma, for q
  const double energy = row.adhesive_energy_J_m2.value_or(h.adhesive_energy_J_m2);
  const auto critical_um = [&](double gamma) {
    const ReducedModel model(row_setup(study, h.effects, row, gamma));
    const double v = row.impact_velocity_m_s;
    return 1e6 * h.corrected(quick_critical_diameter(model, v, h.estimated).diameter_m, row);
  };
  double scatter = 0.0;
  for (const EffectChoice& e : h.effects) {
    const double of_effect = models::make_effect(e.name, e.parameters)->adhesion_log_std();
    scatter = std::hypot(scatter, of_effect);
  }
  const double critical = critical_um(energy);
  const double low = std::log(row.diameter_low_um.value_or(*row.diameter_um * (1 - half_class)));
  const double high = std::log(row.diameter_high_um.value_or(*row.diameter_um * (1 + half_class)));
  const double at = std::log(critical);
  double share = 0.0;
  if (scatter > 0.0) {
    const double q =
        step / std::max(1e-6, std::log(critical_um(energy * std::exp(step)) / critical));
    const double w = scatter / q;
    // Integral of Phi((at - u)/w) over u, by parts.
    const auto primitive = [&](double u) {
      const double x = (at - u) / w;
      return -w *
             (x * normal_cdf(x) + std::exp(-0.5 * x * x) / std::sqrt(2.0 * models::JkrLaw::kPi));
    };
    share = (primitive(high) - primitive(low)) / (high - low);
  } else {
    share = std::clamp((at - low) / (high - low), 0.0, 1.0);
  }
  const double wrong_way = wrong_grains / *row.count_before;
  return wrong_way + (1.0 - 2.0 * wrong_way) * share;
}

double residual_speed_m_s(const Study& study, const Hypothesis& h, const KatRow& row) {
  const ReducedModel model(
      row_setup(study, h.effects, row, row.adhesive_energy_J_m2.value_or(h.adhesive_energy_J_m2)));
  const DropOutcome outcome = model.drop(*row.diameter_um * 1e-6, row.impact_velocity_m_s);
  return outcome.detached ? outcome.speed_m_s : 0.0;
}

}  // namespace

double predicted(const Study& study, const Hypothesis& hypothesis, const KatRow& row) {
  switch (row.kind()) {
    case KatRow::Kind::retained_share:
      return retained_share(study, hypothesis, row);
    case KatRow::Kind::residual_speed:
      return residual_speed_m_s(study, hypothesis, row);
    case KatRow::Kind::critical_diameter:
      break;
  }
  return predicted_diameter_um(study, hypothesis, row);
}

double Observation::error(double model) const {
  return row.kind() == KatRow::Kind::critical_diameter ? model / measured - 1.0 : model - measured;
}

double residual(const Observation& o, double predicted) {
  if (o.row.kind() != KatRow::Kind::retained_share) return o.error(predicted) / o.sigma;
  const double k = *o.row.count_after;
  double n = *o.row.count_before;
  double share = predicted;
  if (o.row.area_ratio) {
    n += k;
    share = *o.row.area_ratio * predicted / (1.0 + *o.row.area_ratio * predicted);
  }
  const auto term = [](double count, double expected) {
    return count > 0.0 ? count * std::log(count / expected) : 0.0;
  };
  const double deviance = 2.0 * (term(k, n * share) + term(n - k, n * (1.0 - share)));
  return std::copysign(std::sqrt(std::max(0.0, deviance)), share - k / n);
}

}  // namespace powderlink::analysis
