// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/elbow.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace powderlink::analysis {

namespace {

constexpr std::size_t kFewest = 8;   // rows
constexpr int kGrid = 200;           // places of the bend that are tried first
constexpr double kMargin = 0.02;     // of the record, at each end, where a bend means nothing
constexpr double kParameters = 4.0;  // a, b, c, t_e
constexpr int kBits = 30;            // of the bend's time
constexpr double kRisk = 0.01, kOutside = 0.05;

/// Lines that meet at a time, fitted to the rows; times in parts of the record.
class TwoLines {
 public:
  TwoLines(const std::vector<double>& times, const std::vector<double>& values)
      : t_(static_cast<Eigen::Index>(times.size())), p_(t_.size()) {
    const double span = times.back() - times.front();
    for (Eigen::Index i = 0; i < t_.size(); ++i) {
      t_[i] = (times[static_cast<std::size_t>(i)] - times.front()) / span;
      p_[i] = values[static_cast<std::size_t>(i)];
    }
  }

  /// Residuals of the best lines; a, b and c to `parts`. A bend beyond the record leaves one line.
  Eigen::VectorXd residuals(double bend, Eigen::Vector3d& parts) const {
    const bool bent = bend < 1.0;
    Eigen::MatrixXd design(t_.size(), bent ? 3 : 2);
    design.col(0).setOnes();
    design.col(1) = t_;
    if (bent) design.col(2) = (t_.array() - bend).max(0.0).matrix();
    const Eigen::VectorXd best = design.colPivHouseholderQr().solve(p_);
    parts.setZero();
    parts.head(best.size()) = best;
    return p_ - design * best;
  }

  double squares(double bend) const {
    Eigen::Vector3d parts;
    return residuals(bend, parts).squaredNorm();
  }

  /// Independent rows among residuals that follow each other.
  static double independent(const Eigen::VectorXd& r) {
    const Eigen::Index n = r.size();
    const double all = r.squaredNorm();
    const double q =
        all > 0.0 ? std::clamp(r.head(n - 1).dot(r.tail(n - 1)) / all, 0.0, 1.0 - 1.0 / n) : 0.0;
    return static_cast<double>(n) * (1.0 - q) / (1.0 + q);
  }

 private:
  Eigen::VectorXd t_, p_;
};

}  // namespace

std::optional<Elbow> find_elbow(const std::vector<double>& times,
                                const std::vector<double>& values) {
  if (times.size() < kFewest) return {};
  const TwoLines lines(times, values);
  const double step = (1.0 - 2.0 * kMargin) / kGrid;
  std::vector<double> squares;
  for (int i = 0; i <= kGrid; ++i) squares.push_back(lines.squares(kMargin + step * i));
  const auto least = std::min_element(squares.begin(), squares.end()) - squares.begin();
  const double place = kMargin + step * static_cast<double>(least);
  const auto [bend, left] = boost::math::tools::brent_find_minima(
      [&](double t) { return lines.squares(t); }, std::max(kMargin, place - step),
      std::min(1.0 - kMargin, place + step), kBits);
  Eigen::Vector3d parts;
  const Eigen::VectorXd residuals = lines.residuals(bend, parts);
  const double rows = TwoLines::independent(residuals);
  const double freedom = rows - kParameters;
  if (!(freedom > 1.0)) return {};
  const double one_line = lines.squares(1.0);
  const boost::math::fisher_f better(2.0, freedom), bounds(1.0, freedom);
  if (!(one_line - left > 2.0 * left / freedom * quantile(complement(better, kRisk)))) return {};
  const double limit = left * (1.0 + quantile(complement(bounds, kOutside)) / freedom);
  // Outwards on the grid from the minimum, then linear between the last two places.
  const auto bound = [&](int way) {
    double inside = bend, inside_squares = left;
    for (double t = bend + way * step / 8.0;; t += way * step / 8.0) {
      if (t <= kMargin || t >= 1.0 - kMargin) return way < 0 ? kMargin : 1.0 - kMargin;
      const double here = lines.squares(t);
      if (here > limit) {
        return inside + (t - inside) * (limit - inside_squares) / (here - inside_squares);
      }
      inside = t;
      inside_squares = here;
    }
  };
  const double span = times.back() - times.front();
  const auto time = [&](double part) { return times.front() + part * span; };
  return Elbow{time(bend),      {time(bound(-1)), time(bound(1))}, parts[0] + parts[1] * bend,
               parts[1] / span, (parts[1] + parts[2]) / span,      rows};
}

}  // namespace powderlink::analysis
