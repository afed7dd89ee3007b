// SPDX-License-Identifier: GPL-3.0-or-later
// What is pasted into the host programs draws the powder that was measured, whatever its sizes are.
#include "analysis/sizes/pictures/powder_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <numeric>
#include <regex>

#include "analysis/sizes/pictures/powder_classes.h"
#include "tests/base/test_files.h"

namespace powderlink::analysis {
namespace {

PsdReport report_of(const std::vector<double>& diameters_um) {
  const TestFolder folder;
  std::string text = "area_um2,perimeter_um\n";
  for (const double d : diameters_um)
    text += fmt::format("{:.12g},{:.12g}\n", M_PI * d * d / 4, M_PI * d);
  PsdOptions options;
  options.bootstrap.replicates = 20;
  return analyse_sizes({folder.write("t.csv", text)}, options);
}

std::vector<double> law_sample(const RosinRammler& law) {
  constexpr int grains = 2000;
  std::vector<double> d;
  for (int i = 0; i < grains; ++i) d.push_back(law.quantile_um((i + 0.5) / grains));
  return d;
}

std::vector<double> lognormal(double median_um, double spread, int grains) {
  boost::random::mt19937_64 generator(3);
  boost::random::normal_distribution<double> normal;
  std::vector<double> d(static_cast<std::size_t>(grains));
  for (double& x : d) x = median_um * std::exp(spread * normal(generator));
  return d;
}

std::vector<double> both(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Powder {
  const char* name;
  std::vector<double> d;
};

std::vector<Powder> powders() {
  std::vector<double> cut = lognormal(55, 0.4, 8000);
  cut.erase(std::remove_if(cut.begin(), cut.end(), [](double d) { return d < 45 || d > 63; }),
            cut.end());
  return {{"two sizes", both(std::vector<double>(700, 20), std::vector<double>(300, 60))},
          {"Rosin-Rammler", law_sample({60, 3, 20, 110})},
          {"lognormal", lognormal(30, 0.5, 2000)},
          {"narrow cut of a sieve", cut},
          {"one size", std::vector<double>(50, 42)},
          {"dust", both(lognormal(1.5, 0.3, 9000), lognormal(50, 0.15, 300))},
          {"three grains", {20, 31, 60}},
          {"two populations", both(lognormal(20, 0.08, 1400), lognormal(60, 0.08, 600))}};
}

struct Size {
  double diameter_um, share;
};

std::vector<Size> of_liggghts(const std::string& text) {
  std::vector<Size> sizes;
  const std::regex radii("radius constant ([0-9.e-]+)"), shares("    class[0-9]+ ([0-9.]+)");
  for (std::sregex_iterator i(text.begin(), text.end(), radii), end; i != end; ++i)
    sizes.push_back({2e6 * std::stod((*i)[1]), 0});
  std::size_t k = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), shares), end; i != end; ++i)
    sizes.at(k++).share = std::stod((*i)[1]);
  EXPECT_EQ(k, sizes.size());
  const std::string powder = fmt::format("discrete/numberbased 1[0-9]+ {} ", sizes.size());
  EXPECT_TRUE(std::regex_search(text, std::regex(powder))) << text;
  return sizes;
}

std::vector<Size> of_openfoam(const std::string& text) {
  std::vector<Size> sizes;
  const std::string list = text.substr(0, text.find("/*"));
  EXPECT_NE(list.find("type binned;"), std::string::npos) << list;
  const std::regex pair(R"(\(([0-9.e+-]+) ([0-9.e+-]+)\))");
  for (std::sregex_iterator i(list.begin(), list.end(), pair), end; i != end; ++i)
    sizes.push_back({1e6 * std::stod((*i)[1]), std::stod((*i)[2])});
  return sizes;
}

/// At every limit between two of its sizes a whole number of the sorted grains is finer, and these have
/// the share by mass that the file has.
void expect_shares(const std::string& what, std::vector<double> d, const std::vector<Size>& sizes) {
  constexpr double kDigits = 1e-6;  // printed
  std::sort(d.begin(), d.end());
  std::vector<double> cubes{0};
  for (const double x : d) cubes.push_back(cubes.back() + x * x * x);
  const auto n = static_cast<double>(d.size());
  const double mean = std::accumulate(
      sizes.begin(), sizes.end(), 0.0,
      [](double sum, const Size& s) { return sum + s.share * std::pow(s.diameter_um, 3); });
  EXPECT_NEAR(mean / (cubes.back() / n), 1, kDigits) << what;
  double number = 0, mass = 0;
  for (const Size& s : sizes) {
    number += s.share;
    mass += s.share * std::pow(s.diameter_um, 3) / mean;
    const double finer = std::round(number * n);
    EXPECT_NEAR(number * n / finer, 1, kDigits) << what;
    EXPECT_NEAR(mass, cubes[static_cast<std::size_t>(finer)] / cubes.back(), kDigits)
        << what << ", up to " << s.diameter_um;
  }
  EXPECT_NEAR(number, 1, kDigits) << what;
}

TEST(PowderInputs, SharesByNumberAndByMassAreMeasured) {
  for (const Powder& p : powders()) {
    const PsdReport report = report_of(p.d);
    expect_shares(p.name, p.d, of_liggghts(liggghts_powder(report, 7980, 12)));
    expect_shares(p.name, p.d, of_openfoam(openfoam_sizes(report)));
  }
}

