// SPDX-License-Identifier: GPL-3.0-or-later
/// \file command_line.h
/// Runs the powderlink program as a user would.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/base/test_files.h"

namespace powderlink::analysis {

struct CommandResult {
  int status = 0;
  std::string out, err;
};

inline CommandResult powderlink(const std::string& arguments) {
  const TestFolder folder;
  const std::string base = (folder.path() / "text").string();
  const std::string line = std::string("'" POWDERLINK_PROGRAM "' ") + arguments + " >" + base +
                           ".out 2>" + base + ".err";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(base + ".out"),
          read_file(base + ".err")};
}

/// Refused with all four parts of the message, and this in it.
inline void expect_four_parts(const CommandResult& result, const std::string& fragment) {
  EXPECT_EQ(result.status, 1) << result.out;
  for (const std::string& part :
       {std::string("; given: "), std::string("; allowed: "), std::string("; to do: "), fragment}) {
    EXPECT_NE(result.err.find(part), std::string::npos) << part << " not in: " << result.err;
  }
}

}  // namespace powderlink::analysis
