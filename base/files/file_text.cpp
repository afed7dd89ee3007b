// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/files/file_text.h"

#include <fstream>
#include <sstream>

#include "base/invalid_input.h"

namespace powderlink {

std::string file_text_or_empty(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string file_text(const std::filesystem::path& file) {
  if (!std::ifstream(file, std::ios::binary) || std::filesystem::is_directory(file)) {
    throw InvalidInput("reading " + file.string(), "a file that cannot be opened",
                       "a file that exists and may be read", "check its name and rights");
  }
  return file_text_or_empty(file);
}

}  // namespace powderlink
