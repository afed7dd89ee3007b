// SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_files.h
/// Folders that vanish, and refusals whose text is checked.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/invalid_input.h"

namespace powderlink::analysis {

class TestFolder {
 public:
  TestFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("powderlink_test_" + std::to_string(::getpid()) + "_" + std::to_string(++count));
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The call must throw InvalidInput with all four parts, and its text must hold every fragment.
template <class Call>
void expect_refusal(const Call& call, const std::vector<std::string>& fragments) {
  try {
    call();
    ADD_FAILURE() << "accepted";
  } catch (const InvalidInput& e) {
    const std::string text = e.what();
    for (const char* part : {"; given: ", "; allowed: ", "; to do: "}) {
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
    for (const std::string& fragment : fragments) {
      EXPECT_NE(text.find(fragment), std::string::npos)
          << "'" << fragment << "' is not in: " << text;
    }
  }
}

}  // namespace powderlink::analysis
