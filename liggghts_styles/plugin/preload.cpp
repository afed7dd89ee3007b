// SPDX-License-Identifier: GPL-3.0-or-later
/// LD_PRELOAD=libpowderlink_styles.so liggghts -in in.script
///
/// The stock program calls Input::file() once, through the dynamic linker, when LIGGGHTS is built
/// and before it reads the script. This definition comes first, registers the styles and hands
/// over.
#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>
#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "pointers.h"

#include "host/private_access.h"
#include "plugin/styles.h"

POWDERLINK_PRIVATE_MEMBER(Instance, LAMMPS_NS::Pointers, lmp, LAMMPS_NS::LAMMPS*)

namespace LAMMPS_NS {

void Input::file() {
  using Function = void (*)(Input*);
  static const auto next =
      reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS5Input4fileEv"));
  if (next == nullptr) {
    std::fputs(
        "powderlink preload: LAMMPS_NS::Input::file(); given: not found in this program; "
        "allowed: LIGGGHTS 3.8 linked to libliggghts.so; to do: use liggghts-powderlink\n",
        stderr);
    std::exit(1);
  }
  auto* pointers = static_cast<Pointers*>(this);
  powderlink::plugin::register_styles(pointers->*pointer_to(powderlink::host::Instance()));
  next(this);
}

}  // namespace LAMMPS_NS
