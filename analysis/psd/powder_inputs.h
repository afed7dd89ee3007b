// SPDX-License-Identifier: GPL-3.0-or-later
/// \file powder_inputs.h
/// A fitted law as input of the host programs.
///   LIGGGHTS  particletemplate/sphere per class, particledistribution/discrete/numberbased; the
///             classes part the cut-off law by number into equal widths, each with its middle
///   OpenFOAM  sizeDistribution of type RosinRammler. It draws
///             d = minValue + d (-ln(1 - y K))^(1/n): its origin is minValue, so x0 and n of the
///             textbook's law would be wrong there; written are those that were fitted to its own form
/// Tests: tests/psd/powder_inputs_test.cpp, tests/psd/psd_command_test.cpp
#pragma once

#include <string>

#include "analysis/psd/psd_report.h"

namespace powderlink::analysis {

/// Both throw when no cut-off law was found.
std::string liggghts_powder(const PsdReport& report, double density_kg_m3, int classes);
std::string openfoam_sizes(const PsdReport& report);

}  // namespace powderlink::analysis
