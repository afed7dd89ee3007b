// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/files/write_file.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw InvalidInput("writing a file", file.string(),
                     "a file in an existing folder that may be written",
                     "make the folder, or name another file");
}

}  // namespace

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0 || std::filesystem::is_directory(file))
    refuse(file);
}

void write_file(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path beside = file.string() + ".part" + std::to_string(::getpid());
  std::ofstream out(beside, std::ios::binary);
  out << content;
  out.close();
  std::error_code problem;
  if (out) std::filesystem::rename(beside, file, problem);
  if (!out || problem) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    refuse(file);
  }
}

}  // namespace powderlink
