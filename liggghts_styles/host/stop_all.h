// SPDX-License-Identifier: GPL-3.0-or-later
/// \file stop_all.h
/// Ends the run on all ranks with one message, exit status 1.
///
/// LIGGGHTS's Error::fix_error() prints a string that it has freed before (3.8.0, error.cpp); this
/// goes through Error::all() with the same words.
#pragma once

#include <cstdlib>
#include <string>

#include "error.h"
#include "fix.h"
#include "lammps.h"

namespace powderlink::host {

/// To be called by all ranks. \param where file and line, LIGGGHTS's FLERR
[[noreturn]] inline void stop_all(LAMMPS_NS::LAMMPS* lmp, const char* file, int line,
                                  const LAMMPS_NS::Fix* fix, const std::string& message) {
  const std::string text =
      fix == nullptr ? message
                     : std::string("Fix ") + fix->style + " (id " + fix->id + "): " + message;
  lmp->error->all(file, line, text.c_str());
  std::abort();  // not reached
}

}  // namespace powderlink::host
