// SPDX-License-Identifier: GPL-3.0-or-later
/// \file study_material.h
/// A material as studies and options give it: a known name, or its values.
///
///   a table      material = NAME, or density_kg_m3, youngs_modulus_Pa and poissons_ratio
///   an option    NAME, or "density_kg_m3=.., youngs_modulus_Pa=.., poissons_ratio=..", or FILE.toml: a
///                file with these keys, or a study, of which the table of the option's name is taken
///
/// Errors: InvalidInput with file or option and key. Tests: tests/analysis/kat/study_material_test.cpp
#pragma once

#include <string>

#include "base/toml/strict_table.h"
#include "physics/contact/material.h"

namespace powderlink::analysis {

/// Keys of a table of a material.
const std::vector<std::string>& material_keys();

physics::Material read_material(const StrictTable& table);

/// \param which  "particle" or "substrate", the option's name
physics::Material material_option(const std::string& given, const std::string& which);

/// For the help of such an option.
std::string material_option_help();

/// The table of a study: by name when the material is the known one of this name, else its values.
std::string material_text(const std::string& table, const physics::Material& material);

/// By value, whatever they are called; to the digits that material_text() writes.
bool same_material(const physics::Material& a, const physics::Material& b);

/// "316L (7980 kg/m^3, 2.11e+11 Pa, 0.3)"
std::string material_words(const physics::Material& material);

}  // namespace powderlink::analysis
