// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_record.h
/// Cells of one record by RFC 4180: a cell in quotes may hold separators and ends of lines, a quote in
/// it is doubled; a backslash is a character as any other. Spaces around a cell are dropped.
/// Beyond it: a quote inside a cell without quotes is a character, as in the labels that ImageJ writes
/// (5" tube). That keeps libcsv from this place: its strict mode refuses such labels, the other one
/// takes what follows a quote that was never closed, rows included, for one cell without a word.
/// Tests: tests/base/csv_table_test.cpp, tests/analysis/sizes/particle_table_test.cpp
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace powderlink {

constexpr char kBlanks = ' ';  ///< separator: runs of spaces

struct CsvRecord {
  int line = 0;           ///< where it begins, from 1
  std::string_view text;  ///< without the end of its line
  std::vector<std::string> cells;
  enum class Fault { none, open_quotes, text_after_quotes } fault = Fault::none;
};

/// Lines of a text, in which records are found one after the other.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ >= text_.size(); }
  int line() const { return line_; }
  /// The line that comes next, without its end.
  std::string_view line_ahead() const;
  void skip_line();
  /// The record that begins here; needs !at_end().
  CsvRecord read(char separator);

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Cells of a text that is one record, whatever its faults.
std::vector<std::string> cells_of(std::string_view record, char separator);

/// Without spaces, tabs and no-break spaces at its ends.
std::string_view without_blanks(std::string_view text);

}  // namespace powderlink
