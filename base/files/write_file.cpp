// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/files/write_file.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw InvalidInput(what, file.string(),
                     "a file in an existing folder that may be written, on a disk with room",
                     "make the folder or room (df -h), or name another file");
}

}  // namespace

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0 || std::filesystem::is_directory(file))
    refuse(file, "writing a file");
}

void write_file(const std::filesystem::path& file, const std::string& content,
                const std::string& what) {
  // Hidden, so that no pattern of a user's takes it for a result.
  const std::filesystem::path beside =
      file.parent_path() / ("." + file.filename().string() + ".part" + std::to_string(::getpid()));
  std::ofstream out(beside, std::ios::binary);
  out << content;
  out.close();
  std::error_code problem;
  if (out) std::filesystem::rename(beside, file, problem);
  if (!out || problem) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    refuse(file, what);
  }
}

}  // namespace powderlink
