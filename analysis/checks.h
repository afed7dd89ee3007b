// SPDX-License-Identifier: GPL-3.0-or-later
/// \file checks.h
/// Values that users type, refused with a hint at the unit that was probably meant.
/// Each returns its value or throws InvalidInput; `where` names file and line, option or key.
/// Tests: tests/analysis/measurements_test.cpp
#pragma once

#include <string>

namespace powderlink::analysis {

double require_velocity_m_s(double value, const std::string& where);          ///< > 0, below 1000
double require_diameter_um(double value, const std::string& where);           ///< 0.01 to 10 000
double require_contact_time_us(double value, const std::string& where);       ///< 0.01 to 100 000
double require_adhesive_energy_J_m2(double value, const std::string& where);  ///< > 0

/// Text for stderr when Gamma is above what dry solids reach, else empty.
std::string adhesive_energy_warning(double adhesive_energy_J_m2, const std::string& where);

}  // namespace powderlink::analysis
