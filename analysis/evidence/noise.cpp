// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/evidence/quantity.h"

namespace powderlink::analysis {

namespace {

constexpr double kFewestReplicates = 3.0;    // degrees of freedom that make an estimate of its own
constexpr double kWeightOfAssumption = 2.0;  // degrees of freedom, beside those of replicates
constexpr double kSameVelocity = 0.005;      // d_c ~ v^-1.2
constexpr double kSameTime = 0.02;           // d_c ~ tau^-0.5
constexpr double kSameEnergy = 0.005;        // d_c ~ Gamma
constexpr const char* kVelocitySigma = "impact_velocity_sigma_m_s";

bool within(std::optional<double> a, std::optional<double> b, double part) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::fabs(*a - *b) <= part * std::max(std::fabs(*a), std::fabs(*b));
}

bool same_drop(const KatRow& a, const KatRow& b) {
  double sigma = 0.0;
  for (const KatRow* row : {&a, &b}) {
    const auto column = row->other.find(kVelocitySigma);
    if (column != row->other.end()) sigma = std::max(sigma, column->second);
  }
  const double v = std::max(a.impact_velocity_m_s, b.impact_velocity_m_s);
  return within(a.impact_velocity_m_s, b.impact_velocity_m_s, std::max(kSameVelocity, sigma / v)) &&
         within(a.contact_time_us, b.contact_time_us, kSameTime) &&
         within(a.adhesive_energy_J_m2, b.adhesive_energy_J_m2, kSameEnergy);
}

/// Of one table; without the sentence on what an assumption means.
std::string source_text(const TableNoise& t) {
  const bool diameters = t.kind == KatRow::Kind::critical_diameter;
  const std::string mean =
      diameters ? fmt::format("{:.2g} %", 100.0 * t.mean) : fmt::format("{:.2g} m/s", t.mean);
  const std::string form =
      diameters ? fmt::format(" and {:.2g} % for the model's own form", 100.0 * t.discrepancy) : "";
  switch (t.origin) {
    case NoiseOrigin::counted:
      return "counts of grains";
    case NoiseOrigin::stated:
      return fmt::format("noise of the table ({} on average){}", mean, form);
    case NoiseOrigin::replicates:
      return fmt::format("noise of {} from repeated drops ({:g} degrees of freedom){}", mean,
                         t.degrees_of_freedom, form);
    case NoiseOrigin::assumed:
      break;
  }
  return diameters ? fmt::format("no sigma in the table and no repeated drops: {} assumed", mean)
                   : fmt::format("no sigma in the table: {:.2g} % of the impact velocity assumed",
                                 100.0 * kAssumedRelativeNoise);
}

}  // namespace

std::string TableNoise::text() const {
  return source_text(*this) + (origin == NoiseOrigin::assumed
                                   ? "; chi^2 is no test then, "
                                     "only trends and the comparison of effects count"
                                   : "");
}

TableNoise noise_of_unstated(const std::vector<KatRow>& rows) {
  std::vector<std::vector<const KatRow*>> drops;
  for (const KatRow& row : rows) {
    if (row.kind() != KatRow::Kind::critical_diameter || row.critical_diameter_sigma_um) continue;
    const auto drop = std::find_if(drops.begin(), drops.end(),
                                   [&](const auto& d) { return same_drop(*d.front(), row); });
    if (drop == drops.end())
      drops.push_back({&row});
    else
      drop->push_back(&row);
  }
  double squares = 0.0;
  TableNoise noise;
  for (const auto& drop : drops) {
    const double n = static_cast<double>(drop.size());
    double mean = 0.0;
    for (const KatRow* row : drop) mean += std::log(*row->critical_diameter_um) / n;
    for (const KatRow* row : drop)
      squares += std::pow(std::log(*row->critical_diameter_um) - mean, 2);
    noise.degrees_of_freedom += n - 1.0;
  }
  const bool enough = noise.degrees_of_freedom >= kFewestReplicates;
  noise.origin = enough ? NoiseOrigin::replicates : NoiseOrigin::assumed;
  noise.mean = kAssumedRelativeNoise;
  if (enough) {
    noise.mean =
        std::sqrt((squares + kWeightOfAssumption * kAssumedRelativeNoise * kAssumedRelativeNoise) /
                  (noise.degrees_of_freedom + kWeightOfAssumption));
  }
  return noise;
}

std::string noise_text(const std::vector<TableNoise>& tables, const Study& study) {
  if (tables.size() == 1) return tables.front().text();
  std::string text;
  for (const TableNoise& t : tables) {
    text += (text.empty() ? "" : "; ") + std::string(quantity_of(t.kind).plural);
    if (study.measurements.size() > 1)
      text += " of " + study.measurements[t.table].filename().string();
    text += ": " + source_text(t);
  }
  const bool assumed = std::any_of(tables.begin(), tables.end(), [](const TableNoise& t) {
    return t.origin == NoiseOrigin::assumed;
  });
  return text + (assumed ? "; chi^2 is no test of rows whose noise is assumed" : "");
}

}  // namespace powderlink::analysis
