// SPDX-License-Identifier: GPL-3.0-or-later
/// \file materials.h
/// The solids of the LIGGGHTS tests; figures as in physics/contact/materials.def.
#pragma once

#include "physics/contact/material.h"

namespace powderlink::testing {

inline const physics::Material steel{"316L", 7980.0, 2.11e11, 0.3};
inline const physics::Material glass{"borosilicate_glass", 2510.0, 7.3e10, 0.2};
inline const physics::Material upvc{"UPVC", 1440.0, 3.0e9, 0.3};

}  // namespace powderlink::testing
