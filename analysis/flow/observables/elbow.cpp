// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/observables/elbow.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace powderlink::analysis {

namespace {

using Bends = std::vector<double>;  // in parts of the record, increasing

constexpr std::size_t kFewestPoints = 8;  // rows
constexpr int kGrid = 200;                // places of one bend that are tried first
constexpr int kPairGrid = 40;             // places of each of two
constexpr double kMargin = 0.02;          // of the record: at each end, and between two bends
constexpr int kBits = 30;                 // of a bend's time
constexpr int kRounds = 30;               // of refining two bends in turn
constexpr double kSettled = 1e-9;         // relative change of the squares in a round
constexpr double kRisk = 0.01, kOutside = 0.05;

/// Straight pieces that meet, fitted to the rows; times in parts of the record.
class Pieces {
 public:
  Pieces(const std::vector<double>& times, const std::vector<double>& values)
      : t_(static_cast<Eigen::Index>(times.size())), p_(t_.size()) {
    const double span = times.back() - times.front();
    for (Eigen::Index i = 0; i < t_.size(); ++i) {
      t_[i] = (times[static_cast<std::size_t>(i)] - times.front()) / span;
      p_[i] = values[static_cast<std::size_t>(i)];
    }
  }

  /// a, b and the changes of slope.
  Eigen::VectorXd parts(const Bends& bends) const {
    return design(bends).colPivHouseholderQr().solve(p_);
  }

  Eigen::VectorXd residuals(const Bends& bends) const { return p_ - design(bends) * parts(bends); }

  double squares(const Bends& bends) const { return residuals(bends).squaredNorm(); }

  /// The others stay; within `reach` of where it is, apart from its neighbours and the ends.
  double refine(Bends& bends, std::size_t which, double reach) const {
    const double low = which == 0 ? 0.0 : bends[which - 1];
    const double high = which + 1 == bends.size() ? 1.0 : bends[which + 1];
    const double from = std::max(low + kMargin, bends[which] - reach);
    const double to = std::min(high - kMargin, bends[which] + reach);
    if (!(to > from)) return squares(bends);
    const auto [place, least] = boost::math::tools::brent_find_minima(
        [&](double t) {
          Bends moved = bends;
          moved[which] = t;
          return squares(moved);
        },
        from, to, kBits);
    bends[which] = place;
    return least;
  }

  Bends best_of_one() const {
    const double step = (1.0 - 2.0 * kMargin) / kGrid;
    Bends best{kMargin};
    double least = squares(best);
    for (int i = 1; i <= kGrid; ++i) keep_better({kMargin + step * i}, best, least);
    refine(best, 0, step);
    return best;
  }

  Bends best_of_two() const {
    const double step = (1.0 - 2.0 * kMargin) / kPairGrid;
    Bends best{kMargin, kMargin + step};
    double least = squares(best);
    for (int i = 0; i < kPairGrid; ++i) {
      for (int j = i + 1; j <= kPairGrid; ++j) {
        keep_better({kMargin + step * i, kMargin + step * j}, best, least);
      }
    }
    for (int round = 0; round < kRounds; ++round) {
      refine(best, 0, step);
      const double now = refine(best, 1, step);
      if (least - now <= kSettled * now) break;
      least = now;
    }
    return best;
  }

  /// Independent rows among residuals that follow each other.
  static double independent(const Eigen::VectorXd& r) {
    const Eigen::Index n = r.size();
    const double all = r.squaredNorm();
    double rows_per_one = 1.0;
    for (Eigen::Index lag = 1; lag < n; ++lag) {
      const double correlated = r.head(n - lag).dot(r.tail(n - lag));
      if (!(correlated > 0.0)) break;
      rows_per_one += 2.0 * correlated / all;
    }
    return static_cast<double>(n) / rows_per_one;
  }

 private:
  Eigen::MatrixXd design(const Bends& bends) const {
    Eigen::MatrixXd columns(t_.size(), 2 + static_cast<Eigen::Index>(bends.size()));
    columns.col(0).setOnes();
    columns.col(1) = t_;
    Eigen::Index column = 2;
    for (const double bend : bends) columns.col(column++) = (t_.array() - bend).max(0.0).matrix();
    return columns;
  }

