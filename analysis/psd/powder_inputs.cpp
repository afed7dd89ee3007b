// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/psd/powder_inputs.h"

#include <fmt/format.h>

#include <boost/math/special_functions/prime.hpp>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr unsigned kFirstSeed = 1229;  // the prime 10007: LIGGGHTS wants primes above 10 000

const RosinRammlerFit& required(const std::optional<RosinRammlerFit>& fit) {
  if (fit) return *fit;
  throw InvalidInput("powder for LIGGGHTS and OpenFOAM", "sizes without a Rosin-Rammler law",
                     "10 grains or more of different sizes", "measure more grains");
}

std::string foam_distribution(const RosinRammler& law) {
  return fmt::format(
      "    type RosinRammler;\n    RosinRammlerDistribution\n    {{\n        minValue {:.6g}e-6;\n"
      "        maxValue {:.6g}e-6;\n        d        {:.6g}e-6;\n        n        {:.6g};\n    "
      "}}\n",
      law.min_um, law.max_um, law.x0_um, law.n);
}

}  // namespace

std::string liggghts_powder(const PsdReport& report, double density_kg_m3, int classes) {
  constexpr int most = 200;
  if (classes < 2 || classes > most) {
    throw InvalidInput("option --classes", fmt::format("{}", classes), fmt::format("2 to {}", most),
                       "12 is usual");
  }
  if (!(density_kg_m3 >= 1.0 && density_kg_m3 <= 30000.0)) {
    throw InvalidInput("option --density-kg-m3", number_text(density_kg_m3), "1 to 30000 kg/m^3",
                       "give the density of the grains, 7980 for 316L");
  }
  const RosinRammlerFit& fit = required(report.cut_number);
  const RosinRammler& law = fit.law;
  std::string text = fmt::format(
      "# Rosin-Rammler by number, x0 {:.4g} um, n {:.4g}, {:.4g} to {:.4g} um, R^2 {:.5f}; {} "
      "grains.\n"
      "# Radii in m: units si. The type of the atoms is 1.\n",
      law.x0_um, law.n, law.min_um, law.max_um, fit.r_squared, report.set.particles.size());
  const double width = (law.max_um - law.min_um) / classes;
  std::string shares;
  for (int i = 0; i < classes; ++i) {
    const double low = law.min_um + i * width;
    text += fmt::format(
        "fix class{} all particletemplate/sphere {} atom_type 1 density constant {:g} radius "
        "constant "
        "{:.6g}e-6 volume_limit 1e-20\n",
        i + 1, boost::math::prime(kFirstSeed + static_cast<unsigned>(i)), density_kg_m3,
        0.5 * (low + 0.5 * width));
    shares += fmt::format(" &\n    class{} {:.8f}", i + 1,
                          (i + 1 == classes ? 1.0 : law.finer(low + width)) - law.finer(low));
  }
  return text + fmt::format("fix powder all particledistribution/discrete/numberbased {} {}{}\n",
                            boost::math::prime(kFirstSeed + static_cast<unsigned>(classes)),
                            classes, shares);
}

std::string openfoam_sizes(const PsdReport& report) {
  const RosinRammlerFit& number = required(report.foam_number);
  std::string text = fmt::format(
      "// Diameters in m. By number (parcelBasisType fixed); R^2 {:.5f}; {} grains.\n"
      "sizeDistribution\n{{\n{}}}\n",
      number.r_squared, report.set.particles.size(), foam_distribution(number.law));
  if (report.foam_mass) {
    text += fmt::format(
        "\n// By mass (parcelBasisType mass); R^2 {:.5f}.\n/*\nsizeDistribution\n{{\n{}}}\n*/\n",
        report.foam_mass->r_squared, foam_distribution(report.foam_mass->law));
  }
  return text;
}

}  // namespace powderlink::analysis