TEST(PowderInputs, PopulationsAreNotMixed) {
  const auto sizes = of_liggghts(liggghts_powder(report_of(powders().front().d), 7980, 12));
  ASSERT_EQ(sizes.size(), 2U);
  EXPECT_NEAR(sizes[0].diameter_um, 20, 1e-5);
  EXPECT_NEAR(sizes[0].share, 0.7, 1e-9);
  EXPECT_NEAR(sizes[1].diameter_um, 60, 1e-5);
  EXPECT_NEAR(sizes[1].share, 0.3, 1e-9);
  for (const Powder& p : powders()) {
    const auto classes = powder_classes(*report_of(p.d).number, 12);
    if (std::string(p.name) == "two populations") {
      for (const PowderClass& c : classes)
        EXPECT_TRUE(c.largest_um < 35 || c.smallest_um > 35) << c.smallest_um;
    }
    EXPECT_LE(classes.size(), 12U);
  }
}

/// Largest difference of shares between the sizes of a file and the grains.
double largest_step(std::vector<double> d, const std::vector<Size>& sizes, bool by_mass) {
  std::sort(d.begin(), d.end());
  const auto weight = [&](double x) { return by_mass ? x * x * x : 1.0; };
  double all = 0, all_sizes = 0, largest = 0, grains = 0, drawn = 0;
  for (const double x : d) all += weight(x);
  for (const Size& s : sizes) all_sizes += s.share * weight(s.diameter_um);
  std::size_t k = 0;
  for (const double x : d) {
    for (; k < sizes.size() && sizes[k].diameter_um < x; ++k)
      drawn += sizes[k].share * weight(sizes[k].diameter_um) / all_sizes;
    largest = std::max(largest, std::fabs(drawn - grains));
    grains += weight(x) / all;
  }
  return largest;
}

TEST(PowderInputs, ClassesAreFineWhereGrainsOrMassAre) {
  // No class has much more than a mean share by number or by mass, but for one grain that has it alone.
  constexpr double kMeanShares = 3;
  for (const Powder& p : powders()) {
    if (p.d.size() < 1000 || std::string(p.name) == "two sizes") continue;
    const PsdReport report = report_of(p.d);
    const auto coarse = of_liggghts(liggghts_powder(report, 7980, 20));
    const auto fine = of_openfoam(openfoam_sizes(report));
    for (const bool by_mass : {false, true}) {
      const auto& weights = (by_mass ? report.mass : report.number)->weights();
      const double grain = weights.back() / static_cast<double>(weights.size());
      EXPECT_LT(largest_step(p.d, coarse, by_mass), kMeanShares / 20 + grain) << p.name << by_mass;
      EXPECT_LT(largest_step(p.d, fine, by_mass), kMeanShares / 100 + grain) << p.name << by_mass;
    }
  }
}

double number_after(const std::string& text, const std::string& name) {
  std::smatch found;
  EXPECT_TRUE(std::regex_search(text, found, std::regex(name + "\\s+([0-9.e-]+);"))) << name;
  return found.empty() ? 0.0 : std::stod(found[1]);
}

/// Largest relative error of D10, D50 and D90 when OpenFOAM draws with these numbers.
double off_when_drawn(double low, double high, double d, double n, const RosinRammler& law) {
  const double k = 1 - std::exp(-std::pow((high - low) / d, n));
  double off = 0;
  for (const double y : {0.1, 0.5, 0.9}) {
    const double drawn = low + d * std::pow(-std::log(1 - y * k), 1 / n);
    off = std::max(off, std::fabs(drawn / law.quantile_um(y) - 1));
  }
  return off;
}

TEST(PowderInputs, ALawIsOfferedWhereItFits) {
  constexpr double kSameForm = 0.005;  // the smallest grain of 2000 is not quite the law's end
  const RosinRammler own{30, 2.5, 40, 110, 40};
  const std::string text = openfoam_sizes(report_of(law_sample(own)));
  EXPECT_LT(
      off_when_drawn(1e6 * number_after(text, "minValue"), 1e6 * number_after(text, "maxValue"),
                     1e6 * number_after(text, " d"), number_after(text, " n"), own),
      kSameForm);
  // What pasting the textbook's x0 and n would give.
  const RosinRammler textbook{70.7, 4, 40, 110};
  EXPECT_GT(off_when_drawn(40, 110, 70.7, 4, textbook), 0.2);
  const PsdReport whole = report_of(law_sample({60, 3}));
  EXPECT_NE(liggghts_powder(whole, 7980, 12).find("fits them: x0 60"), std::string::npos);
  for (const Powder& p : powders()) {
    const std::string name = p.name;
    if (name != "two sizes" && name != "two populations" && name != "dust" && name != "one size")
      continue;
    const PsdReport report = report_of(p.d);
    EXPECT_EQ(liggghts_powder(report, 7980, 12).find("Rosin"), std::string::npos) << name;
    EXPECT_EQ(openfoam_sizes(report).find("type RosinRammler"), std::string::npos) << name;
  }
}

TEST(PowderInputs, BadOptionsAreRefused) {
  const PsdReport report = report_of({20, 30, 40});
  expect_refusal([&] { liggghts_powder(report, -1, 20); }, {"--density-kg-m3"});
  expect_refusal([&] { liggghts_powder(report, 7980, 1); }, {"--classes"});
  expect_refusal([&] { liggghts_powder(report, 7980, 201); }, {"--classes"});
}

}  // namespace
}  // namespace powderlink::analysis
