// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/residual_checks.h"

#include <algorithm>
#include <string>

#include "analysis/evidence/least_squares.h"

namespace powderlink::analysis {

std::vector<TrendTest> residual_tests(const Study& study, const Observations& o,
                                      const std::vector<double>& residuals, int fitted) {
  std::vector<double> velocity;
  std::vector<double> contact_time;
  for (const KatRow& row : study.rows) {
    velocity.push_back(row.impact_velocity_m_s);
    if (row.contact_time_us) contact_time.push_back(*row.contact_time_us);
  }
  std::vector<TrendTest> tests;
  const std::string v = "impact_velocity_m_s";
  if (o.noise.known()) {
    tests.push_back({v, "scatter", scatter_p_value(residuals, fitted)});
  }
  tests.push_back({v, "curve", curve_p_value(velocity, residuals, o.noise.known())});
  tests.push_back({v, "rank", rank_p_value(velocity, residuals)});
  tests.push_back({v, "runs", runs_p_value(velocity, residuals)});
  if (study.rows.front().diameter_um) {
    std::vector<double> diameter;
    for (const KatRow& row : study.rows) diameter.push_back(row.diameter_um.value_or(0.0));
    if (*std::min_element(diameter.begin(), diameter.end()) > 0.0)
      tests.push_back({"diameter_um", "curve", curve_p_value(diameter, residuals, true)});
  }
  if (contact_time.size() == velocity.size())
    tests.push_back({"contact_time_us", "rank", rank_p_value(contact_time, residuals)});
  for (const auto& [name, first] : study.rows.front().other) {
    std::vector<double> column;
    for (const KatRow& row : study.rows) column.push_back(row.other.at(name));
    // May have been computed from the diameter itself: told, but no evidence.
    tests.push_back({name, "rank", rank_p_value(column, residuals), 1.0, false});
  }
  correct_for_number(tests);
  return tests;
}

bool residuals_fail(const std::vector<TrendTest>& tests, const std::vector<double>& residuals,
                    const Noise& noise) {
  const double mean_square = sum_of_squares(residuals) / static_cast<double>(residuals.size());
  return least_p_value(tests) < kAlarm ||
         (!noise.known() && mean_square > kRmsOverAssumed * kRmsOverAssumed);
}

}  // namespace powderlink::analysis
