// SPDX-License-Identifier: GPL-3.0-or-later
/// \file temporary_folder.h
/// A folder that goes with the object. Its path is short enough for Unix sockets.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace powderlink::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = "/tmp/powderlink_bridge_XXXXXX";
    if (!mkdtemp(name.data())) throw std::runtime_error("mkdtemp failed");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace powderlink::test
