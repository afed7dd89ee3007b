// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/plugin/styles.h"

#include <map>
#include <string>

#include <mpi.h>

#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"

#include "liggghts_styles/contact/fix_adhesion_effect.h"
#include "liggghts_styles/couple_bridge/fix_couple_bridge.h"
#include "liggghts_styles/host/private_access.h"
#include "liggghts_styles/host/read_restart_command.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"
#include "liggghts_styles/kat_drop/kat_run_command.h"
#include "liggghts_styles/plugin/contact_models.h"

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);
POWDERLINK_PRIVATE_MEMBER(FixMap, LAMMPS_NS::Modify, fix_map, std::map<std::string, FixCreator>*)
POWDERLINK_PRIVATE_MEMBER(CommandMap, LAMMPS_NS::Input, command_map,
                          std::map<std::string, CommandCreator>*)

namespace powderlink::plugin {

namespace {

using namespace LAMMPS_NS;

template <class Style>
Fix* make_fix(LAMMPS* lmp, int narg, char** arg) {
  return new Style(lmp, narg, arg);
}

}  // namespace

void register_styles(LAMMPS* lmp) {
  register_contact_models();
  auto& fixes = *(lmp->modify->*pointer_to(host::FixMap()));
  fixes["adhesion/effect"] = &make_fix<host::FixAdhesionEffect>;
  fixes[host::FixCoupleBridge::kStyle] = &make_fix<host::FixCoupleBridge>;
  fixes["kat/drop"] = &make_fix<host::FixKatDrop>;
  auto& commands = *(lmp->input->*pointer_to(host::CommandMap()));
  commands["kat/run"] = &host::kat_run_command;
  commands["read_restart"] = &host::read_restart_command;
}

const char* help() {
  return "\npowderlink styles (docs/reference.md):\n"
         "  pair_style gran / fix wall/gran   model jkr [tangential off|no_history|history]\n"
         "                                    [rolling_friction off|cdt|epsd2] "
         "[tangential_damping on|off]\n"
         "  fix property/global               workOfAdhesion peratomtypepair N ...   [J/m^2]\n"
         "  fix kat/drop                      Kinetic Adhesion Test: settle, fall, stop, detach\n"
         "  fix adhesion/effect               one effect of 'powderlink effects'\n"
         "  fix couple/bridge every N         gas around the particles, from powderFoam\n"
         "  kat/run FIX-ID                    runs until the test of that fix is over\n";
}

}  // namespace powderlink::plugin
