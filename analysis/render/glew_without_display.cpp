// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/glew_without_display.h"

#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) unsigned int glewInit() {
  constexpr unsigned int kOk = 0, kNoVersion = 1, kNoDisplay = 4;  // GLEW_ERROR_NO_GLX_DISPLAY
  using Function = unsigned int (*)();
  static const auto library_version = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glewInit"));
  if (library_version == nullptr) return kNoVersion;
  const unsigned int result = library_version();
  return result == kNoDisplay ? kOk : result;
}

namespace powderlink::render {
void accept_glew_without_display() {}
}  // namespace powderlink::render
