// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/motion_freedom.h"

#include <algorithm>
#include <string>

#include <mpi.h>

#include "atom.h"
#include "domain.h"
#include "fix_lineforce.h"
#include "fix_move.h"
#include "fix_planeforce.h"
#include "fix_setforce.h"
#include "modify.h"
#include "region.h"

#include "base/invalid_input.h"
#include "liggghts_styles/host/private_access.h"

POWDERLINK_PRIVATE_MEMBER(SetForceX, LAMMPS_NS::FixSetForce, xstyle, int)
POWDERLINK_PRIVATE_MEMBER(SetForceY, LAMMPS_NS::FixSetForce, ystyle, int)
POWDERLINK_PRIVATE_MEMBER(SetForceZ, LAMMPS_NS::FixSetForce, zstyle, int)
POWDERLINK_PRIVATE_MEMBER(SetForceRegion, LAMMPS_NS::FixSetForce, iregion, int)
POWDERLINK_PRIVATE_MEMBER(PlaneX, LAMMPS_NS::FixPlaneForce, xdir, double)
POWDERLINK_PRIVATE_MEMBER(PlaneY, LAMMPS_NS::FixPlaneForce, ydir, double)
POWDERLINK_PRIVATE_MEMBER(PlaneZ, LAMMPS_NS::FixPlaneForce, zdir, double)
POWDERLINK_PRIVATE_MEMBER(MoveStyle, LAMMPS_NS::FixMove, mstyle, int)
POWDERLINK_PRIVATE_MEMBER(LinearX, LAMMPS_NS::FixMove, vxflag, int)
POWDERLINK_PRIVATE_MEMBER(LinearY, LAMMPS_NS::FixMove, vyflag, int)
POWDERLINK_PRIVATE_MEMBER(LinearZ, LAMMPS_NS::FixMove, vzflag, int)
POWDERLINK_PRIVATE_MEMBER(WiggleX, LAMMPS_NS::FixMove, axflag, int)
POWDERLINK_PRIVATE_MEMBER(WiggleY, LAMMPS_NS::FixMove, ayflag, int)
POWDERLINK_PRIVATE_MEMBER(WiggleZ, LAMMPS_NS::FixMove, azflag, int)
POWDERLINK_PRIVATE_MEMBER(PlaceX, LAMMPS_NS::FixMove, xvarstr, char*)
POWDERLINK_PRIVATE_MEMBER(PlaceY, LAMMPS_NS::FixMove, yvarstr, char*)
POWDERLINK_PRIVATE_MEMBER(PlaceZ, LAMMPS_NS::FixMove, zvarstr, char*)
POWDERLINK_PRIVATE_MEMBER(SpeedX, LAMMPS_NS::FixMove, vxvarstr, char*)
POWDERLINK_PRIVATE_MEMBER(SpeedY, LAMMPS_NS::FixMove, vyvarstr, char*)
POWDERLINK_PRIVATE_MEMBER(SpeedZ, LAMMPS_NS::FixMove, vzvarstr, char*)

