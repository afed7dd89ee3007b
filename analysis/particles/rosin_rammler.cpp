// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/particles/rosin_rammler.h"

#include <ceres/autodiff_first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <ceres/jet.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "analysis/evidence/least_squares.h"

namespace powderlink::analysis {

namespace {

constexpr std::size_t kFewest = 10;
constexpr double kLeast_n = 0.05, kLargest_n = 100.0;  // beyond: no law of this family

double survivors(const RosinRammler& law, double d) {
  return std::isinf(d) ? 0.0
                       : std::exp(-std::pow(std::max(0.0, d - law.origin_um) / law.x0_um, law.n));
}

/// Minus the mean log-likelihood over (ln x0, ln n); lengths in units of `scale`.
struct Likelihood {
  std::vector<double> log_d, weight;  ///< of mean 1
  std::optional<double> log_min, log_max;

  template <class T>
  T hazard(double log_d_i, const T* p) const {  // (d/x0)^n
    using std::exp;
    return exp(exp(p[1]) * (log_d_i - p[0]));
  }
  /// ln of the share between the cut-offs, as if there were none.
  template <class T>
  T log_inside(const T* p) const {
    using std::exp, std::log;
    const T low = log_min ? hazard(*log_min, p) : T(0.0);
    return -low + (log_max ? log(1.0 - exp(low - hazard(*log_max, p))) : T(0.0));
  }
  template <class T>
  T one(std::size_t i, const T& log_inside, const T* p) const {
    using std::exp;
    const T u = exp(p[1]) * (log_d[i] - p[0]);
    return -(p[1] + u - exp(u) - log_inside);
  }
  template <class T>
  bool operator()(const T* p, T* cost) const {
    const T inside = log_inside(p);
    *cost = T(0.0);
    for (std::size_t i = 0; i < log_d.size(); ++i) *cost += weight[i] * one(i, inside, p);
    *cost /= static_cast<double>(log_d.size());
    using std::isfinite;
    return isfinite(*cost);
  }
};

using Pair = ceres::Jet<double, 2>;

Eigen::Vector2d gradient(const Likelihood& likelihood, const Eigen::Vector2d& at) {
  const Pair p[2] = {Pair(at[0], 0), Pair(at[1], 1)};
  Pair cost;
  likelihood(p, &cost);
  return cost.v;
}

/// Covariance of (ln x0, ln n): H^-1 S H^-1/N with H the mean curvature, S the mean squared slope.
Eigen::Matrix2d covariance(const Likelihood& likelihood, const Eigen::Vector2d& at) {
  constexpr double step = 1e-4;
  Eigen::Matrix2d curvature;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d moved = step * Eigen::Vector2d::Unit(k);
    curvature.col(k) =
        (gradient(likelihood, at + moved) - gradient(likelihood, at - moved)) / (2.0 * step);
  }
  const Pair p[2] = {Pair(at[0], 0), Pair(at[1], 1)};
  const Pair inside = likelihood.log_inside(p);
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const auto n = static_cast<double>(likelihood.log_d.size());
  for (std::size_t i = 0; i < likelihood.log_d.size(); ++i) {
    const Eigen::Vector2d slope = likelihood.weight[i] * likelihood.one(i, inside, p).v;
    squares += slope * slope.transpose() / n;
  }
  const Eigen::Matrix2d inverse = curvature.inverse();
  return inverse * squares * inverse.transpose() / n;
}

double r_squared(const SizeDistribution& sample, const RosinRammler& law) {
  const std::vector<double> y = sample.finer();
  double off = 0.0, all = 0.0, mean = 0.0;
  for (const double value : y) mean += value / static_cast<double>(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    off += std::pow(law.finer(sample.diameters_um()[i]) - y[i], 2);
    all += std::pow(y[i] - mean, 2);
  }
  return all > 0.0 ? 1.0 - off / all : 0.0;
}

}  // namespace

double RosinRammler::finer(double d) const {
  if (d <= min_um) return 0.0;
  if (d >= max_um) return 1.0;
  const double low = survivors(*this, min_um);
  return (low - survivors(*this, d)) / (low - survivors(*this, max_um));
}

