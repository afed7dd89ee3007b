// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/kat_drop/kat_run_command.h"

#include <string>

#include "input.h"
#include "lammps.h"
#include "liggghts_styles/host/stop_all.h"
#include "liggghts_styles/kat_drop/fix_kat_drop.h"
#include "modify.h"
#include "signal_handling.h"

namespace powderlink::host {

using namespace LAMMPS_NS;

void kat_run_command(LAMMPS* lmp, int narg, char** arg) {
  auto* test = narg == 1 ? dynamic_cast<FixKatDrop*>(lmp->modify->find_fix_id(arg[0])) : nullptr;
  if (test == nullptr) {
    const std::string given =
        narg == 1 ? std::string("'") + arg[0] + "'" : std::to_string(narg) + " words";
    const std::string message =
        "kat/run; given: " + given +
        "; allowed: the ID of a fix kat/drop defined above; to do: kat/run ID";
    stop_all(lmp, FLERR, nullptr, message);
  }
  bool first = true;
  while (!test->finished() && !SignalHandler::request_quit) {
    // The settling time is not known before; the rest is, and runs in one piece.
    const std::string run = "run " + std::to_string(test->next_chunk_steps()) +
                            (first ? " post no" : " pre no post no");
    lmp->input->one(run.c_str());
    first = false;
  }
}

}  // namespace powderlink::host
