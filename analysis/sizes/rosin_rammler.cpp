// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/rosin_rammler.h"

#include <ceres/autodiff_first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <ceres/jet.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "base/statistics/least_squares.h"

namespace powderlink::analysis {

namespace {

constexpr int kFewestSizes = 10;
constexpr double kLeastKnown =
    0.12;  // variance of ln x0 and ln n; more where few grains have the mass
constexpr double kFarthest = 10.0;  // x0 over the largest grain
constexpr double kMiss = 0.03, kChance = 0.01;
constexpr double kBeside = 0.01;                       // of d: diameters that nothing tells apart
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

/// The law's share finer, with its ends computed once.
class Finer {
 public:
  explicit Finer(const RosinRammler& law)
      : law_(law), low_(survivors(law, law.min_um)), high_(survivors(law, law.max_um)) {}
  double operator()(double d) const {
    if (d <= law_.min_um) return 0.0;
    if (d >= law_.max_um) return 1.0;
    return (low_ - survivors(law_, d)) / (low_ - high_);
  }

 private:
  const RosinRammler& law_;
  double low_, high_;
};

double r_squared(const SizeDistribution& sample, const Finer& finer) {
  const std::vector<double> y = sample.finer();
  double off = 0.0, all = 0.0, mean = 0.0;
  for (const double value : y) mean += value / static_cast<double>(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    off += std::pow(finer(sample.diameters_um()[i]) - y[i], 2);
    all += std::pow(y[i] - mean, 2);
  }
  return all > 0.0 ? 1.0 - off / all : 0.0;
}

/// Between the grains the sample's share is known, whether they repeat (pixels) or not.
void find_miss(RosinRammlerFit& fit, const SizeDistribution& sample, const Finer& finer) {
  const std::vector<double>& d = sample.diameters_um();
  const auto all = static_cast<double>(d.size());  // weights of mean 1
  double below = 0.0;
  const auto look = [&](double at) {
    const double off = std::fabs(finer(at) - below / all);
    if (off <= fit.miss) return;
    fit.miss = off;
    fit.miss_um = at;
  };
  for (std::size_t i = 0; i + 1 < d.size(); ++i) {
    below += sample.weights()[i];
    const double middle = 0.5 * (d[i] + d[i + 1]);
    if (!(d[i] < d[i + 1])) continue;
    look(std::min(middle, (1.0 + kBeside) * d[i]));
    if ((1.0 - kBeside) * d[i + 1] > middle) look((1.0 - kBeside) * d[i + 1]);
  }
}

double chance_of(const SizeDistribution& sample, const RosinRammler& law) {
  double squares = 0.0;
  for (const double w : sample.weights()) squares += w * w;
  const auto all = static_cast<double>(sample.weights().size());
  const double grains = all * all / squares;
  constexpr double fewest = 5.0, most = 20.0, per_class = 10.0;
  const auto classes = static_cast<std::size_t>(std::clamp(grains / per_class, fewest, most));
  const double equal = 1.0 / static_cast<double>(classes);
  double chi_squared = 0.0;
  std::size_t i = 0;
  for (std::size_t k = 1; k <= classes; ++k) {
    const double limit = law.quantile_um(static_cast<double>(k) * equal);
    double share = 0.0;
    for (; i < sample.weights().size() && (k == classes || sample.diameters_um()[i] <= limit); ++i)
      share += sample.weights()[i] / all;
    chi_squared += grains * (share - equal) * (share - equal) / equal;
  }
  const boost::math::chi_squared by_chance(static_cast<double>(classes - 3));
  return boost::math::cdf(boost::math::complement(by_chance, chi_squared));
}

void judge(RosinRammlerFit& fit, const SizeDistribution& sample) {
  const Finer finer(fit.law);
  fit.r_squared = r_squared(sample, finer);
  find_miss(fit, sample, finer);
  fit.chance = chance_of(sample, fit.law);
}

/// Different ones, as many as are asked for.
bool has_sizes(const std::vector<double>& sorted, int fewest) {
  int sizes = sorted.empty() ? 0 : 1;
  for (std::size_t i = 1; i < sorted.size() && sizes < fewest; ++i)
    sizes += sorted[i] > sorted[i - 1] ? 1 : 0;
  return sizes >= fewest;
}

}  // namespace

bool RosinRammlerFit::fits() const { return miss <= kMiss || chance >= kChance; }

double RosinRammler::finer(double d) const { return Finer(*this)(d); }

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
  if (!has_sizes(likelihood.log_d, kFewestSizes)) return {};
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
                     fit.law.x0_um < kFarthest * sample.diameters_um().back() &&
                     std::isfinite(c.trace()) && c(0, 0) >= 0.0 && c(0, 0) < kLeastKnown &&
                     c(1, 1) >= 0.0 && c(1, 1) < kLeastKnown;
  if (!known) return {};
  fit.x0_sigma_um = fit.law.x0_um * std::sqrt(c(0, 0));
  fit.n_sigma = fit.law.n * std::sqrt(c(1, 1));
  judge(fit, sample);
  return fit;
}

std::optional<RosinRammlerFit> nearest_rosin_rammler(const SizeDistribution& sample,
                                                     const RosinRammler& cut) {
  const std::vector<double>& all = sample.diameters_um();
  if (!has_sizes(all, kFewestSizes)) return {};
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
  if (!(fit.law.x0_um < kFarthest * all.back())) return {};
  judge(fit, sample);
  return fit;
}

}  // namespace powderlink::analysis
