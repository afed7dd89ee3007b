// SPDX-License-Identifier: GPL-3.0-or-later
/// \file trends.h
/// Does a residual depend on something? Every test gives a p-value; small means yes.
///
///   scatter     sum r^2 against chi^2(n - k)                    rows whose noise is known
///   curve       what a parabola in ln x takes off sum r^2: chi^2(2), or F(2, n - 3)
///   rank        Spearman's rho; exact by permutations up to 8 rows, Student's t above
///   runs        Wald-Wolfowitz on the signs in the order of x, exact, few runs count
///
/// Holm's correction keeps the chance of any false alarm among m tests at that of one.
/// Symbols: r residuals in sigmas, n rows, k fitted parameters, x a column.
/// Source: S. Holm, Scand. J. Statist. 6 (1979) 65; C. Spearman 1904; A. Wald, J. Wolfowitz 1940.
/// Tests: tests/analysis/evidence/evidence_trends_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink {

struct TrendTest {
  std::string variable;  ///< column
  std::string test;      ///< "scatter", "curve", "rank", "runs"
  double p_value = 1.0;
  double p_corrected = 1.0;  ///< after Holm, among those that count or those that do not
  bool counts = true;        ///< false: told, but no evidence against the model
};

double scatter_p_value(const std::vector<double>& residuals, double fitted);
double curve_p_value(const std::vector<double>& x, const std::vector<double>& residuals,
                     bool noise_known);
double rank_p_value(const std::vector<double>& x, const std::vector<double>& residuals);
double runs_p_value(const std::vector<double>& x, const std::vector<double>& residuals);

/// More than one value.
bool spread(const std::vector<double>& x);

/// Fills p_corrected: tests that count are one family, those that are only told another.
void correct_for_number(std::vector<TrendTest>& tests);
/// The least p_corrected of those that count; 1 without any.
double least_p_value(const std::vector<TrendTest>& tests);

}  // namespace powderlink
