// SPDX-License-Identifier: GPL-3.0-or-later
/// \file plate_contacts.h
/// Looks up whether a grain sticks to a wall: sqrt(contact radius) in the contact history of `jkr`.
/// Tests: tests/liggghts_styles/kat_drop_test.cpp
#pragma once

#include <string>

#include "fix_wall_gran.h"

namespace powderlink::host {

class PlateContacts {
 public:
  /// Stops all ranks with a message when the wall does not exist or is not of model jkr.
  PlateContacts(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* asker, const std::string& wall_id);

  LAMMPS_NS::FixWallGran& wall() const { return *wall_; }
  int plate_type() const;

  /// sqrt(a) of local atom i on the wall; the largest if it touches several triangles, 0 if none.
  double root(int i) const;

 private:
  LAMMPS_NS::FixWallGran* wall_ = nullptr;
  LAMMPS_NS::FixPropertyAtom* primitive_history_ = nullptr;
  int offset_ = -1;
};

}  // namespace powderlink::host
