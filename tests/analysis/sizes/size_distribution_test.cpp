// SPDX-License-Identifier: GPL-3.0-or-later
// Quantiles and their intervals against closed forms.
#include "analysis/sizes/size_distribution.h"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/random/lognormal_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>

#include "base/statistics/bootstrap.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

/// Grains at the middles of N equal shares of a lognormal law: a sample without scatter.
std::vector<double> ideal_lognormal(double median_um, double log_std, int grains) {
  const boost::math::lognormal law(std::log(median_um), log_std);
  std::vector<double> d;
  d.reserve(static_cast<std::size_t>(grains));
  for (int i = 0; i < grains; ++i) d.push_back(boost::math::quantile(law, (i + 0.5) / grains));
  return d;
}

TEST(SizeDistribution, SmallSampleByHand) {
  const SizeDistribution number({3, 1, 2}, Weighting::number);
  EXPECT_DOUBLE_EQ(number.quantile_um(0.5), 2);
  EXPECT_DOUBLE_EQ(number.quantile_um(1.0 / 6), 1);
  EXPECT_DOUBLE_EQ(number.quantile_um(1.0 / 3), 1.5);
  EXPECT_DOUBLE_EQ(number.quantile_um(0.0), 1);
  EXPECT_DOUBLE_EQ(number.quantile_um(1.0), 3);
  EXPECT_DOUBLE_EQ(number.finer(1.5), 1.0 / 3);
  // Masses 1, 8, 27: Y = 0.5/36, 5/36, 22.5/36.
  const SizeDistribution mass({3, 1, 2}, Weighting::mass);
  EXPECT_NEAR(mass.quantile_um(5.0 / 36), 2, 1e-12);
  EXPECT_NEAR(mass.quantile_um(0.5), 2 + (18.0 - 5.0) / (22.5 - 5.0), 1e-12);
  EXPECT_NEAR(mass.finer(2.0), 5.0 / 36, 1e-12);
}

TEST(SizeDistribution, MassMedianOfLognormalIsHatchAndChoates) {
  // Hatch-Choate: the law by mass is lognormal too, its median exp(3 s^2) times the one by number.
  // The tails beyond N grains hold the rest: 5e-3 at s = 0.3 and 20 000 grains.
  constexpr double kTails = 5e-3;
  const double s = 0.3;
  const auto grains = ideal_lognormal(50, s, 20000);
  for (const double share : {0.1, 0.5, 0.9}) {
    const double number = boost::math::quantile(boost::math::lognormal(std::log(50.0), s), share);
    EXPECT_NEAR(SizeDistribution(grains, Weighting::number).quantile_um(share), number, 1e-3);
    const double mass = number * std::exp(3 * s * s);
    EXPECT_NEAR(SizeDistribution(grains, Weighting::mass).quantile_um(share) / mass, 1, kTails);
  }
}

TEST(SizeDistribution, CountsActLikeRepeatedGrains) {
  const std::vector<double> three = {10, 20, 40};
  const std::vector<unsigned> counts = {2, 0, 3};
  for (const auto weighting : {Weighting::number, Weighting::mass}) {
    const SizeDistribution sample(three, weighting);
    const SizeDistribution repeated({10, 10, 40, 40, 40}, weighting);
    for (const double share : {0.05, 0.3, 0.38, 0.4, 0.5, 0.77, 0.95}) {
      EXPECT_NEAR(sample.quantiles_um({share}, counts)[0], repeated.quantile_um(share), 1e-12)
          << share;
    }
  }
}

TEST(SizeDistribution, RefusesWhatHasNoSize) {
  expect_refusal([] { SizeDistribution({}, Weighting::number); }, {"no grains"});
  expect_refusal([] { SizeDistribution({1.0, 0.0}, Weighting::mass); }, {"given: 0 um"});
}

TEST(Bootstrap, IntervalOfTheMedianHasTheWidthOfTheory) {
  // Asymptotic standard deviation of a median: 1/(2 f sqrt(N)); lognormal: m s sqrt(pi/2)/sqrt(N).
  constexpr int n = 4000;
  const double s = 0.25;
  const SizeDistribution sample(ideal_lognormal(60, s, n), Weighting::number);
  const auto interval = bootstrap_intervals({n}, Bootstrap{}, [&](const auto& counts) {
    return sample.quantiles_um({0.5}, counts[0]);
  })[0];
  const double sigma = 60 * s * std::sqrt(std::acos(-1.0) / 2 / n);
  constexpr double kReplicates = 0.12;  // 3 sigma of a 95 % width from 1000 replicates
  EXPECT_NEAR((interval.high - interval.low) / (2 * 1.96 * sigma), 1, kReplicates);
  EXPECT_NEAR(0.5 * (interval.high + interval.low), 60, sigma);
}

TEST(Bootstrap, IntervalsHoldTheTruthAsOftenAsTheySay) {
  constexpr int n = 200, trials = 300;
  boost::random::mt19937_64 generator(7);
  boost::random::lognormal_distribution<double> law(std::log(60.0), 0.3);
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> d(n);
    for (double& x : d) x = law(generator);
    const SizeDistribution sample(d, Weighting::number);
    Bootstrap options;
    options.replicates = 300;
    options.seed = static_cast<std::uint64_t>(trial);
    const auto interval = bootstrap_intervals(
        {n}, options, [&](const auto& counts) { return sample.quantiles_um({0.5}, counts[0]); })[0];
    held += interval.low <= 60 && 60 <= interval.high ? 1 : 0;
  }
  // 95 % of 300 with 3 binomial deviations; percentile intervals of 200 grains lose a little.
  EXPECT_NEAR(held / static_cast<double>(trials), 0.95, 0.04);
}

TEST(Bootstrap, TheSameSeedGivesTheSameAndGroupsAreDrawnApart) {
  const auto run = [](std::uint64_t seed) {
    Bootstrap options;
    options.replicates = 50;
    options.seed = seed;
    return bootstrap_intervals({30, 50}, options, [](const auto& counts) {
      unsigned first = 0, second = 0;
      for (const unsigned c : counts[0]) first += c;
      for (const unsigned c : counts[1]) second += c;
      EXPECT_EQ(first, 30U);
      EXPECT_EQ(second, 50U);
      return std::vector<double>{static_cast<double>(counts[0][0]) + counts[1][49], NAN};
    });
  };
  EXPECT_EQ(run(1)[0].high, run(1)[0].high);
  EXPECT_TRUE(std::isnan(run(1)[1].low));
  Bootstrap none;
  none.replicates = 0;
  expect_refusal(
      [&] { bootstrap_intervals({3}, none, [](const auto&) { return std::vector<double>{}; }); },
      {"replicates", "given: 0"});
}

}  // namespace
}  // namespace powderlink::analysis
