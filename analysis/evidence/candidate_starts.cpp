// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/candidate_starts.h"

#include <algorithm>
#include <cmath>

namespace powderlink::analysis {

namespace {

constexpr std::size_t kStarts = 3;
constexpr std::size_t kNearStarts = 2;
constexpr int kEnergies = 25;  // values of the adhesive energy that are tried

using Found = std::pair<double, std::vector<double>>;  // chi^2 and its values

/// Of each valley the best; ties keep the earlier one. Where the adhesive energy is scanned (the first
/// value), it tells valleys apart; else points with one energy and nearly one chi^2 are of one valley: an
/// added effect that hardly acts has as many of them as its axis has values.
std::vector<std::vector<double>> best_of(std::vector<Found> found, std::size_t most,
                                         bool energy_scanned) {
  constexpr double same = 0.01;  // of chi^2 and of the energy
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Found> kept;
  for (Found& f : found) {
    if (kept.size() == most) break;
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const Found& k) {
      return !f.second.empty() &&
             std::fabs(f.second[0] - k.second[0]) <= same * std::fabs(k.second[0]) &&
             (energy_scanned || std::fabs(f.first - k.first) <= same * k.first);
    });
    if (!seen) kept.push_back(std::move(f));
  }
  std::vector<std::vector<double>> starts;
  for (Found& k : kept) starts.push_back(std::move(k.second));
  return starts;
}

std::vector<double> grid_of(const FitParameter& p, double from, double to, int points) {
  std::vector<double> grid;
  grid.reserve(static_cast<std::size_t>(points));
  const double low = p.to_coordinate(std::clamp(from, p.lower, p.upper));
  const double high = p.to_coordinate(std::clamp(to, p.lower, p.upper));
  for (int i = 0; i < points; ++i)
    grid.push_back(
        std::clamp(p.to_value(low + (high - low) * i / std::max(1, points - 1)), p.lower, p.upper));
  return grid;
}

/// Every point of the grid with every value of one more coordinate.
void append_axis(std::vector<std::vector<double>>& grid, const std::vector<double>& values) {
  std::vector<std::vector<double>> product;
  for (const auto& head : grid) {
    for (const double v : values) {
      product.push_back(head);
      product.back().push_back(v);
    }
  }
  grid = std::move(product);
}

bool diameters_only(const Study& study) {
  return std::all_of(study.rows.begin(), study.rows.end(), [](const KatRow& row) {
    return row.kind() == KatRow::Kind::critical_diameter;
  });
}

}  // namespace

std::pair<std::vector<double>, double> suit_energy(const Setting& s, const Observations& all,
                                                   std::vector<double> values, int turns) {
  constexpr double power = 0.8;
  constexpr double good = 0.02;  // of ln d
  std::vector<double> r = s.problem.residuals(values);
  if (s.slots.empty() || s.slots[0].effect >= 0) return {values, sum_of_squares(r)};
  double best = sum_of_squares(r);
  std::vector<double> best_values = values;
  for (int turn = 0; turn < turns; ++turn) {
    double mean = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      constexpr double smallest = 1e-3;  // of d_model/d_measured
      const double sigma = all.list[i].sigma;
      mean += std::log(std::max(1.0 + r[i] * sigma, smallest)) / (sigma * sigma);
      weight += 1.0 / (sigma * sigma);
    }
    mean /= weight;
    if (std::fabs(mean) < good) break;
    const FitParameter& p = s.problem.parameters[0];
    values[0] = std::clamp(values[0] * std::exp(-mean / power), p.lower, p.upper);
    r = s.problem.residuals(values);
    const double chi2 = sum_of_squares(r);
    if (chi2 < best) {
      best = chi2;
      best_values = values;
    }
  }
  return {best_values, best};
}

std::vector<std::vector<double>> searched_starts(const Study& study, const Setting& s,
                                                 const Observations& observations, bool fast) {
  const int turns = fast ? 8 : 4;
  std::size_t scanned = 0;
  for (const Slot& slot : s.slots) scanned += slot.effect >= 0 ? 1 : 0;
  const bool energy_scanned = !diameters_only(study);
  const bool few = !fast || energy_scanned;
  const int points = scanned <= 1 ? (few ? 9 : 31) : (few ? 4 : 7);
  std::vector<std::vector<double>> grid = {{}};
  for (std::size_t j = 0; j < s.slots.size(); ++j) {
    const FitParameter& p = s.problem.parameters[j];
    std::vector<double> values = {p.start};
    // Shares and speeds say nothing about Gamma while every grain stays or every grain leaves.
    if (s.slots[j].effect < 0 && energy_scanned) values = grid_of(p, p.lower, p.upper, kEnergies);
    if (s.slots[j].effect >= 0) values = grid_of(p, p.lower, p.upper, p.logarithmic ? points : 2);
    append_axis(grid, values);
  }
  std::vector<Found> found;
  for (const auto& values : grid) {
    auto [suited, chi2] = suit_energy(s, observations, values, turns);
    found.emplace_back(chi2, suited);
  }
  return best_of(std::move(found), kStarts, energy_scanned);
}

std::vector<std::vector<double>> near_starts(const Setting& s, const Observations& observations,
                                             const std::vector<const Candidate*>& near) {
  std::vector<Found> found;
  constexpr int points = 4;
  for (const Candidate* c : near) {
    std::vector<std::vector<double>> grid = {{}};
    for (std::size_t j = 0; j < s.slots.size(); ++j) {
      const FitParameter& p = s.problem.parameters[j];
      const ParameterEstimate* known = c->find(p.name);
      std::vector<double> values = {known != nullptr ? known->value : p.start};
      if (known == nullptr && s.slots[j].effect >= 0) {
        values =
            p.logarithmic ? grid_of(p, p.lower, p.upper, points + 2) : std::vector<double>{p.start};
        if (p.logarithmic) {
          values = {values.begin() + 1, values.end() - 1};
          values.push_back(p.start);  // typical
        }
      }
      append_axis(grid, values);
    }
    for (const auto& values : grid) {
      auto [suited, chi2] = suit_energy(s, observations, values, 3);
      found.emplace_back(chi2, suited);
    }
  }
  return best_of(std::move(found), kNearStarts, false);
}

}  // namespace powderlink::analysis
