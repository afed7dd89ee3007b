// SPDX-License-Identifier: GPL-3.0-or-later
/// \file rosin_rammler.h
/// Rosin-Rammler (Weibull) law of sizes, whole or cut off at both ends, and its fit.
///   R(d) = exp(-(max(0, d - o)/x0)^n)
///   Y(d) = (R(min) - R(d))/(R(min) - R(max)),  Y = 0 below min, 1 above max
/// d diameter, x0 size with 63.2 % finer (o = 0, whole), n spread, o origin; all lengths in um.
/// o = 0 is the law of the textbooks; OpenFOAM's RosinRammler has o = min.
///
/// Fit: largest likelihood, sum w_i ln(dY/dd), by Ceres in ln x0 and ln n; w = 1 by number, d^3 by
/// mass. By number no other unbiased fit scatters less: sigma_n/n = 0.780/sqrt(N),
/// sigma_x0/x0 = 1.053/(n sqrt(N)), so 1.7 % in n for 2000 grains. Standard errors are of the
/// sandwich form and hold by mass too. R^2 compares Y with the sample's at every grain:
///   R^2 = 1 - sum (Y - Y_i)^2/sum (Y_i - mean)^2.
/// Whether it fits: where chance explains what is off, or where that does not matter.
///   miss    largest |Y - Y_i| between the grains, up to 1 % of d away from them
///   chance  of a sample of the law to be as far off: chi^2 = N_e sum_k (p_k - 1/K)^2 K over K classes of
///           equal shares of the law, K - 3 degrees of freedom; N_e = (sum w)^2/sum w^2 grains
///   fits    miss <= 3 % or chance >= 1 %
/// Sources: P. Rosin, E. Rammler, J. Inst. Fuel 7 (1933) 29; W. Weibull, J. Appl. Mech. 18 (1951) 293;
/// errors: N. L. Johnson, S. Kotz, Continuous Univariate Distributions 1 (1994), chapter 21; test:
/// K. Pearson, Phil. Mag. 50 (1900) 157, weights: J. N. K. Rao, A. J. Scott, Ann. Stat. 12 (1984) 46.
/// Tests: tests/analysis/sizes/rosin_rammler_test.cpp
#pragma once

#include <limits>
#include <optional>

#include "analysis/sizes/size_distribution.h"

namespace powderlink::analysis {

struct RosinRammler {
  double x0_um = 0.0, n = 0.0;
  double min_um = 0.0, max_um = std::numeric_limits<double>::infinity();
  double origin_um = 0.0;

  double finer(double diameter_um) const;
  double quantile_um(double share) const;
};

struct RosinRammlerFit {
  RosinRammler law;
  double x0_sigma_um = 0.0, n_sigma = 0.0;  ///< standard errors
  double r_squared = 0.0;
  double miss = 0.0, miss_um = 0.0;  ///< how far it is off, and where
  double chance = 0.0;

  bool fits() const;
};

/// Empty when the sample decides no such law: fewer than 10 sizes inside the cut-offs, or parameters
/// that run away (x0 beyond ten times the largest grain, no spread).
/// \param cut  its min, max and origin are kept; grains outside are left out
std::optional<RosinRammlerFit> fit_rosin_rammler(const SizeDistribution& sample,
                                                 const RosinRammler& cut = {});

/// The law of another form, such as OpenFOAM's, that comes nearest to the sample: least squares in Y
/// at 200 quantiles. Not an estimate of parameters, so without standard errors: a law that is not of
/// the sample's form is pulled about by its ends when fitted by likelihood.
std::optional<RosinRammlerFit> nearest_rosin_rammler(const SizeDistribution& sample,
                                                     const RosinRammler& cut);

}  // namespace powderlink::analysis
