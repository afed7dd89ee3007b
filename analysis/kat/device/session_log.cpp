// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/device/session_log.h"

#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

SessionLog::SessionLog(fs::path file, bool replace)
    : file_(std::move(file)), part_(file_.string() + ".part") {
  std::error_code absent;
  const auto bytes = fs::file_size(part_, absent);
  if (!replace && !absent && bytes > 0) {
    throw InvalidInput("--log", part_.string() + ", lines of a session that was interrupted",
                       "a name without such lines",
                       "rename it and read it as a log, or replace it with --force");
  }
  out_.open(part_, std::ios::binary | std::ios::trunc);
}

void SessionLog::take(const std::string& line) {
  empty_ = false;
  out_ << line << '\n' << std::flush;
  if (out_) return;
  throw InvalidInput("--log", part_.string() + ", to which nothing can be written",
                     "a file in a folder that may be written, on a disk with room",
                     "name another file; the device still holds its last drop (--do report)");
}

void SessionLog::finish() {
  out_.close();
  std::error_code problem;
  if (empty_) {
    fs::remove(part_, problem);
    return;
  }
  if (out_) fs::rename(part_, file_, problem);
  if (out_ && !problem) return;
  throw InvalidInput("--log", file_.string(), "a file that may be written",
                     "the lines that came are in " + part_.string());
}

}  // namespace powderlink::analysis
