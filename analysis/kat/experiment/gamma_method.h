// SPDX-License-Identifier: GPL-3.0-or-later
/// \file gamma_method.h
/// A way from a drop to the work of adhesion Gamma of the interface. To add one: a header in methods/
/// with a class as in methods/energy.h, one line in gamma_methods.def, and a closed form in
/// tests/analysis/kat/gamma_methods_test.cpp. Command line, JSON and tables then know it.
///
/// The interval combines those of the measured values: for each the change of ln Gamma from end to end,
/// in quadrature (independent errors).
/// Tests: tests/analysis/kat/gamma_methods_test.cpp
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/kat/experiment/kat_drop.h"

namespace powderlink::analysis {

struct GammaMethodInfo {
  const char* name;        ///< in JSON
  const char* label;       ///< in tables
  const char* law;         ///< with its symbols
  const char* assumption;  ///< what must hold for the value to be Gamma
  const char* validity;
  const char* source;
  const char* needs;  ///< beside d_c, velocity and materials; "" for nothing
};

/// Work of adhesion of the interface with its 95 % interval [J/m^2].
struct GammaEstimate {
  double value = 0.0, low = 0.0, high = 0.0;
  std::string note;  ///< numbers behind the value
  std::vector<std::string> warnings;
};

struct GammaMethod {
  const GammaMethodInfo* info;
  /// Empty when what it needs was not measured.
  std::function<std::optional<GammaEstimate>(const UncertainDrop&)> estimate;
};

const std::vector<GammaMethod>& gamma_methods();

/// The interval of a law that gives one value for one drop.
GammaEstimate propagated(const UncertainDrop& drop,
                         const std::function<double(const KatDrop&)>& gamma);

/// Period of the contact at rest, 2 pi sqrt(m/k) [s].
double contact_period_s(const KatDrop& drop, double adhesive_energy_J_m2);

}  // namespace powderlink::analysis
