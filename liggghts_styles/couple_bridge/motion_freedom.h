// SPDX-License-Identifier: GPL-3.0-or-later
/// \file motion_freedom.h
/// What the script leaves of a particle's motion to forces: the gas may change that part of a velocity
/// only. The rest stays as it is, whatever holds the particle takes the force.
///
///   dv = P dv_free     P = product of the projections of all fixes that act on the particle
///
/// | fix                            | P                                                              |
/// |--------------------------------|----------------------------------------------------------------|
/// | none that integrates           | 0                                                              |
/// | nve/noforce, freeze            | 0                                                              |
/// | setforce                       | 0 along each component that is not NULL, within its region      |
/// | move                           | 0 along each component that it prescribes                       |
/// | enforce2d                      | 0 along z, for spins along x and y                              |
/// | lineforce, planeforce          | on the line, on the plane                                       |
/// | any other that integrates      | 1                                                              |
///
/// Spins are free where fix nve/sphere (or a style that is not LIGGGHTS's own) integrates, nve and
/// nve/limit leave them alone. Fixes are looked at when a run begins, groups and regions in each step.
/// Source: LIGGGHTS 3.8.0, Fix::time_integrate and the fixes of the table.
/// Tests: tests/liggghts_styles/couple_bridge_held_test.cpp
#pragma once

#include <vector>

#include "fix.h"
#include "lammps.h"

namespace powderlink::host {

struct Freedom {
  double velocity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< P
  double spin[3] = {1, 1, 1};                                 ///< of each component

  bool is_none() const;
};

class MotionFreedom {
 public:
  explicit MotionFreedom(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// Collective. \param groupbit  of the particles that will be asked for
  /// Throws InvalidInput for a fix whose effect on the gas's part cannot be known.
  void read_fixes(int groupbit);

  /// Nothing is held of an atom with this mask.
  bool is_whole(int mask) const { return (mask & binding_) == 0 && (mask & moving_) != 0; }
  Freedom of(int i) const;
  /// No fix of the script moves or holds an atom with this mask.
  bool is_forgotten(int mask) const { return (mask & known_) == 0; }

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  // Bits of groups
  int moving_ = 0;   ///< integrated, spins too
  int gliding_ = 0;  ///< integrated without spins
  int binding_ = 0;  ///< of the fixes below
  int known_ = 0;
  std::vector<const LAMMPS_NS::Fix*> bonds_;  ///< in the order in which they act
};

}  // namespace powderlink::host
