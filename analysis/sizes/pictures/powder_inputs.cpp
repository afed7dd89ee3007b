// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/pictures/powder_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/prime.hpp>
#include <cmath>

#include "analysis/sizes/pictures/powder_classes.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr unsigned kFirstSeed = 1229;  // the prime 10007: LIGGGHTS wants primes above 10 000
constexpr double kSmallestVolume_m3 =
    1e-20;                               // templates refuse less; LIGGGHTS's own limit is 1e-12
constexpr std::size_t kFoamSizes = 100;  // cost nothing when they are drawn

std::string grains_of(const PsdReport& r) {
  const std::size_t n = r.set.particles.size();
  return fmt::format("{} grains, D50 {:.4g} um by number and {:.4g} um by mass", n,
                     r.by_number[1].value, r.by_mass[1].value);
}

std::string foam_sizes(const std::vector<PowderClass>& classes, double PowderClass::*share) {
  std::string text =
      "    type binned;\n    binnedDistribution\n    {\n        distribution\n        (\n";
  for (const PowderClass& c : classes)
    text += fmt::format("            ({:.7e} {:.7e})\n", 1e-6 * c.diameter_um, c.*share);
  return text + "        );\n    }\n";
}

std::string foam_law(const char* by, const std::optional<RosinRammlerFit>& fit) {
  if (!fit || !fit->fits())
    return fmt::format("// {}: OpenFOAM's RosinRammler does not fit.\n", by);
  const RosinRammler& law = fit->law;
  return fmt::format(
      "// {}: OpenFOAM's RosinRammler fits, R^2 {:.5f}.\n/*\nsizeDistribution\n{{\n"
      "    type RosinRammler;\n    RosinRammlerDistribution\n    {{\n        minValue {:.6e};\n"
      "        maxValue {:.6e};\n        d        {:.6e};\n        n        {:.6g};\n    "
      "}}\n}}\n*/\n",
      by, fit->r_squared, 1e-6 * law.min_um, 1e-6 * law.max_um, 1e-6 * law.x0_um, law.n);
}

}  // namespace

std::string liggghts_powder(const PsdReport& report, double density_kg_m3, int classes) {
  constexpr int most = 200;
  if (classes < 2 || classes > most) {
    throw InvalidInput("option --classes", fmt::format("{}", classes), fmt::format("2 to {}", most),
                       "give more classes for steps that are closer together");
  }
  if (!(density_kg_m3 >= 1.0 && density_kg_m3 <= 30000.0)) {
    throw InvalidInput("option --density-kg-m3", number_text(density_kg_m3), "1 to 30000 kg/m^3",
                       "give the density of the grains, 7980 for 316L");
  }
  const auto list = powder_classes(*report.number, static_cast<std::size_t>(classes));
  std::string text = fmt::format("# {}.\n", grains_of(report));
  if (report.cut_number && report.cut_number->fits()) {
    const RosinRammler& law = report.cut_number->law;
    text += fmt::format(
        "# Rosin-Rammler by number fits them: x0 {:.4g} um, n {:.4g}, {:.4g} to {:.4g} um, R^2 "
        "{:.5f}.\n",
        law.x0_um, law.n, law.min_um, law.max_um, report.cut_number->r_squared);
  }
  text +=
      "# Weights are shares by number, as measured; so are the shares by mass that follow.\n"
      "# Radii in m: units si. The type of the atoms is 1.\n";
  std::string shares;
  unsigned i = 0;
  for (const PowderClass& c : list) {
    const double radius_m = 0.5e-6 * c.diameter_um;
    const double volume_m3 =
        4.0 / 3.0 * boost::math::constants::pi<double>() * std::pow(radius_m, 3);
    text += fmt::format(
        "fix class{} all particletemplate/sphere {} atom_type 1 density constant {:g} radius "
        "constant {:.7e} volume_limit {:.2g}\n",
        i + 1, boost::math::prime(kFirstSeed + i), density_kg_m3, radius_m,
        std::min(kSmallestVolume_m3, 0.1 * volume_m3));
    shares += fmt::format(" &\n    class{} {:.10f}", ++i, c.share_number);
  }
  return text + fmt::format("fix powder all particledistribution/discrete/numberbased {} {}{}\n",
                            boost::math::prime(kFirstSeed + i), list.size(), shares);
}

std::string openfoam_sizes(const PsdReport& report) {
  const auto list = powder_classes(*report.number, kFoamSizes);
  return fmt::format(
      "// {}; diameters in m.\n"
      "// By number (parcelBasisType fixed), shares as measured.\nsizeDistribution\n{{\n{}}}\n\n"
      "// By mass (parcelBasisType mass), shares as "
      "measured.\n/*\nsizeDistribution\n{{\n{}}}\n*/\n\n"
      "{}{}",
      grains_of(report), foam_sizes(list, &PowderClass::share_number),
      foam_sizes(list, &PowderClass::share_mass), foam_law("By number", report.foam_number),
      foam_law("By mass", report.foam_mass));
}

}  // namespace powderlink::analysis