double RosinRammler::quantile_um(double share) const {
  const double low = survivors(*this, min_um);
  const double left = low - share * (low - survivors(*this, max_um));
  return std::clamp(origin_um + x0_um * std::pow(-std::log(left), 1.0 / n), min_um, max_um);
}

std::optional<RosinRammlerFit> fit_rosin_rammler(const SizeDistribution& sample,
                                                 const RosinRammler& cut) {
  Likelihood likelihood;
  const double scale = sample.quantile_um(0.63);
  double total = 0.0;
  for (std::size_t i = 0; i < sample.weights().size(); ++i) {
    const double d = sample.diameters_um()[i];
    // A grain right at the origin has no logarithm; with o = min that is the one that gave min.
    if (d < cut.min_um || d > cut.max_um || d <= cut.origin_um) continue;
    likelihood.log_d.push_back(std::log((d - cut.origin_um) / scale));
    likelihood.weight.push_back(sample.weights()[i]);
    total += sample.weights()[i];
  }
  const std::size_t grains = likelihood.log_d.size();
  if (grains < kFewest || !(likelihood.log_d.back() > likelihood.log_d.front())) return {};
  for (double& w : likelihood.weight) w *= static_cast<double>(grains) / total;
  if (cut.min_um > cut.origin_um)
    likelihood.log_min = std::log((cut.min_um - cut.origin_um) / scale);
  if (!std::isinf(cut.max_um)) likelihood.log_max = std::log((cut.max_um - cut.origin_um) / scale);

  // The quartiles of a whole law give n; a start is all that is needed.
  const double spread = std::log(sample.quantile_um(0.75) / sample.quantile_um(0.25));
  double p[2] = {0.0, std::log(std::clamp(1.572 / std::max(spread, 1e-3), 0.2, 50.0))};
  const ceres::GradientProblem problem(
      new ceres::AutoDiffFirstOrderFunction<Likelihood, 2>(new Likelihood(likelihood)));
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 1e-9;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, p, &summary);

  RosinRammlerFit fit;
  fit.law = cut;
  fit.law.x0_um = scale * std::exp(p[0]);
  fit.law.n = std::exp(p[1]);
  const Eigen::Matrix2d c = covariance(likelihood, {p[0], p[1]});
  const bool known = summary.IsSolutionUsable() && fit.law.n > kLeast_n && fit.law.n < kLargest_n &&
                     std::isfinite(c.trace()) && c(0, 0) >= 0.0 && c(0, 0) < 1.0 &&
                     c(1, 1) >= 0.0 && c(1, 1) < 1.0;
  if (!known) return {};
  fit.x0_sigma_um = fit.law.x0_um * std::sqrt(c(0, 0));
  fit.n_sigma = fit.law.n * std::sqrt(c(1, 1));
  fit.r_squared = r_squared(sample, fit.law);
  return fit;
}

std::optional<RosinRammlerFit> nearest_rosin_rammler(const SizeDistribution& sample,
                                                     const RosinRammler& cut) {
  const std::vector<double>& all = sample.diameters_um();
  if (all.size() < kFewest || !(all.back() > all.front())) return {};
  constexpr int points = 200;
  std::vector<double> shares;
  for (int i = 0; i < points; ++i) shares.push_back((i + 0.5) / points);
  const std::vector<double> d = sample.quantiles_um(shares);
  const double size = std::max(sample.quantile_um(0.63) - cut.origin_um, 1e-3 * all.back());
  FitProblem problem;
  problem.parameters = {{"x0_um", 1e-2 * size, 1e2 * size, size}, {"n", kLeast_n, kLargest_n, 2.0}};
  problem.residuals = [&](const std::vector<double>& values) {
    RosinRammler law = cut;
    law.x0_um = values[0];
    law.n = values[1];
    std::vector<double> off;
    for (int i = 0; i < points; ++i)
      off.push_back(law.finer(d[static_cast<std::size_t>(i)]) -
                    shares[static_cast<std::size_t>(i)]);
    return off;
  };
  const FitSolution s = least_squares(problem, {{size, 1.0}, {size, 2.0}, {size, 4.0}});
  RosinRammlerFit fit;
  fit.law = cut;
  fit.law.x0_um = s.values[0];
  fit.law.n = s.values[1];
  fit.r_squared = r_squared(sample, fit.law);
  return fit;
}

}  // namespace powderlink::analysis
