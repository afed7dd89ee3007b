// SPDX-License-Identifier: GPL-3.0-or-later
/// \file read_restart_command.h
/// `read_restart FILE` of LIGGGHTS, once it is known that the file is whole (liggghts_styles/host/restart_file.h). Of a
/// file that breaks off LIGGGHTS itself makes particles of what is in its memory, or waits for ever.
/// Tests: tests/liggghts_styles/restart_file_test.cpp
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace powderlink::host {

void read_restart_command(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

}  // namespace powderlink::host
