// SPDX-License-Identifier: GPL-3.0-or-later
/// \file styles.h
/// Makes powderlink's fixes and commands known to one LIGGGHTS instance.
/// Tests: tests/liggghts_styles/plugin_test.cpp
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace powderlink::plugin {

/// To be called after the instance exists and before it reads its input.
void register_styles(LAMMPS_NS::LAMMPS* lmp);

/// Text that `liggghts-powderlink -h` prints above LIGGGHTS's own help.
const char* help();

}  // namespace powderlink::plugin