namespace powderlink::host {

using namespace LAMMPS_NS;

namespace {

void hold_component(int c, Freedom& freedom) {
  std::fill(freedom.velocity[c], freedom.velocity[c] + 3, 0.0);
}

void hold_spin(Freedom& freedom) { std::fill(freedom.spin, freedom.spin + 3, 0.0); }

void hold_all(Freedom& freedom) {
  for (int c = 0; c < 3; ++c) hold_component(c, freedom);
  hold_spin(freedom);
}

/// What is left along a direction (unit vector) is the share `along`, across it `across`.
void project(const double (&direction)[3], double along, double across, Freedom& freedom) {
  for (int column = 0; column < 3; ++column) {
    double dot = 0.0;
    for (int c = 0; c < 3; ++c) dot += direction[c] * freedom.velocity[c][column];
    for (int c = 0; c < 3; ++c) {
      double& p = freedom.velocity[c][column];
      p = across * p + (along - across) * dot * direction[c];
    }
  }
}

/// Components that fix move gives itself.
void find_prescribed(const FixMove& move, bool (&prescribed)[3]) {
  enum { kLinear, kWiggle, kRotate, kVariable };  // as in fix_move.cpp
  const auto is = [&](int c, bool value) { prescribed[c] = value; };
  switch (move.*pointer_to(MoveStyle())) {
    case kLinear:
      is(0, move.*pointer_to(LinearX()) != 0);
      is(1, move.*pointer_to(LinearY()) != 0);
      is(2, move.*pointer_to(LinearZ()) != 0);
      break;
    case kWiggle:
      is(0, move.*pointer_to(WiggleX()) != 0);
      is(1, move.*pointer_to(WiggleY()) != 0);
      is(2, move.*pointer_to(WiggleZ()) != 0);
      break;
    case kVariable:
      is(0, move.*pointer_to(PlaceX()) != nullptr || move.*pointer_to(SpeedX()) != nullptr);
      is(1, move.*pointer_to(PlaceY()) != nullptr || move.*pointer_to(SpeedY()) != nullptr);
      is(2, move.*pointer_to(PlaceZ()) != nullptr || move.*pointer_to(SpeedZ()) != nullptr);
      break;
    default:
      for (int c = 0; c < 3; ++c) is(c, true);
  }
}

/// What one fix leaves of the motion.
void bind(const Fix* fix, const double* x, const Domain& domain, Freedom& freedom) {
  const std::string style = fix->style;
  if (style == "setforce") {
    const auto& set = *static_cast<const FixSetForce*>(fix);
    const int region = set.*pointer_to(SetForceRegion());
    if (region >= 0 && domain.regions[region]->match(x[0], x[1], x[2]) == 0) return;
    if (set.*pointer_to(SetForceX()) != 0) hold_component(0, freedom);
    if (set.*pointer_to(SetForceY()) != 0) hold_component(1, freedom);
    if (set.*pointer_to(SetForceZ()) != 0) hold_component(2, freedom);
  } else if (style == "move") {
    bool prescribed[3];
    find_prescribed(*static_cast<const FixMove*>(fix), prescribed);
    for (int c = 0; c < 3; ++c) {
      if (prescribed[c]) hold_component(c, freedom);
    }
    hold_spin(freedom);
  } else if (style == "enforce2d") {
    hold_component(2, freedom);
    freedom.spin[0] = freedom.spin[1] = 0.0;
  } else if (style == "lineforce") {
    double direction[3];
    const_cast<FixLineForce*>(static_cast<const FixLineForce*>(fix))->get_dir(direction);
    project(direction, 1.0, 0.0, freedom);
  } else if (style == "planeforce") {
    const auto& plane = *static_cast<const FixPlaneForce*>(fix);
    const double normal[3] = {plane.*pointer_to(PlaneX()), plane.*pointer_to(PlaneY()),
                              plane.*pointer_to(PlaneZ())};
    project(normal, 0.0, 1.0, freedom);
  } else {  // freeze
    hold_all(freedom);
  }
}

bool is_bond(const std::string& style) {
  return style.rfind("freeze", 0) == 0 || style == "setforce" || style == "move" ||
         style == "enforce2d" || style == "lineforce" || style == "planeforce";
}

/// Its force on one particle depends on those of all others, which do not have the gas's.
void refuse_average(LAMMPS* lmp, const Fix* fix, int groupbit) {
  int shared = 0;
  for (int i = 0; i < lmp->atom->nlocal; ++i) {
    const int mask = lmp->atom->mask[i];
    if ((mask & groupbit) != 0 && (mask & fix->groupbit) != 0) shared = 1;
  }
  MPI_Allreduce(MPI_IN_PLACE, &shared, 1, MPI_INT, MPI_MAX, lmp->world);
  if (shared == 0) return;
  throw InvalidInput("fix that gives particles their mean force",
                     std::string("fix ") + fix->id + " aveforce on coupled particles",
                     "fixes that act on each particle by itself: "
                     "the gas's force is not part of that mean",
                     "remove it, or leave its particles out of the group of fix couple/bridge");
}

}  // namespace

bool Freedom::is_none() const {
  for (const double(&row)[3] : velocity) {
    for (const double p : row) {
      if (p != 0.0) return false;
    }
  }
  return true;
}

void MotionFreedom::read_fixes(int groupbit) {
  moving_ = gliding_ = binding_ = known_ = 0;
  bonds_.clear();
  for (int i = 0; i < lmp_->modify->nfix; ++i) {
    const Fix* fix = lmp_->modify->fix[i];
    const std::string style = fix->style;
    if (style == "aveforce") refuse_average(lmp_, fix, groupbit);
    if (is_bond(style)) {
      bonds_.push_back(fix);
      binding_ |= fix->groupbit;
    }
    if (fix->time_integrate != 0 || style.rfind("freeze", 0) == 0) known_ |= fix->groupbit;
    if (fix->time_integrate == 0 || style == "nve/noforce") continue;
    (style == "nve" || style == "nve/limit" || style == "move" ? gliding_ : moving_) |=
        fix->groupbit;
  }
}

Freedom MotionFreedom::of(int i) const {
  const int mask = lmp_->atom->mask[i];
  Freedom freedom;
  if ((mask & (moving_ | gliding_)) == 0) hold_all(freedom);
  if ((mask & moving_) == 0) hold_spin(freedom);
  if ((mask & binding_) == 0) return freedom;
  for (const Fix* fix : bonds_) {
    if ((mask & fix->groupbit) != 0) bind(fix, lmp_->atom->x[i], *lmp_->domain, freedom);
  }
  return freedom;
}

}  // namespace powderlink::host
