// SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupling_fields.h
/// The fields of an unresolved CFD-DEM coupling: names, units and shapes that both hosts share.
/// One row per particle; SI. Both programs take them from here, so they cannot disagree by spelling.
/// Tests: tests/coupling/bridge/link_test.cpp
#pragma once

#include "coupling/bridge/frame/field.h"

namespace powderlink::bridge::fields {

// particles, to the solver
inline const FieldSpec id{"id", "1", scalar, ElementType::int64};
inline const FieldSpec position{"position", "m", vector3};
inline const FieldSpec velocity{"velocity", "m/s", vector3};
inline const FieldSpec spin{"spin", "rad/s", vector3};
/// 0: the particle has vanished since the last exchange. Its row brings the rest of its impulse, with
/// its place of the last exchange; the values that come back for it mean nothing.
inline const FieldSpec radius{"radius", "m", scalar};
inline const FieldSpec density{"density", "kg/m3", scalar};
/// 1: no force changes the velocity of the particle (frozen, moved by prescription); else 0.
inline const FieldSpec held{"held", "1", scalar};
/// Impulse of the reacting forces on the particle since the last exchange, less what its added mass
/// has gained, by whatever force.
inline const FieldSpec reaction_impulse{"reaction_impulse", "N s", vector3};

// values at the particles, to the DEM
inline const FieldSpec fluid_velocity{"fluid_velocity", "m/s", vector3};
inline const FieldSpec fluid_fraction{"fluid_fraction", "1", scalar};
/// K of the drag K (u - v).
inline const FieldSpec drag_coefficient{"drag_coefficient", "kg/s", scalar};
/// Explicit forces whose opposite goes into the fluid.
inline const FieldSpec reacting_force{"reacting_force", "N", vector3};
/// Explicit forces of the fluid's stress and of buoyancy: no source in the fluid.
inline const FieldSpec pressure_force{"pressure_force", "N", vector3};
// only with force laws that need them
inline const FieldSpec fluid_spin{"fluid_spin", "rad/s", vector3};  ///< curl(u)/2
inline const FieldSpec rotational_drag{"rotational_drag", "N m s", scalar};
inline const FieldSpec fluid_torque{"fluid_torque", "N m", vector3};
inline const FieldSpec added_mass{"added_mass", "kg", scalar};

}  // namespace powderlink::bridge::fields
