// SPDX-License-Identifier: GPL-3.0-or-later
/// LIGGGHTS calls its Error class through the dynamic linker. These definitions come before LIGGGHTS's own:
/// they keep the text for whoever has to know why this program ends, and hand over.
#include <dlfcn.h>
#include <cstdio>

#include <mpi.h>

#include "compute.h"
#include "error.h"
#include "fix.h"

#include "liggghts_styles/host/last_error.h"

namespace powderlink::plugin {

namespace {

void keep(const char* who, const char* text, const char* file, int line) {
  host::keep_error(std::string("LIGGGHTS: ") + (who == nullptr ? "" : who) +
                   (who == nullptr ? "" : ": ") + text + " (" + file + ":" + std::to_string(line) +
                   ")");
}

/// LIGGGHTS's own function; the error is printed here where its name is not known.
template <class Function>
Function next(const char* symbol) {
  void* const found = dlsym(RTLD_NEXT, symbol);
  if (found == nullptr) {
    std::fprintf(stderr, "ERROR: %s\n", host::kept_error().c_str());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return reinterpret_cast<Function>(found);
}

}  // namespace

}  // namespace powderlink::plugin

namespace LAMMPS_NS {

namespace plugin = powderlink::plugin;

void Error::universe_all(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  plugin::keep(nullptr, text, file, line);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error12universe_allEPKciS2_");
  next(this, file, line, text);
}

void Error::universe_one(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  plugin::keep(nullptr, text, file, line);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error12universe_oneEPKciS2_");
  next(this, file, line, text);
}

void Error::all(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  plugin::keep(nullptr, text, file, line);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error3allEPKciS2_");
  next(this, file, line, text);
}

void Error::one(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  plugin::keep(nullptr, text, file, line);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error3oneEPKciS2_");
  next(this, file, line, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* text) {
  using Function = void (*)(Error*, const char*, int, Fix*, const char*);
  plugin::keep(fix->style, text, file, line);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_");
  next(this, file, line, fix, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* style, const char* text) {
  using Function = void (*)(Error*, const char*, int, Fix*, const char*, const char*);
  plugin::keep(style, text, file, line);
  static const auto next =
      plugin::next<Function>("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_S2_");
  next(this, file, line, fix, style, text);
}

void Error::compute_error(const char* file, int line, Compute* compute, const char* text) {
  using Function = void (*)(Error*, const char*, int, Compute*, const char*);
  plugin::keep(compute->style, text, file, line);
  static const auto next =
      plugin::next<Function>("_ZN9LAMMPS_NS5Error13compute_errorEPKciPNS_7ComputeES2_");
  next(this, file, line, compute, text);
}

}  // namespace LAMMPS_NS
