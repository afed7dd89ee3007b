// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_theory_report.h
/// Everything that the closed forms say about one drop: Gamma from a critical diameter, or the
/// critical diameter from Gamma, by every route of physics/kat/kat_theory.h.
/// Tests: tests/analysis/kat/kat_theory_report_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/kat/theory/thesis_values.h"
#include "physics/contact/material.h"

namespace powderlink::analysis {

struct KatTheoryInput {
  physics::Material particle;
  physics::Material substrate;
  double impact_velocity_m_s = 0.0;
  std::optional<double> critical_diameter_um{};  ///< one of the two
  std::optional<double> adhesive_energy_J_m2{};
};

struct Quantity {
  std::string name;  ///< for JSON, with the unit as suffix
  std::string label;
  double value;
  std::string unit;
  std::string note;
};

struct KatTheoryReport {
  std::vector<Quantity> contact;  ///< moduli, mass, pull-off, a0, period, Tabor parameter
  std::vector<Quantity> answers;  ///< Gamma or d_c, one per route
  std::string adhesion_theory;    ///< JKR, DMT or Maugis-Dugdale, by the Tabor parameter
  const ThesisValue* thesis = nullptr;
};

/// Throws InvalidInput unless velocity > 0 and exactly one of diameter and energy is given and > 0.
KatTheoryReport kat_theory_report(const KatTheoryInput& input);

}  // namespace powderlink::analysis
