// SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_radii.h
/// Table of contact radii of grains at rest: CSV with the columns
///   contact_radius_um   edge of the contact, read from the first ring
///   radius_um           of the grain
///   wavelength_nm       of the light
/// Errors: InvalidInput with file, line and column. Tests: tests/analysis/kat/gamma_methods_test.cpp
#pragma once

#include <filesystem>
#include <vector>

#include "analysis/kat/experiment/kat_drop.h"

namespace powderlink::analysis {

std::vector<ContactRadius> read_contact_radii(const std::filesystem::path& file);

}  // namespace powderlink::analysis
