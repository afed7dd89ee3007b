// SPDX-License-Identifier: GPL-3.0-or-later
/// Functions of LIGGGHTS that it calls through the dynamic linker. The definitions here come first, as this
/// library is linked before LIGGGHTS's or is in LD_PRELOAD.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <mpi.h>

#include <boost/lexical_cast.hpp>

#include "input.h"
#include "lammps.h"
#include "pointers.h"

#include "liggghts_styles/host/stop_all.h"
#include "liggghts_styles/plugin/mpi_process.h"
#include "liggghts_styles/plugin/styles.h"

namespace LAMMPS_NS {

/// The constructor and the command `clear` make all tables of styles here.
void LAMMPS::create() {
  using Function = void (*)(LAMMPS*);
  static const auto next =
      reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS6createEv"));
  if (next == nullptr) {
    std::fputs(
        "powderlink preload: LAMMPS_NS::LAMMPS::create(); given: not found in this program; "
        "allowed: LIGGGHTS 3.8 linked to libliggghts.so; to do: use liggghts-powderlink\n",
        stderr);
    std::exit(1);
  }
  next(this);
  powderlink::plugin::register_styles(this);
}

/// LIGGGHTS's own leaves with the status of an error, and its fixes as they are.
void Input::quit() {
  constexpr int largest = 255;
  int status = 0;
  if (narg > 1 || (narg == 1 && (!boost::conversion::try_lexical_convert(arg[0], status) ||
                                 status < 0 || status > largest))) {
    std::string given = "quit";
    for (int i = 0; i < narg; ++i) given += std::string(" ") + arg[i];
    powderlink::host::stop_all(lmp, FLERR, nullptr,
                               "command quit; given: " + given +
                                   "; allowed: quit [STATUS], a whole number from 0 to 255; "
                                   "to do: correct the line");
  }
  powderlink::plugin::end_by_quit(lmp, status);
}

}  // namespace LAMMPS_NS
