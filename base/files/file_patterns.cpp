// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/files/file_patterns.h"

#include <glob.h>

#include <set>

#include "base/invalid_input.h"

namespace powderlink {

namespace fs = std::filesystem;

std::vector<fs::path> expand_patterns(const std::vector<std::string>& patterns,
                                      const std::string& what) {
  std::vector<fs::path> files;
  std::set<fs::path> seen;
  const auto add = [&](const fs::path& file) {
    if (seen.insert(fs::weakly_canonical(file)).second) files.push_back(file);
  };
  for (const std::string& pattern : patterns) {
    if (fs::exists(pattern)) {  // a name may hold brackets
      add(pattern);
      continue;
    }
    glob_t found{};
    const int status = ::glob(pattern.c_str(), 0, nullptr, &found);
    for (std::size_t i = 0; i < found.gl_pathc; ++i) add(found.gl_pathv[i]);
    ::globfree(&found);
    if (status != 0) {
      throw InvalidInput(what, pattern,
                         "a file, or a pattern with *, ? or [..] that fits at least one",
                         "check path and pattern; quote a pattern that the shell must not expand");
    }
  }
  return files;
}

}  // namespace powderlink
