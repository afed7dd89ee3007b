// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace powderlink {

TextTable::TextTable(std::vector<std::string> header) : left_(header.size(), false) {
  left_.at(0) = true;
  rows_.push_back(std::move(header));
}

void TextTable::add(std::vector<std::string> row) {
  row.resize(left_.size());
  rows_.push_back(std::move(row));
}

void TextTable::flush_left(std::size_t column) { left_.at(column) = true; }

std::string TextTable::text() const {
  std::vector<std::size_t> width(left_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  }
  std::string out;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    std::string line;
    for (std::size_t c = 0; c < width.size(); ++c) {
      line += (c == 0 ? "" : "  ") + (left_[c] ? fmt::format("{:<{}}", rows_[r][c], width[c])
                                               : fmt::format("{:>{}}", rows_[r][c], width[c]));
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (r > 0) continue;
    for (std::size_t c = 0; c < width.size(); ++c)
      out += (c == 0 ? "" : "  ") + std::string(width[c], '-');
    out += "\n";
  }
  return out;
}

}  // namespace powderlink
