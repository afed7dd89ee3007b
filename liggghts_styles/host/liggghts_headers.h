// SPDX-License-Identifier: GPL-3.0-or-later
/// \file liggghts_headers.h
/// The LIGGGHTS headers of a contact model, in the only order in which they compile.
#pragma once

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <mpi.h>

// clang-format off
#include "lammps.h"
#include "pair.h"
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
#include "fix_mesh_surface.h"
#include "tri_mesh.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "fix_insert_stream.h"  // before pair_gran_base.h, which uses it undeclared
#include "contact_models.h"
#include "granular_pair_style.h"
#include "granular_wall.h"
#include "pair_gran_base.h"
#include "fix_wall_gran_base.h"
#include "fix_contact_history_mesh.h"
// clang-format on
