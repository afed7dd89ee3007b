// SPDX-License-Identifier: GPL-3.0-or-later
/// \file thesis_values.h
/// What the thesis prints for its three 316L drops, beside Eq. 4.5 recomputed from its own inputs.
/// Source: L. Pedrolli, "CFD-DEM study of the metallic powder flow in Laser Metal Deposition",
/// doctoral thesis, University of Deusto, Section 4.4; materials of its Table 4.1.
/// Tests: tests/analysis/kat/kat_theory_report_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink::analysis {

struct ThesisValue {
  std::string particle, substrate;
  double impact_velocity_m_s;
  double critical_diameter_um;
  double printed_energy_J_m2;
  std::string difference;  ///< where the 2-4 % between print and recomputation come from
};

const std::vector<ThesisValue>& thesis_values();

/// The drop with these materials, speed and diameter (to 0.5 %), or nullptr.
const ThesisValue* find_thesis_value(const std::string& particle, const std::string& substrate,
                                     double impact_velocity_m_s, double critical_diameter_um);

}  // namespace powderlink::analysis
