// SPDX-License-Identifier: GPL-3.0-or-later
// Fits against the parameters that made the sample, and their scatter against Fisher's information.
#include "analysis/sizes/rosin_rammler.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>

#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

constexpr int kGrains = 2000;
constexpr double kRecovered = 0.02;

/// One grain in each of `grains` equal shares of the law.
std::vector<double> ideal(const RosinRammler& law, int grains) {
  std::vector<double> d;
  d.reserve(static_cast<std::size_t>(grains));
  for (int i = 0; i < grains; ++i) d.push_back(law.quantile_um((i + 0.5) / grains));
  return d;
}

std::vector<double> drawn(const RosinRammler& law, int grains, unsigned seed) {
  boost::random::mt19937_64 generator(seed);
  boost::random::uniform_01<double> any;
  std::vector<double> d(static_cast<std::size_t>(grains));
  for (double& x : d) x = law.quantile_um(any(generator));
  return d;
}

TEST(RosinRammler, QuantileInvertsTheLawAndX0Has63PercentFiner) {
  EXPECT_NEAR((RosinRammler{70.7, 4}.finer(70.7)), 1 - std::exp(-1.0), 1e-12);
  for (const RosinRammler& law :
       {RosinRammler{70.7, 4}, RosinRammler{70.7, 4, 40, 110}, RosinRammler{30, 2, 40, 110, 40}}) {
    for (const double share : {0.001, 0.2, 0.5, 0.9, 0.999})
      EXPECT_NEAR(law.finer(law.quantile_um(share)), share, 1e-10);
  }
}

TEST(RosinRammler, RecoveredFrom2000Grains) {
  for (const double n : {1.5, 3.0, 6.0}) {
    for (const RosinRammler& law :
         {RosinRammler{60, n}, RosinRammler{60, n, 40, 110}, RosinRammler{25, n, 40, 80, 40}}) {
      const auto fit =
          fit_rosin_rammler(SizeDistribution(ideal(law, kGrains), Weighting::number), law);
      ASSERT_TRUE(fit) << n;
      EXPECT_NEAR(fit->law.x0_um / law.x0_um, 1, kRecovered) << n;
      EXPECT_NEAR(fit->law.n / n, 1, kRecovered) << n;
      EXPECT_GT(fit->r_squared, 0.9999);
    }
  }
}

TEST(RosinRammler, ScatterOfRandomSamplesIsTheSmallestPossible) {
  // Fisher's information of the whole law: sigma_n/n = 0.7797/sqrt(N), sigma_x0/x0 = 1.0525/(n sqrt(N)).
  const RosinRammler law{60, 3};
  constexpr int trials = 200;
  constexpr double kScatter = 0.15;  // 3 sigma of a standard deviation from 200 trials
  double n_off = 0, n_square = 0, x_square = 0, claimed_n = 0, claimed_x = 0;
  for (unsigned t = 0; t < trials; ++t) {
    const auto fit = fit_rosin_rammler(SizeDistribution(drawn(law, kGrains, t), Weighting::number));
    ASSERT_TRUE(fit);
    n_off += (fit->law.n / 3 - 1) / trials;
    n_square += std::pow(fit->law.n / 3 - 1, 2) / trials;
    x_square += std::pow(fit->law.x0_um / 60 - 1, 2) / trials;
    claimed_n += fit->n_sigma / 3 / trials;
    claimed_x += fit->x0_sigma_um / 60 / trials;
  }
  const double sigma_n = 0.7797 / std::sqrt(kGrains), sigma_x = 1.0525 / 3 / std::sqrt(kGrains);
  EXPECT_NEAR(std::sqrt(n_square) / sigma_n, 1, kScatter);
  EXPECT_NEAR(std::sqrt(x_square) / sigma_x, 1, kScatter);
  EXPECT_NEAR(claimed_n / sigma_n, 1, 0.02);  // mean of 200 estimates of a sigma
  EXPECT_NEAR(claimed_x / sigma_x, 1, 0.02);
  EXPECT_LT(std::fabs(n_off), 3 * sigma_n / std::sqrt(trials));
}

