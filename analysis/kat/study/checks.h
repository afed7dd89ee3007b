// SPDX-License-Identifier: GPL-3.0-or-later
/// \file checks.h
/// Values that users type, refused with a hint at the unit that was probably meant.
/// Each returns its value or throws InvalidInput; `where` names file and line, option or key.
/// Tests: tests/analysis/kat/measurements_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink::analysis {

double require_velocity_m_s(double value, const std::string& where);          ///< > 0, below 1000
double require_diameter_um(double value, const std::string& where);           ///< 0.01 to 10 000
double require_contact_time_us(double value, const std::string& where);       ///< 0.01 to 100 000
double require_adhesive_energy_J_m2(double value, const std::string& where);  ///< > 0

/// What tests of this kind have; other values are possible, and doubtful when all of a table are.
struct UsualRange {
  double low, high;
  const char* unit;
  const char* larger_unit;   ///< a thousand of `unit`
  const char* smaller_unit;  ///< a thousandth
};
inline constexpr UsualRange kUsualDiameter{1.0, 1000.0, "um", "mm", "nm"};  // powders under a light
                                                                            // microscope
inline constexpr UsualRange kUsualVelocity{0.01, 50.0, "m/s", "km/s", "mm/s"};
inline constexpr UsualRange kUsualContactTime{1.0, 1e4, "us", "ms", "ns"};

/// "all values lie below 1 um: were mm given where um are meant? ...", or nothing: when all values are
/// outside the range on one side, and a factor of 1000 would bring their middle into it.
std::string unit_question(std::vector<double> values, const UsualRange& usual);

/// The same where some of the values lie a thousand away from all others, and among them by a factor of
/// 1000: rows of a table in two units.
std::string mixed_unit_question(std::vector<double> values, const UsualRange& usual);

/// Text for stderr when Gamma is above what dry solids reach, else empty.
std::string adhesive_energy_warning(double adhesive_energy_J_m2, const std::string& where);

}  // namespace powderlink::analysis