  void keep_better(Bends tried, Bends& best, double& least) const {
    const double left = squares(tried);
    if (!(left < least)) return;
    best = std::move(tried);
    least = left;
  }

  Eigen::VectorXd t_, p_;
};

struct Fit {
  Fit(const Pieces& pieces, Bends at) : bends(std::move(at)) {
    const Eigen::VectorXd residuals = pieces.residuals(bends);
    squares = residuals.squaredNorm();
    rows = Pieces::independent(residuals);
    freedom = rows - 2.0 - 2.0 * static_cast<double>(bends.size());
  }

  bool better_than(const Fit& other) const {
    if (!(freedom > 1.0)) return false;
    const double more = 2.0 * static_cast<double>(bends.size() - other.bends.size());
    const boost::math::fisher_f ratio(more, freedom);
    return other.squares - squares > more * squares / freedom * quantile(complement(ratio, kRisk));
  }

  Bends bends;
  double squares, rows, freedom;
};

/// Outwards from the elbow, the other bend at its best, linear between the last two places.
double bound(const Pieces& pieces, const Fit& fit, std::size_t elbow, int way) {
  const boost::math::fisher_f ratio(1.0, fit.freedom);
  const double limit = fit.squares * (1.0 + quantile(complement(ratio, kOutside)) / fit.freedom);
  const double low = elbow == 0 ? 0.0 : fit.bends[elbow - 1];
  const double high = elbow + 1 == fit.bends.size() ? 1.0 : fit.bends[elbow + 1];
  const double step = (1.0 - 2.0 * kMargin) / kGrid / 8.0;
  Bends bends = fit.bends;
  double inside = bends[elbow], inside_squares = fit.squares;
  for (double t = inside + way * step;; t += way * step) {
    if (t <= low + kMargin) return low + kMargin;
    if (t >= high - kMargin) return high - kMargin;
    bends[elbow] = t;
    double here = pieces.squares(bends);
    if (bends.size() > 1) here = pieces.refine(bends, 1 - elbow, 8.0 * step);
    if (here > limit) {
      return inside + (t - inside) * (limit - inside_squares) / (here - inside_squares);
    }
    inside = t;
    inside_squares = here;
  }
}

}  // namespace

double Elbow::at(double t) const {
  std::size_t i = 1;
  while (i + 1 < pieces.size() && t > pieces[i].first) ++i;
  const auto &a = pieces[i - 1], &b = pieces[i];
  return a.second + (t - a.first) / (b.first - a.first) * (b.second - a.second);
}

std::optional<Elbow> find_elbow(const std::vector<double>& times,
                                const std::vector<double>& values) {
  if (times.size() < kFewestPoints) return {};
  const Pieces pieces(times, values);
  Fit best(pieces, {});
  for (const Fit& more : {Fit(pieces, pieces.best_of_one()), Fit(pieces, pieces.best_of_two())}) {
    if (more.better_than(best)) best = more;
  }
  if (best.bends.empty()) return {};
  const Eigen::VectorXd parts = pieces.parts(best.bends);
  const auto count = static_cast<Eigen::Index>(best.bends.size());
  Eigen::Index falls_most = 0;
  parts.tail(count).minCoeff(&falls_most);
  const auto elbow = static_cast<std::size_t>(falls_most);

  const double span = times.back() - times.front();
  const auto time = [&](double part) { return times.front() + part * span; };
  Elbow found;
  found.time = time(best.bends[elbow]);
  found.interval = {time(bound(pieces, best, elbow, -1)), time(bound(pieces, best, elbow, 1))};
  found.independent_rows = best.rows;
  Bends ends = best.bends;
  ends.insert(ends.begin(), 0.0);
  ends.push_back(1.0);
  double value = parts[0], slope = parts[1];
  found.pieces.emplace_back(time(0.0), value);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    value += slope * (ends[i] - ends[i - 1]);
    found.pieces.emplace_back(time(ends[i]), value);
    if (i == elbow + 1) {
      found.level = value;
      found.slope_before = slope / span;
    }
    if (i < ends.size() - 1) slope += parts[static_cast<Eigen::Index>(i) + 1];
    if (i == elbow + 1) found.slope_after = slope / span;
  }
  return found;
}

}  // namespace powderlink::analysis
