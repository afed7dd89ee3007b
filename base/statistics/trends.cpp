// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/statistics/trends.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace powderlink {

namespace {

using boost::math::cdf;
using boost::math::complement;

constexpr std::size_t kPermutedRows = 8;

/// Ranks from 1, ties share their mean.
std::vector<double> ranks(const std::vector<double>& x) {
  std::vector<double> r(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double below = 0.0;
    double equal = 0.0;
    for (const double other : x) {
      if (other < x[i]) below += 1.0;
      if (other == x[i]) equal += 1.0;
    }
    r[i] = below + 0.5 * (equal + 1.0);
  }
  return r;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

/// ln of a over b, -infinity where there is no such choice; the binomial itself overflows beyond some
/// 1000 rows. std::lgamma writes a global, so not with threads.
double log_choose(unsigned a, unsigned b) {
  if (b > a) return -std::numeric_limits<double>::infinity();
  const auto log_factorial = [](unsigned n) { return boost::math::lgamma(n + 1.0); };
  return log_factorial(a) - log_factorial(b) - log_factorial(a - b);
}

}  // namespace

bool spread(const std::vector<double>& x) {
  return std::adjacent_find(x.begin(), x.end(), std::not_equal_to<>()) != x.end();
}

double scatter_p_value(const std::vector<double>& residuals, double fitted) {
  const double degrees = static_cast<double>(residuals.size()) - fitted;
  if (degrees < 1.0) return 1.0;
  double sum = 0.0;
  for (const double r : residuals) sum += r * r;
  return cdf(complement(boost::math::chi_squared(degrees), sum));
}

double curve_p_value(const std::vector<double>& x, const std::vector<double>& residuals,
                     bool noise_known) {
  const long n = static_cast<long>(x.size());
  constexpr long columns = 3;
  if (n <= columns || !spread(x)) return 1.0;
  Eigen::MatrixXd design(n, columns);
  Eigen::VectorXd r(n);
  double mean = 0.0;
  for (const double value : x) mean += std::log(value) / static_cast<double>(n);
  for (long i = 0; i < n; ++i) {
    const double u = std::log(x[static_cast<std::size_t>(i)]) - mean;
    design.row(i) << 1.0, u, u * u;
    r[i] = residuals[static_cast<std::size_t>(i)];
  }
  const auto left = [&](long terms) {
    const Eigen::MatrixXd part = design.leftCols(terms);
    return (r - part * part.colPivHouseholderQr().solve(r)).squaredNorm();
  };
  const double constant = left(1);
  const double parabola = left(columns);
  if (noise_known)
    return cdf(complement(boost::math::chi_squared(2), std::max(0.0, constant - parabola)));
  constexpr double rounding = 1e-20;
  const double degrees = static_cast<double>(n - columns);
  const double f = 0.5 * (constant - parabola) / (parabola / degrees + rounding);
  return cdf(complement(boost::math::fisher_f(2, degrees), std::max(0.0, f)));
}

double rank_p_value(const std::vector<double>& x, const std::vector<double>& residuals) {
  const std::size_t n = x.size();
  if (n < 4 || !spread(x) || !spread(residuals)) return 1.0;
  const std::vector<double> rank_x = ranks(x);
  std::vector<double> rank_r = ranks(residuals);
  const double rho = std::fabs(correlation(rank_x, rank_r));
  if (n <= kPermutedRows) {
    constexpr double rounding = 1e-9;
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> shuffled(n);
    double as_large = 0.0;
    double all = 0.0;
    do {
      for (std::size_t i = 0; i < n; ++i) shuffled[i] = rank_r[order[i]];
      if (std::fabs(correlation(rank_x, shuffled)) >= rho - rounding) as_large += 1.0;
      all += 1.0;
    } while (std::next_permutation(order.begin(), order.end()));
    return as_large / all;
  }
  if (rho >= 1.0) return 0.0;
  const double degrees = static_cast<double>(n) - 2.0;
  const double t = rho * std::sqrt(degrees / (1.0 - rho * rho));
  return 2.0 * cdf(complement(boost::math::students_t(degrees), t));
}

double runs_p_value(const std::vector<double>& x, const std::vector<double>& residuals) {
  const std::size_t n = x.size();
  if (!spread(x)) return 1.0;
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  unsigned plus = 0;
  unsigned minus = 0;
  unsigned runs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool up = residuals[order[i]] > 0.0;
    ++(up ? plus : minus);
    if (i == 0 || up != (residuals[order[i - 1]] > 0.0)) ++runs;
  }
  if (plus == 0 || minus == 0) return 1.0;
  const double all = log_choose(plus + minus, plus);
  const auto part = [&](unsigned of_plus, unsigned of_minus) {
    return std::exp(log_choose(plus - 1, of_plus) + log_choose(minus - 1, of_minus) - all);
  };
  double probability = 0.0;
  for (unsigned count = 2; count <= runs; ++count) {
    const unsigned half = count / 2;
    probability += count % 2 == 0 ? 2.0 * part(half - 1, half - 1)
                                  : part(half, half - 1) + part(half - 1, half);
  }
  return std::min(1.0, probability);
}

void correct_for_number(std::vector<TrendTest>& tests) {
  for (const bool counts : {true, false}) {
    std::vector<TrendTest*> family;
    for (TrendTest& t : tests) {
      if (t.counts == counts) family.push_back(&t);
    }
    std::stable_sort(family.begin(), family.end(), [](const TrendTest* a, const TrendTest* b) {
      return a->p_value < b->p_value;
    });
    double largest = 0.0;
    for (std::size_t i = 0; i < family.size(); ++i) {
      largest = std::max(largest, static_cast<double>(family.size() - i) * family[i]->p_value);
      family[i]->p_corrected = std::min(1.0, largest);
    }
  }
}

double least_p_value(const std::vector<TrendTest>& tests) {
  double least = 1.0;
  for (const TrendTest& t : tests) {
    if (t.counts) least = std::min(least, t.p_corrected);
  }
  return least;
}

}  // namespace powderlink
