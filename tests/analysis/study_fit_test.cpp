// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adhesion_fit.h"

#include <gtest/gtest.h>

#include "analysis/critical_diameter.h"
#include "analysis/material_library.h"
#include "tests/analysis/test_files.h"

namespace powderlink::analysis {
namespace {

Study glass_study(double energy, const std::vector<EffectChoice>& effects) {
  Study s;
  s.file = "study.toml";
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.effects = effects;
  s.adhesive_energy = {0.001, 1000.0};
  for (const double v : {1.5, 3.0, 6.0}) {
    KatRow row{v};
    row.critical_diameter_um =
        critical_diameter(ReducedModel(row_setup(s, row, energy)), v).diameter_m * 1e6;
    s.rows.push_back(row);
  }
  return s;
}

TEST(AdhesionFit, FindsTheEnergyThatMadeTheData) {
  const struct {
    double energy;
    std::vector<EffectChoice> effects;
  } cases[] = {{50.0, {}}, {0.09, {{"finite_stop_pulse", {1e-4, 0.0}}}}};
  for (const auto& c : cases) {
    const AdhesionFit fit = fit_adhesive_energy(glass_study(c.energy, c.effects));
    constexpr double tolerance =
        1e-3;  // d_c is known to 1e-4, and Gamma goes with up to its square
    EXPECT_NEAR(fit.adhesive_energy_J_m2 / c.energy, 1.0, tolerance);
    EXPECT_LT(fit.rms_relative_error, tolerance);
    EXPECT_FALSE(fit.at_bound);
  }
}

TEST(AdhesionFit, CertainRowsWeighMore) {
  Study s = glass_study(50.0, {});
  s.rows.resize(2);
  s.rows[0].critical_diameter_sigma_um = 1e-3 * *s.rows[0].critical_diameter_um;
  s.rows[1].critical_diameter_sigma_um = 0.1 * *s.rows[1].critical_diameter_um;
  *s.rows[1].critical_diameter_um *= 1.3;
  EXPECT_NEAR(fit_adhesive_energy(s).adhesive_energy_J_m2 / 50.0, 1.0, 2e-3);
}

TEST(AdhesionFit, SaysWhenABoundHolds) {
  Study s = glass_study(50.0, {});
  s.adhesive_energy.upper_J_m2 = 20.0;
  const AdhesionFit fit = fit_adhesive_energy(s);
  EXPECT_TRUE(fit.at_bound);
  EXPECT_NEAR(fit.adhesive_energy_J_m2 / 20.0, 1.0, 1e-3);
  EXPECT_NE(row_energies(s).origin.find("bound"), std::string::npos);
}

TEST(AdhesionFit, RowsMayBringTheirOwn) {
  Study s = glass_study(50.0, {});
  for (std::size_t i = 0; i < s.rows.size(); ++i)
    s.rows[i].adhesive_energy_J_m2 = 1.0 + static_cast<double>(i);
  EXPECT_EQ(row_energies(s).adhesive_energy_J_m2, (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(AdhesionFit, NeedsMeasurements) {
  Study s = glass_study(50.0, {});
  s.rows[1].critical_diameter_um.reset();
  expect_refusal([&] { fit_adhesive_energy(s); }, {"no measured diameters", "give a number"});
}

}  // namespace
}  // namespace powderlink::analysis