TEST(RosinRammler, ByMassFromGrainsThatAreCountedByNumber) {
  // Law by mass: shares by number go with dY/d^3. One grain per equal share of number.
  const RosinRammler law{70.7, 4, 40, 110};
  constexpr int steps = 200000;
  std::vector<double> number(steps + 1, 0.0);
  const auto at = [](int i) { return 40 + 70.0 * i / steps; };
  for (int i = 0; i < steps; ++i) {
    number[i + 1] =
        number[i] + (law.finer(at(i + 1)) - law.finer(at(i))) / std::pow(at(i) + 35.0 / steps, 3);
  }
  std::vector<double> d;
  for (int k = 0, i = 0; k < kGrains; ++k) {
    while (number[i + 1] < (k + 0.5) / kGrains * number[steps]) ++i;
    d.push_back(at(i));
  }
  const auto fit = fit_rosin_rammler(SizeDistribution(d, Weighting::mass), law);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->law.x0_um / 70.7, 1, kRecovered);
  EXPECT_NEAR(fit->law.n / 4, 1, kRecovered);
}

TEST(RosinRammler, FitsItsOwnSamplesAndFewOthers) {
  // 1 % of samples of a law are refused by chance; 5 of 200 come in 5 % of such tests. Power: the share
  // finer of a lognormal powder is off by 6 % somewhere, far beyond chance with 2000 grains.
  constexpr int trials = 200;
  int refused = 0;
  for (unsigned t = 0; t < trials; ++t) {
    const int grains = t % 2 == 0 ? 100 : 400;
    const auto fit =
        fit_rosin_rammler(SizeDistribution(drawn({60, 3}, grains, 1000 + t), Weighting::number));
    refused += fit && fit->fits() ? 0 : 1;
  }
  EXPECT_LE(refused, 5);
  boost::random::mt19937_64 generator(8);
  boost::random::normal_distribution<double> normal;
  std::vector<double> lognormal, two;
  for (int i = 0; i < kGrains; ++i) {
    lognormal.push_back(30 * std::exp(0.25 * normal(generator)));
    two.push_back((i % 10 < 7 ? 20 : 60) * std::exp(0.05 * normal(generator)));
  }
  for (const auto& d : {lognormal, two}) {
    for (const Weighting w : {Weighting::number, Weighting::mass}) {
      const auto fit = fit_rosin_rammler(SizeDistribution(d, w));
      ASSERT_TRUE(fit);
      EXPECT_FALSE(fit->fits());
    }
  }
  const auto off = fit_rosin_rammler(SizeDistribution(two, Weighting::number));
  // Between the populations 70 % are finer at every size: a law that rises there misses one end.
  EXPECT_GT(off->miss, 0.15);
}

TEST(RosinRammler, RoundedSizesFitToo) {
  // Areas of whole pixels: at 8 pixels a size holds some per cent of the grains.
  std::vector<double> d = drawn({10, 4}, kGrains, 3);
  for (double& x : d) x = std::sqrt(std::max(1.0, std::round(M_PI / 4 * x * x)) * 4 / M_PI);
  const auto fit = fit_rosin_rammler(SizeDistribution(d, Weighting::number));
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->fits()) << fit->miss;
}

TEST(RosinRammler, NeverAtInfinity) {
  // Sizes of equal shares per ratio between two limits: a power of d, the law's limit x0 -> infinity.
  std::vector<double> d;
  for (int i = 0; i < kGrains; ++i) d.push_back(std::exp(std::log(100.0) * i / kGrains));
  const RosinRammler cut{0, 0, 1, 100};
  for (const Weighting w : {Weighting::number, Weighting::mass}) {
    const auto fit = fit_rosin_rammler(SizeDistribution(d, w), cut);
    if (fit) EXPECT_LT(fit->law.x0_um, 1000);
    const auto near = nearest_rosin_rammler(SizeDistribution(d, w), cut);
    if (near) EXPECT_LT(near->law.x0_um, 1000);
  }
}

TEST(RosinRammler, NoLawFromGrainsThatDecideNone) {
  const auto fit = [](std::vector<double> d) {
    return fit_rosin_rammler(SizeDistribution(std::move(d), Weighting::number)).has_value();
  };
  EXPECT_FALSE(fit(std::vector<double>(50, 60.0)));
  EXPECT_FALSE(fit({10, 20, 30}));
  std::vector<double> two(70, 20.0);
  two.insert(two.end(), 30, 60.0);
  EXPECT_FALSE(fit(two));
  EXPECT_TRUE(fit(ideal({60, 3}, 50)));
  // Of 3000 grains of a Pareto law a handful has the mass.
  std::vector<double> dust;
  for (int i = 0; i < 3000; ++i) dust.push_back(5.0 * std::pow(1.0 - (i + 0.5) / 3000, -0.4));
  dust.insert(dust.end(), {210, 277});
  const SizeDistribution by_mass(dust, Weighting::mass);
  EXPECT_FALSE(fit_rosin_rammler(by_mass).has_value());
}

}  // namespace
}  // namespace powderlink::analysis
