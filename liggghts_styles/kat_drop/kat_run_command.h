// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_run_command.h
/// `kat/run FIX-ID`: runs until the Kinetic Adhesion Test of that fix kat/drop is over.
/// Tests: tests/liggghts_styles/kat_drop_test.cpp, tests/liggghts_styles/script_loops_test.cpp
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace powderlink::host {

void kat_run_command(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

}  // namespace powderlink::host
