// SPDX-License-Identifier: GPL-3.0-or-later
/// \file material_library.h
/// Materials known by name: the list of physics/contact/materials.def (density, Young's modulus, Poisson's
/// ratio in SI units, with their source there).
/// Tests: tests/analysis/kat/study_test.cpp, tests/analysis/kat/study_material_test.cpp
#pragma once

#include <string>
#include <vector>

#include "physics/contact/material.h"

namespace powderlink::analysis {

const std::vector<physics::Material>& known_materials();

/// Throws InvalidInput that lists the known names.
const physics::Material& find_material(const std::string& name);

/// "316L, borosilicate_glass, UPVC, ...": for help texts and messages.
std::string known_material_names();

}  // namespace powderlink::analysis
