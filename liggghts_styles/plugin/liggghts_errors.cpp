// SPDX-License-Identifier: GPL-3.0-or-later
/// LIGGGHTS calls its Error class through the dynamic linker. These definitions, in the program itself,
/// come first: they keep the text and hand over.
#include "plugin/liggghts_errors.h"

#include <dlfcn.h>

#include "compute.h"
#include "error.h"
#include "fix.h"

namespace powderlink::plugin {

namespace {

std::string& kept() {
  static std::string text;
  return text;
}

void keep(const char* who, const char* text, const char* file, int line) {
  kept() = std::string(who == nullptr ? "" : who) + (who == nullptr ? "" : ": ") + text + " (" +
           file + ":" + std::to_string(line) + ")";
}

template <class Function>
Function next(const char* symbol) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, symbol));
}

}  // namespace

std::string last_liggghts_error() {
  return "LIGGGHTS: " + (kept().empty() ? std::string("ended early; see its log") : kept());
}

}  // namespace powderlink::plugin

namespace LAMMPS_NS {

namespace plugin = powderlink::plugin;

void Error::all(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error3allEPKciS2_");
  plugin::keep(nullptr, text, file, line);
  next(this, file, line, text);
}

void Error::one(const char* file, int line, const char* text) {
  using Function = void (*)(Error*, const char*, int, const char*);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error3oneEPKciS2_");
  plugin::keep(nullptr, text, file, line);
  next(this, file, line, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* text) {
  using Function = void (*)(Error*, const char*, int, Fix*, const char*);
  static const auto next = plugin::next<Function>("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_");
  plugin::keep(fix->style, text, file, line);
  next(this, file, line, fix, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* style, const char* text) {
  using Function = void (*)(Error*, const char*, int, Fix*, const char*, const char*);
  static const auto next =
      plugin::next<Function>("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_S2_");
  plugin::keep(style, text, file, line);
  next(this, file, line, fix, style, text);
}

void Error::compute_error(const char* file, int line, Compute* compute, const char* text) {
  using Function = void (*)(Error*, const char*, int, Compute*, const char*);
  static const auto next =
      plugin::next<Function>("_ZN9LAMMPS_NS5Error13compute_errorEPKciPNS_7ComputeES2_");
  plugin::keep(compute->style, text, file, line);
  next(this, file, line, compute, text);
}

}  // namespace LAMMPS_NS
