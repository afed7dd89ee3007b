// SPDX-License-Identifier: GPL-3.0-or-later
/// \file steel_drop.h
/// The drop that several tests start from: 316L on UPVC at 1.4 m/s.
#pragma once

#include "analysis/kat/dem/drop_script.h"
#include "analysis/kat/study/material_library.h"

namespace powderlink::analysis {

inline DropScript steel_drop() {
  DropScript d;
  d.title = "test, row 1";
  d.particle = find_material("316L");
  d.substrate = find_material("UPVC");
  d.work_of_adhesion_J_m2 = 17.175;
  d.impact_velocity_m_s = 1.4;
  d.smallest_diameter_m = 40e-6;
  d.largest_diameter_m = 60e-6;
  return d;
}

}  // namespace powderlink::analysis
