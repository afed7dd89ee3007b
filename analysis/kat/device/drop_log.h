// SPDX-License-Identifier: GPL-3.0-or-later
/// \file drop_log.h
/// Drops out of lines of the KAT device, from a saved log or as they come.
/// A message goes from KAT1 to its checksum, wherever in a line it stands: terminals put times before it,
/// and lines run together. It belongs to a report when it has the report's field n; what a user's own
/// terminal echoed (`KAT1 drop*FB12`) has none. Other text and lines of `#` are somebody's notes. What
/// begins as a message and cannot be read is noted, and is the cause where a report has lost a line:
/// such a report, or one without beginning or end, is InvalidInput with file and line, or, where that
/// was asked for, a note, and the drop is left out.
/// Tests: tests/analysis/kat/kat_device_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kat_firmware/core/kat_drop.h"

namespace powderlink::analysis {

struct LoggedDrop {
  kat::Drop drop;
  std::string place;  ///< "monday.log, line 12": where it ends
};

class DropLog {
 public:
  DropLog(std::string name, bool skip_damaged)
      : name_(std::move(name)), skip_damaged_(skip_damaged) {}
  /// One line without its end. Throws for a damaged one unless those are skipped.
  void take(const std::string& line);
  /// No line follows: throws, or notes, when a drop is cut.
  void end();

  bool empty() const { return line_ == 0; }
  bool inside() const { return reader_.inside(); }  ///< a report has begun and not ended
  const std::vector<LoggedDrop>& drops() const { return drops_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Unreadable {
    int line = 0;
    std::string code, text, advice;
  };

  void take_message(const std::string& text);
  void unreadable(const std::string& text, kat::Code code);
  void broken(const std::string& what, const std::string& given);
  void damaged(int line, const std::string& what, const std::string& given,
               const std::string& to_do);
  void note_unreadable();

  std::string name_;
  bool skip_damaged_;
  int line_ = 0;
  bool spoiled_ = false;                // lines up to the next drop belong to one that is broken
  std::vector<Unreadable> unreadable_;  // since the last report began
  kat::DropReader reader_;
  std::vector<LoggedDrop> drops_;
  std::vector<std::string> notes_;
};

/// A line in quotes for a message: its beginning, other bytes than printable ASCII as `?`.
std::string printable(const std::string& line);

DropLog read_drop_log(const std::filesystem::path& file, bool skip_damaged);

}  // namespace powderlink::analysis
