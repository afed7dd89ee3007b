// SPDX-License-Identifier: GPL-3.0-or-later
// The powder of foam_cases/pipe: the mean mass of its classes is that of the Rosin-Rammler law in closed
// form, with t = ((d - d0)/x0)^n, which is exponential between its values a and b at the cuts:
//   by number  E[d^3] = sum_k C(3, k) d0^(3-k) x0^k (G(1 + k/n, a) - G(1 + k/n, b))/(e^-a - e^-b)
//   by mass    E[d^3] = x0^3 (e^-a - e^-b)/(G(1 - 3/n, a) - G(1 - 3/n, b)), d0 = 0
// G: upper incomplete gamma function.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <cstdio>
#include <regex>
#include <string>

namespace {

constexpr double kLeast_um = 40, kMost_um = 110, kDensity_kg_m3 = 7980;
/// Classes of 5 um with the mass of their middle: (5 um)^2/24 of the curvature of d^3, some 0.2 %.
constexpr double kClasses = 0.004;

struct Powder {
  double scale_um = 0, mean_mass_kg = 0, mass_of_classes_kg = 0, shares = 0;
};

std::string output(const std::string& command) {
  std::string text;
  std::array<char, 4096> part{};
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

double mass_kg(double diameter_um) {
  return kDensity_kg_m3 * boost::math::constants::pi<double>() / 6 *
         std::pow(1e-6 * diameter_um, 3);
}

Powder made(const std::string& arguments) {
  const std::string text = output("'" PIPE_CASE "/make_powder.sh' " + arguments);
  Powder powder;
  std::smatch match;
  if (std::regex_search(text, match, std::regex("x0 ([0-9.]+) um"))) {
    powder.scale_um = std::stod(match[1]);
  }
  if (std::regex_search(text, match, std::regex("grainMass +index +([-+0-9.e]+)"))) {
    powder.mean_mass_kg = std::stod(match[1]);
  }
  const std::regex radius("fix class([0-9]+) +all.*radius constant ([-+0-9.e]+)");
  for (std::sregex_iterator i(text.begin(), text.end(), radius), end; i != end; ++i) {
    const std::regex share("\n +class" + (*i)[1].str() + " +([0-9.]+)");
    EXPECT_TRUE(std::regex_search(text, match, share)) << (*i)[1];
    powder.shares += std::stod(match[1]);
    powder.mass_of_classes_kg += std::stod(match[1]) * mass_kg(2e6 * std::stod((*i)[2]));
  }
  return powder;
}

double between(double power, double a, double b) {
  return boost::math::tgamma(power, a) - boost::math::tgamma(power, b);
}

double mean_mass_by_number_kg(double origin_um, double n, double scale_um) {
  const double a = std::pow((kLeast_um - origin_um) / scale_um, n);
  const double b = std::pow((kMost_um - origin_um) / scale_um, n);
  double cube = 0;
  for (unsigned k = 0; k <= 3; ++k) {
    cube += boost::math::binomial_coefficient<double>(3, k) * std::pow(origin_um, 3 - k) *
            std::pow(scale_um, k) * between(1 + k / n, a, b);
  }
  return mass_kg(std::cbrt(cube / (std::exp(-a) - std::exp(-b))));
}

double mean_mass_by_mass_kg(double n, double scale_um) {
  const double a = std::pow(kLeast_um / scale_um, n), b = std::pow(kMost_um / scale_um, n);
  return mass_kg(scale_um * std::cbrt((std::exp(-a) - std::exp(-b)) / between(1 - 3 / n, a, b)));
}

TEST(PipePowder, ByNumberFromTheSmallestGrainOn) {
  for (const double mass : {1.009e-9, 1.028e-9}) {
    const Powder powder = made("number 40e-6 1.5 mean:" + std::to_string(mass * 1e9) + "e-9 7980");
    EXPECT_NEAR(powder.mean_mass_kg, mass, 1e-4 * mass);
    EXPECT_NEAR(powder.shares, 1, 1e-5);
    EXPECT_NEAR(powder.mass_of_classes_kg, mass, 1e-4 * mass);
    EXPECT_NEAR(mean_mass_by_number_kg(40, 1.5, powder.scale_um), mass, kClasses * mass);
  }
}

TEST(PipePowder, ByNumberFromZeroOn) {
  const Powder powder = made("number 0 4 mean:1.009e-9 7980");
  EXPECT_NEAR(mean_mass_by_number_kg(0, 4, powder.scale_um), 1.009e-9, kClasses * 1.009e-9);
}

TEST(PipePowder, ByMass) {
  const Powder powder = made("mass 0 4 70.7e-6 7980");
  EXPECT_DOUBLE_EQ(powder.scale_um, 70.7);
  EXPECT_NEAR(powder.mass_of_classes_kg, powder.mean_mass_kg, 1e-4 * powder.mean_mass_kg);
  EXPECT_NEAR(powder.mean_mass_kg / mean_mass_by_mass_kg(4, 70.7), 1, kClasses);
}

}  // namespace
