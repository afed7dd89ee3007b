// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/statistics/least_squares.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

// Predictions that are integrated or tabulated are known to about 3e-4: smaller steps would
// differentiate that error.
constexpr double kStep = 0.01;  // of ln x, of x, or of the width
constexpr int kMostIterations = 40;
constexpr double kTolerance = 1e-9;
constexpr double kAtBound = 1e-4;  // of the width: solver's rest
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
      const double step = problem_.parameters[j].step(at[j]);
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

}  // namespace

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0.0;
  for (const double x : r) sum += x * x;
  return sum;
}

Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(const Eigen::MatrixXd& jacobian) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
}

double FitParameter::to_coordinate(double value) const {
  return logarithmic ? std::log(value) : value / (upper - lower);
}
double FitParameter::to_value(double coordinate) const {
  return logarithmic ? std::exp(coordinate) : coordinate * (upper - lower);
}
double FitParameter::step(double coordinate) const {
  constexpr double of_width = 0.1;  // where bounds are close
  const double middle = 0.5 * (to_coordinate(lower) + to_coordinate(upper));
  const double wanted = logarithmic || !(lower > 0.0) ? kStep : kStep * coordinate;
  const double size = std::min(wanted, of_width * width());
  return coordinate < middle ? size : -size;
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
    s.at_bound.push_back(at[j] < p.to_coordinate(p.lower) + margin ||
                         at[j] > p.to_coordinate(p.upper) - margin);
  }
  s.pushed = gain > kPushes;
  return s;
}

FitSolution least_squares(const FitProblem& problem,
                          const std::vector<std::vector<double>>& starts) {
  if (starts.empty()) {
    throw InvalidInput("least squares", "no point to start from", "one or more",
                       "fit two effects from the fits of each alone");
  }
  FitSolution best;
  best.chi2 = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& start : starts) {
    FitSolution s = least_squares(problem, start);
    if (s.chi2 + s.prior < best.chi2 + best.prior) best = std::move(s);
  }
  return best;
}

}  // namespace powderlink
