// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/patterns.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace powderlink::analysis {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Weighted least squares of y on the columns; coefficients and chi^2.
struct Fit {
  Eigen::VectorXd coefficients;
  std::vector<double> residuals;
  double chi2 = std::numeric_limits<double>::infinity();
};

Fit fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y, const Eigen::VectorXd& sigma) {
  const Eigen::MatrixXd a = sigma.cwiseInverse().asDiagonal() * columns;
  const Eigen::VectorXd b = sigma.cwiseInverse().cwiseProduct(y);
  Fit f;
  f.coefficients = a.colPivHouseholderQr().solve(b);
  const Eigen::VectorXd left = b - a * f.coefficients;
  f.residuals.assign(left.begin(), left.end());
  f.chi2 = left.squaredNorm();
  return f;
}

double percent(double log_change) { return 100.0 * std::expm1(log_change); }

}  // namespace

std::vector<Pattern> foreign_patterns(const std::vector<double>& x,
                                      const std::vector<double>& residuals,
                                      const std::vector<double>& sigma) {
  const long n = static_cast<long>(x.size());
  constexpr long fewest = 5;
  if (n < fewest) return {};
  Eigen::VectorXd y(n);
  Eigen::VectorXd s(n);
  for (long i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    s[i] = sigma[at];
    y[i] = -std::log1p(residuals[at] * sigma[at]);
  }
  std::vector<double> distinct = x;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  Pattern step{"step", "", std::numeric_limits<double>::infinity(), 3};
  for (std::size_t cut = 1; cut < distinct.size(); ++cut) {
    Eigen::MatrixXd columns(n, 2);
    for (long i = 0; i < n; ++i)
      columns.row(i) << 1.0, (x[static_cast<std::size_t>(i)] >= distinct[cut] ? 1.0 : 0.0);
    const Fit f = fit(columns, y, s);
    if (f.chi2 >= step.chi2) continue;
    step.chi2 = f.chi2;
    step.residuals = f.residuals;
    step.text = fmt::format("a step of {:+.0f} % between {:g} and {:g} m/s",
                            percent(f.coefficients[1]), distinct[cut - 1], distinct[cut]);
  }

  Pattern wave{"wave", "", std::numeric_limits<double>::infinity(), 4};
  constexpr double finest = 0.125;  // periods over the range
  constexpr double largest = 1.0;   // amplitude of ln d
  for (const bool logarithmic : {false, true}) {
    const auto coordinate = [&](double v) { return logarithmic ? std::log(v) : v; };
    const double range = coordinate(distinct.back()) - coordinate(distinct.front());
    for (double periods = 1.0; periods <= 0.5 * static_cast<double>(distinct.size() - 1);
         periods += finest) {
      Eigen::MatrixXd columns(n, 3);
      for (long i = 0; i < n; ++i) {
        const double phase =
            2.0 * kPi * periods *
            (coordinate(x[static_cast<std::size_t>(i)]) - coordinate(distinct.front())) / range;
        columns.row(i) << 1.0, std::sin(phase), std::cos(phase);
      }
      const Fit f = fit(columns, y, s);
      const double amplitude = std::hypot(f.coefficients[1], f.coefficients[2]);
      // Near two rows per period sine and cosine are nearly the same: any amplitude passes.
      if (f.chi2 >= wave.chi2 || amplitude > largest) continue;
      wave.chi2 = f.chi2;
      wave.residuals = f.residuals;
      wave.text = logarithmic ? fmt::format("a wave of {:.0f} %, once every factor {:.2g} of v",
                                            percent(amplitude), std::exp(range / periods))
                              : fmt::format("a wave of {:.0f} %, once every {:.2g} m/s",
                                            percent(amplitude), range / periods);
    }
  }
  return {step, wave};
}

}  // namespace powderlink::analysis
