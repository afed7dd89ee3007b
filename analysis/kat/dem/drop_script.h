// SPDX-License-Identifier: GPL-3.0-or-later
/// \file drop_script.h
/// The LIGGGHTS input script of one drop: a size-graded population under one plate, as a user would
/// write it. Pure text; nothing is run here.
/// Units: SI. Tests: tests/analysis/kat/drop_script_test.cpp
#pragma once

#include <string>
#include <vector>

#include "analysis/kat/study/study.h"

namespace powderlink::analysis {

struct DropScript {
  std::string title;
  physics::Material particle;
  physics::Material substrate;
  double work_of_adhesion_J_m2 = 0.0;
  double impact_velocity_m_s = 0.0;
  std::vector<EffectChoice> effects;
  KatOptions options;
  double smallest_diameter_m = 0.0;  ///< of the population
  double largest_diameter_m = 0.0;
};

inline constexpr const char* kScriptFile = "in.kat";
inline constexpr const char* kResultsFile = "kat_results.json";
inline constexpr const char* kPlateFile = "plate.stl";

/// Throws InvalidInput for sizes that are not 0 < smallest < largest.
std::string drop_script(const DropScript& drop);

/// The plate as an STL surface, for scripts with a mesh wall.
std::string plate_stl(const DropScript& drop);

}  // namespace powderlink::analysis
