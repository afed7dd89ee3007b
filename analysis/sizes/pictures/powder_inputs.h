// SPDX-License-Identifier: GPL-3.0-or-later
/// \file powder_inputs.h
/// The measured sizes as input of the host programs.
///   LIGGGHTS  particletemplate/sphere per class, particledistribution/discrete/numberbased, whose
///             weights are shares by number (those of particledistribution/discrete are by mass)
///   OpenFOAM  sizeDistribution of type binned, which draws single sizes by their shares
/// Classes are those of powder_classes.h: shares by number and by mass are the sample's, whatever its
/// distribution. Where a law of Rosin and Rammler fits, it is offered in a comment; OpenFOAM's draws
/// d = minValue + d (-ln(1 - y K))^(1/n): its origin is minValue, so x0 and n of the textbook's law
/// would be wrong there, and what is offered was fitted to its own form.
/// Tests: tests/analysis/sizes/powder_inputs_test.cpp, tests/analysis/sizes/psd_command_test.cpp
#pragma once

#include <string>

#include "analysis/sizes/pictures/psd_report.h"

namespace powderlink::analysis {

std::string liggghts_powder(const PsdReport& report, double density_kg_m3, int classes);
std::string openfoam_sizes(const PsdReport& report);

}  // namespace powderlink::analysis
