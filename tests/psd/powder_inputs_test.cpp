// SPDX-License-Identifier: GPL-3.0-or-later
// What is pasted into the host programs draws the powder that was measured.
#include "analysis/psd/powder_inputs.h"

#include <fmt/format.h>

#include <regex>

#include "tests/analysis/test_files.h"

namespace powderlink::analysis {
namespace {

PsdReport report_of(const RosinRammler& law) {
  constexpr int grains = 2000;
  const TestFolder folder;
  std::string text = "area_um2,perimeter_um\n";
  for (int i = 0; i < grains; ++i) {
    const double d = law.quantile_um((i + 0.5) / grains);
    text += fmt::format("{:.9g},{:.9g}\n", M_PI * d * d / 4, M_PI * d);
  }
  return analyse_sizes({folder.write("t.csv", text)}, {});
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

double off_of_file(const RosinRammler& law) {
  const std::string text = openfoam_sizes(report_of(law));
  return off_when_drawn(1e6 * number_after(text, "minValue"), 1e6 * number_after(text, "maxValue"),
                        1e6 * number_after(text, " d"), number_after(text, " n"), law);
}

TEST(PowderInputs, OpenFoamDrawsTheMeasuredQuantiles) {
  constexpr double kSameForm = 0.005;  // the smallest grain of 2000 is not quite the law's end
  EXPECT_LT(off_of_file({30, 2.5, 40, 110, 40}), kSameForm);
  // A law that begins at 0 and is cut off at 40 has grains right at the cut, OpenFOAM's has none:
  // two parameters cannot mend that.
  constexpr double kOtherForm = 0.04;
  const RosinRammler textbook{70.7, 4, 40, 110};
  EXPECT_LT(off_of_file(textbook), kOtherForm);
  // What pasting the textbook's x0 and n would give.
  EXPECT_GT(off_when_drawn(40, 110, 70.7, 4, textbook), 5 * kOtherForm);
}

TEST(PowderInputs, LiggghtsClassesHaveTheMeanOfTheLaw) {
  constexpr double kClasses = 0.005;  // 20 classes with one size each
  const RosinRammler law{60, 3, 20, 110};
  const PsdReport report = report_of(law);
  const std::string text = liggghts_powder(report, 7980, 20);
  std::vector<double> radius, share;
  const std::regex radii("radius constant ([0-9.e-]+)"), shares("    class[0-9]+ ([0-9.]+)");
  for (std::sregex_iterator i(text.begin(), text.end(), radii), end; i != end; ++i)
    radius.push_back(std::stod((*i)[1]));
  for (std::sregex_iterator i(text.begin(), text.end(), shares), end; i != end; ++i)
    share.push_back(std::stod((*i)[1]));
  ASSERT_EQ(radius.size(), 20U);
  ASSERT_EQ(share.size(), 20U);
  double sum = 0, mean = 0, expected = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    sum += share[i];
    mean += 2e6 * radius[i] * share[i];
  }
  for (const double d : report.number->diameters_um()) expected += d / 2000;
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(mean / expected, 1, kClasses);
  expect_refusal([&] { liggghts_powder(report, -1, 20); }, {"--density-kg-m3"});
}

}  // namespace
}  // namespace powderlink::analysis
