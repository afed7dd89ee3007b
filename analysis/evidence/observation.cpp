// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/observation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/kat/reduced/critical_diameter.h"
#include "physics/effects/effect_registry.h"

namespace powderlink::analysis {

namespace {

void require_diameters(const Study& study) {
  for (const KatRow& row : study.rows) {
    if (row.kind() != KatRow::Kind::critical_diameter || row.critical_diameter_um) continue;
    throw InvalidInput(study.file.string() + ", [study] measurements",
                       "no measured diameters to fit to or compare with",
                       "a file with the column critical_diameter_um",
                       "name the measurement file, "
                       "or for 'powderlink kat run' give a number to fix the adhesive energy");
  }
}

Observation of_counts(const KatRow& row) {
  const double n = *row.count_before;
  double share = *row.count_after / n;
  double sigma = std::sqrt(std::max(share * (1.0 - share), 0.25 / n) / n);
  if (row.area_ratio) {
    // Both counts are Poisson.
    share /= *row.area_ratio;
    const double relative = 1.0 / n + 1.0 / std::max(*row.count_after, 1.0);
    sigma = std::max(share, 1.0 / (*row.area_ratio * n)) * std::sqrt(relative);
  }
  return {row, share, sigma, sigma, NoiseOrigin::counted};
}

Observation of_speed(const KatRow& row) {
  const bool stated = row.residual_velocity_sigma_m_s.has_value();
  const double sigma =
      stated ? *row.residual_velocity_sigma_m_s : kAssumedRelativeNoise * row.impact_velocity_m_s;
  return {row, *row.residual_velocity_m_s, sigma, sigma,
          stated ? NoiseOrigin::stated : NoiseOrigin::assumed};
}

/// \param unstated  noise of diameters without sigma
Observation of_diameter(const KatRow& row, const TableNoise& unstated, double discrepancy) {
  Observation o{row, *row.critical_diameter_um, unstated.mean, unstated.mean, unstated.origin};
  if (row.critical_diameter_sigma_um) {
    o.noise = *row.critical_diameter_sigma_um / *row.critical_diameter_um;
    o.origin = NoiseOrigin::stated;
  }
  // An assumed noise is that of the whole difference.
  o.sigma = std::hypot(o.noise, o.known() ? discrepancy : 0.0);
  return o;
}

void count_in(std::vector<TableNoise>& tables, const Observation& o, const TableNoise& unstated,
              double discrepancy) {
  const auto same = [&](const TableNoise& t) {
    return t.table == o.row.table && t.kind == o.row.kind() && t.origin == o.origin;
  };
  auto t = std::find_if(tables.begin(), tables.end(), same);
  if (t == tables.end()) {
    TableNoise fresh;
    fresh.table = o.row.table;
    fresh.kind = o.row.kind();
    fresh.origin = o.origin;
    fresh.degrees_of_freedom = unstated.degrees_of_freedom;
    fresh.discrepancy = discrepancy;
    t = tables.insert(tables.end(), fresh);
  }
  t->mean += (o.noise - t->mean) / static_cast<double>(++t->rows);
}

}  // namespace

Observations observe(const Study& study) {
  require_diameters(study);
  const TableNoise unstated = noise_of_unstated(study.rows);
  Observations o;
  for (const KatRow& row : study.rows) {
    o.list.push_back(row.kind() == KatRow::Kind::retained_share ? of_counts(row)
                     : row.kind() == KatRow::Kind::residual_speed
                         ? of_speed(row)
                         : of_diameter(row, unstated, study.model_discrepancy));
    count_in(o.tables, o.list.back(), unstated, study.model_discrepancy);
  }
  o.noise_text = noise_text(o.tables, study);
  return o;
}

bool Observations::known() const {
  return std::all_of(list.begin(), list.end(), [](const Observation& o) { return o.known(); });
}

double Observations::relative_noise() const {
  double sum = 0.0;
  double rows = 0.0;
  for (const Observation& o : list) {
    if (o.row.kind() != KatRow::Kind::critical_diameter) continue;
    sum += o.noise;
    rows += 1.0;
  }
  return rows > 0.0 ? sum / rows : 0.0;
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
    const double of_effect = physics::make_effect(e.name, e.parameters)->adhesion_log_std();
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
             (x * normal_cdf(x) + std::exp(-0.5 * x * x) / std::sqrt(2.0 * physics::JkrLaw::kPi));
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
