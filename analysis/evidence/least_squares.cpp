// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/least_squares.h"

#include <ceres/ceres.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace powderlink::analysis {

namespace {

// Predictions that are integrated or tabulated are known to about 3e-4: smaller steps would
// differentiate that error.
constexpr double kStep = 0.01;  // of a coordinate: 1 % of a parameter with a scale
constexpr int kMostIterations = 40;
constexpr double kTolerance = 1e-9;
constexpr double kAtBound = 1e-3;  // of the width
constexpr double kPushes = 3.0;    // of chi^2: less and the data do not mind the bound
constexpr double kKnown = 0.3;  // sigmas of a residual per factor e: less and a direction is open

class Residuals : public ceres::CostFunction {
 public:
  Residuals(const FitProblem& problem, int rows) : problem_(problem) {
    set_num_residuals(rows);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters.size()));
  }

  bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
    const std::size_t k = problem_.parameters.size();
    std::vector<double> at(blocks[0], blocks[0] + k);
    const std::vector<double> r = evaluate(at);
    std::copy(r.begin(), r.end(), residuals);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    for (std::size_t j = 0; j < k; ++j) {
      const FitParameter& p = problem_.parameters[j];
      // Away from the nearer bound.
      const double middle = 0.5 * (p.to_coordinate(p.lower) + p.to_coordinate(p.upper));
      const double size = std::min(kStep, 0.1 * p.width());
      const double step = at[j] < middle ? size : -size;
      std::vector<double> moved = at;
      moved[j] += step;
      const std::vector<double> r_moved = evaluate(moved);
      for (std::size_t i = 0; i < r.size(); ++i)
        jacobians[0][i * k + j] = (r_moved[i] - r[i]) / step;
    }
    return true;
  }

  std::vector<double> evaluate(const std::vector<double>& coordinates) const {
    std::vector<double> values(coordinates.size());
    for (std::size_t j = 0; j < values.size(); ++j) {
      const FitParameter& p = problem_.parameters[j];
      values[j] = std::clamp(p.to_value(coordinates[j]), p.lower, p.upper);
    }
    std::vector<double> r = problem_.residuals(values);
    if (problem_.prior) {
      const std::vector<double> known = problem_.prior(values);
      r.insert(r.end(), known.begin(), known.end());
    }
    return r;
  }

 private:
  const FitProblem& problem_;
};

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0.0;
  for (const double x : r) sum += x * x;
  return sum;
}

Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(const Eigen::MatrixXd& jacobian) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
}

}  // namespace

double FitParameter::to_coordinate(double value) const {
  return logarithmic ? std::log(value) : value;
}
double FitParameter::to_value(double coordinate) const {
  return logarithmic ? std::exp(coordinate) : coordinate;
}

FitSolution least_squares(const FitProblem& problem, const std::vector<double>& start) {
  FitSolution s;
  const std::size_t k = problem.parameters.size();
  if (k == 0) {
    s.residuals = problem.residuals({});
    s.chi2 = sum_of_squares(s.residuals);
    s.jacobian.resize(static_cast<long>(s.residuals.size()), 0);
    return s;
  }
  const int rows = static_cast<int>(problem.residuals(start).size());
  const int all_rows = rows + (problem.prior ? static_cast<int>(problem.prior(start).size()) : 0);
  std::vector<double> at(k);
  ceres::Problem ceres_problem;
  auto* cost = new Residuals(problem, all_rows);  // owned by ceres_problem
  ceres_problem.AddResidualBlock(cost, nullptr, at.data());
  for (std::size_t j = 0; j < k; ++j) {
    const FitParameter& p = problem.parameters[j];
    at[j] = p.to_coordinate(std::clamp(start[j], p.lower, p.upper));
    ceres_problem.SetParameterLowerBound(at.data(), static_cast<int>(j), p.to_coordinate(p.lower));
    ceres_problem.SetParameterUpperBound(at.data(), static_cast<int>(j), p.to_coordinate(p.upper));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = kMostIterations;
  options.function_tolerance = kTolerance;
  options.parameter_tolerance = kTolerance;
  options.num_threads = 1;  // results must not depend on the machine
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres_problem, &summary);

  std::vector<double> all(static_cast<std::size_t>(all_rows));
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(
      all_rows, static_cast<long>(k));
  const double* block = at.data();
  double* jacobian_block = jacobian.data();
  cost->Evaluate(&block, all.data(), &jacobian_block);
  s.residuals.assign(all.begin(), all.begin() + rows);
  s.jacobian = jacobian.topRows(rows);
  s.chi2 = sum_of_squares(s.residuals);
  s.prior = sum_of_squares(all) - s.chi2;
  // What a step that no bound stops would take off chi^2, in directions that the data know.
  const auto svd = decomposition(s.jacobian);
  const Eigen::VectorXd along =
      svd.matrixU().transpose() *
      Eigen::Map<const Eigen::VectorXd>(s.residuals.data(), static_cast<long>(rows));
  double gain = 0.0;
  for (long i = 0; i < along.size(); ++i)
    gain += svd.singularValues()[i] > kKnown ? along[i] * along[i] : 0.0;
  for (std::size_t j = 0; j < k; ++j) {
    const FitParameter& p = problem.parameters[j];
    s.values.push_back(std::clamp(p.to_value(at[j]), p.lower, p.upper));
    const double margin = kAtBound * p.width();
    s.at_bound.push_back(gain > kPushes && (at[j] < p.to_coordinate(p.lower) + margin ||
                                            at[j] > p.to_coordinate(p.upper) - margin));
  }
  return s;
}

FitSolution least_squares(const FitProblem& problem,
                          const std::vector<std::vector<double>>& starts) {
  FitSolution best;
  best.chi2 = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& start : starts) {
    FitSolution s = least_squares(problem, start);
    if (s.chi2 + s.prior < best.chi2 + best.prior) best = std::move(s);
  }
  return best;
}

std::vector<double> leave_one_out(const FitSolution& s) {
  std::vector<double> out = s.residuals;
  const long n = s.jacobian.rows();
  const long k = s.jacobian.cols();
  if (k == 0 || n < 2) return out;
  constexpr double negligible = 1e-6;  // of the largest singular value
  for (long i = 0; i < n; ++i) {
    Eigen::MatrixXd others(n - 1, k);
    Eigen::VectorXd r(n - 1);
    for (long j = 0, to = 0; j < n; ++j) {
      if (j == i) continue;
      others.row(to) = s.jacobian.row(j);
      r[to++] = s.residuals[static_cast<std::size_t>(j)];
    }
    auto svd = decomposition(others);
    svd.setThreshold(negligible);
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

}  // namespace powderlink::analysis
