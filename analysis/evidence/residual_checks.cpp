// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/residual_checks.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/statistics/fit_uncertainty.h"

namespace powderlink::analysis {

namespace {

constexpr const char* kVelocity = "impact_velocity_m_s";
constexpr std::size_t kFewest = 4;  // rows of a trend

struct Column {
  std::string name;
  std::function<std::optional<double>(const KatRow&)> value;
  bool curve = false;  // a parabola in its logarithm is tested too
  bool counts = true;
};

std::vector<Column> columns_of(const Observations& o) {
  std::vector<Column> columns = {
      {kVelocity, [](const KatRow& r) { return std::optional(r.impact_velocity_m_s); }, true},
      {"diameter_um", [](const KatRow& r) { return r.diameter_um; }, true},
      {"contact_time_us", [](const KatRow& r) { return r.contact_time_us; }},
      {"adhesive_energy_J_m2", [](const KatRow& r) { return r.adhesive_energy_J_m2; }}};
  std::set<std::string> unknown;
  for (const Observation& each : o.list) {
    for (const auto& [name, value] : each.row.other) unknown.insert(name);
  }
  for (const std::string& name : unknown) {
    const auto value = [name](const KatRow& r) {
      const auto found = r.other.find(name);
      return found == r.other.end() ? std::nullopt : std::optional(found->second);
    };
    columns.push_back({name, value, false, false});
  }
  return columns;
}

/// Under the model at least two grains stay and two leave, so that the residual may have either sign.
bool may_go_either_way(const Observation& o, double model) {
  constexpr double grains = 2.0;
  if (o.row.kind() != KatRow::Kind::retained_share) return true;
  const double n = *o.row.count_before;
  return n * model >= grains && n * (1.0 - model) >= grains;
}

void test_column(const Column& column, const Observations& o, const std::vector<double>& model,
                 const std::vector<double>& residuals, std::vector<TrendTest>& tests) {
  std::vector<double> x, r;
  bool known = true;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const auto value = column.value(o.list[i].row);
    if (!value || !may_go_either_way(o.list[i], model[i])) continue;
    x.push_back(*value);
    r.push_back(residuals[i]);
    known = known && o.list[i].known();
  }
  if (x.size() < kFewest || !spread(x)) return;
  const auto add = [&](const char* test, double p_value) {
    tests.push_back({column.name, test, p_value, 1.0, column.counts});
  };
  if (column.curve) add("curve", curve_p_value(x, r, known));
  add("rank", rank_p_value(x, r));
  add("runs", runs_p_value(x, r));
}

/// chi^2 of the rows whose noise is known.
void test_scatter(const Observations& o, const FitSolution& solution,
                  std::vector<TrendTest>& tests) {
  const std::vector<double> leverage = hat_diagonal(solution);
  std::vector<double> r;
  double fitted = 0.0;
  for (std::size_t i = 0; i < solution.residuals.size(); ++i) {
    if (!o.list[i].known()) continue;
    r.push_back(solution.residuals[i]);
    fitted += leverage[i];
  }
  if (r.size() == solution.residuals.size()) fitted = static_cast<double>(solution.values.size());
  if (!r.empty()) tests.push_back({kVelocity, "scatter", scatter_p_value(r, fitted)});
}

}  // namespace

std::vector<TrendTest> residual_tests(const Observations& o, const std::vector<double>& model,
                                      const FitSolution& solution) {
  std::vector<TrendTest> tests;
  test_scatter(o, solution, tests);
  for (const Column& column : columns_of(o))
    test_column(column, o, model, solution.residuals, tests);
  correct_for_number(tests);
  return tests;
}

bool beyond_assumed(const std::vector<double>& residuals, const Observations& o) {
  std::map<KatRow::Kind, std::pair<double, double>> sums;  // squares and rows
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (o.list[i].known()) continue;
    auto& [squares, rows] = sums[o.list[i].row.kind()];
    squares += residuals[i] * residuals[i];
    rows += 1.0;
  }
  return std::any_of(sums.begin(), sums.end(), [](const auto& s) {
    return s.second.first > kRmsOverAssumed * kRmsOverAssumed * s.second.second;
  });
}

bool residuals_fail(const std::vector<TrendTest>& tests, const std::vector<double>& residuals,
                    const Observations& observations) {
  return least_p_value(tests) < kAlarm || beyond_assumed(residuals, observations);
}

}  // namespace powderlink::analysis
