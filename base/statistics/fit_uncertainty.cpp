// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/statistics/fit_uncertainty.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace powderlink {

namespace {

constexpr double kNegligible = 1e-6;  // of the largest singular value

}  // namespace

std::vector<double> hat_diagonal(const FitSolution& s) {
  std::vector<double> h(s.residuals.size(), 0.0);
  if (s.jacobian.cols() == 0) return h;
  const auto svd = decomposition(s.jacobian);
  for (long j = 0; j < svd.singularValues().size(); ++j) {
    if (svd.singularValues()[j] <= kNegligible * svd.singularValues()[0]) continue;
    for (std::size_t i = 0; i < h.size(); ++i)
      h[i] += svd.matrixU()(static_cast<long>(i), j) * svd.matrixU()(static_cast<long>(i), j);
  }
  return h;
}

std::vector<double> leave_one_out(const FitSolution& s) {
  std::vector<double> out = s.residuals;
  const long n = s.jacobian.rows();
  const long k = s.jacobian.cols();
  if (k == 0 || n < 2) return out;
  for (long i = 0; i < n; ++i) {
    Eigen::MatrixXd others(n - 1, k);
    Eigen::VectorXd r(n - 1);
    for (long j = 0, to = 0; j < n; ++j) {
      if (j == i) continue;
      others.row(to) = s.jacobian.row(j);
      r[to++] = s.residuals[static_cast<std::size_t>(j)];
    }
    auto svd = decomposition(others);
    svd.setThreshold(kNegligible);
    out[static_cast<std::size_t>(i)] -= s.jacobian.row(i).dot(svd.solve(r));
  }
  return out;
}

ProfileInterval profile_interval(const FitProblem& problem, const FitSolution& solution,
                                 std::size_t parameter, double rise) {
  const FitParameter& p = problem.parameters[parameter];
  FitProblem others;
  std::vector<double> start;
  for (std::size_t j = 0; j < problem.parameters.size(); ++j) {
    if (j == parameter) continue;
    others.parameters.push_back(problem.parameters[j]);
    start.push_back(solution.values[j]);
  }
  double held = 0.0;
  others.residuals = [&](const std::vector<double>& values) {
    std::vector<double> all = values;
    all.insert(all.begin() + static_cast<long>(parameter), held);
    return problem.residuals(all);
  };
  const auto excess = [&](double coordinate) {
    held = std::clamp(p.to_value(coordinate), p.lower, p.upper);
    const FitSolution s = least_squares(others, start);
    if (!s.values.empty()) start = s.values;
    return s.chi2 - solution.chi2 - rise;
  };
  const double best = p.to_coordinate(solution.values[parameter]);
  const auto end = [&](double bound, bool& open) {
    constexpr double first = 0.02;
    constexpr int halvings = 8;
    const std::vector<double> at_best = start;
    const double direction = bound > best ? 1.0 : -1.0;
    double inside = best;
    double outside = best;
    double stride = first;
    open = false;
    while (true) {
      outside = inside + direction * stride;
      const bool beyond = direction * (outside - bound) >= 0.0;
      if (beyond) outside = bound;
      if (excess(outside) > 0.0) break;
      inside = outside;
      if (beyond) {
        open = true;
        start = at_best;
        return bound;
      }
      stride *= 2.0;
    }
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (excess(middle) > 0.0 ? outside : inside) = middle;
    }
    start = at_best;
    return 0.5 * (inside + outside);
  };
  ProfileInterval interval;
  interval.low = p.to_value(end(p.to_coordinate(p.lower), interval.open_low));
  interval.high = p.to_value(end(p.to_coordinate(p.upper), interval.open_high));
  return interval;
}

Uncertainty uncertainty(const FitProblem& problem, const FitSolution& solution) {
  Uncertainty u;
  const long k = solution.jacobian.cols();
  if (k == 0) return u;
  // A direction is open when one sigma along it is more than this part of the allowed widths.
  constexpr double open = 0.25;
  constexpr double part_of_direction = 0.25;
  Eigen::VectorXd width(k);
  for (long j = 0; j < k; ++j) width[j] = problem.parameters[static_cast<std::size_t>(j)].width();
  const auto svd = decomposition(solution.jacobian * width.asDiagonal());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(k, k);
  for (long i = 0; i < k; ++i) {
    const double value = i < svd.singularValues().size() ? svd.singularValues()[i] : 0.0;
    const double sigma = value > 1.0 / open ? 1.0 / value : 1.0;
    const Eigen::VectorXd direction = svd.matrixV().col(i);
    covariance += sigma * sigma * direction * direction.transpose();
    if (value > 1.0 / open) continue;
    std::string text;
    for (long j = 0; j < k; ++j) {
      if (std::fabs(direction[j]) > part_of_direction)
        text +=
            (text.empty() ? "" : " and ") + problem.parameters[static_cast<std::size_t>(j)].name;
    }
    u.flat.push_back(text);
  }
  covariance = width.asDiagonal() * covariance * width.asDiagonal();
  u.correlation.resize(k, k);
  for (long i = 0; i < k; ++i) {
    u.sigma.push_back(std::sqrt(covariance(i, i)));
    for (long j = 0; j < k; ++j)
      u.correlation(i, j) = covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
  }
  return u;
}

}  // namespace powderlink
