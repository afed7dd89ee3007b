// SPDX-License-Identifier: GPL-3.0-or-later
/// \file text_table.h
/// Aligned columns for the terminal: the first column flush left, the others flush right.
/// Tests: tests/analysis/program/commands_test.cpp
#pragma once

#include <string>
#include <vector>

namespace powderlink {

class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header);
  void add(std::vector<std::string> row);  ///< shorter rows are filled with empty cells
  void flush_left(std::size_t column);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  std::vector<bool> left_;
};

}  // namespace powderlink
