// SPDX-License-Identifier: GPL-3.0-or-later
/// \file session_log.h
/// What a device sends, as a file that grows line by line: FILE.part, renamed to FILE at the end. A
/// program that is interrupted leaves FILE.part with all lines that came until then.
/// Errors: InvalidInput for a folder or disk that takes no more, and for lines of an interrupted
/// session that would be lost. Tests: tests/analysis/kat/kat_device_live_test.cpp
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace powderlink::analysis {

class SessionLog {
 public:
  /// \param replace  FILE.part of an earlier session
  SessionLog(std::filesystem::path file, bool replace);
  void take(const std::string& line);
  void finish();  ///< no file when no line came

 private:
  std::filesystem::path file_, part_;
  std::ofstream out_;
  bool empty_ = true;
};

}  // namespace powderlink::analysis
