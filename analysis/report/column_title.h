// SPDX-License-Identifier: GPL-3.0-or-later
/// \file column_title.h
/// A column of a table as a reader wants to see it: "gamma_energy_J_m2" is "Γ energy (J/m²)" at an axis
/// and "Γ energy" in a sentence.
/// Errors: none; a name without a known unit keeps all its words.
/// Tests: tests/analysis/report/page_test.cpp
#pragma once

#include <string>

namespace powderlink::analysis {

std::string column_words(const std::string& name);
std::string column_title(const std::string& name);

}  // namespace powderlink::analysis
