// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_plain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string/replace.hpp>
#include <vector>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

std::string quoted_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\n;\t#") == std::string::npos) return cell;
  return '"' + boost::algorithm::replace_all_copy(cell, "\"", "\"\"") + '"';
}

/// As it is read by any program; words stay.
std::string plain_cell(const CsvTable& table, const CsvTable::Row& row, std::size_t column) {
  const std::string& cell = row.cells[column];
  if (number_of(cell, DecimalMark::point) && !number_form(cell).spaced) return cell;
  if (!number_form(cell).number) return quoted_cell(cell);
  try {
    return fmt::format("{}", table.number(row, column));
  } catch (const InvalidInput&) {
    return quoted_cell(cell);
  }
}

std::string joined(const std::vector<std::string>& cells) {
  return fmt::format("{}", fmt::join(cells, ","));
}

}  // namespace

std::string plain_row(const CsvTable& table, const CsvTable::Row& row) {
  std::vector<std::string> cells;
  for (std::size_t c = 0; c < row.cells.size(); ++c) cells.push_back(plain_cell(table, row, c));
  return joined(cells);
}

std::string plain_csv(const CsvTable& table, const std::string& text) {
  std::string plain;
  bool same =
      table.encoding == "UTF-8" && text.find('\r') == std::string::npos && table.units.empty();
  for (const CsvTable::Row& row : table.rows) {
    const std::string line = plain_row(table, row);
    same = same && text.find(line) != std::string::npos;
    plain += line + "\n";
  }
  const std::string header = joined(table.columns) + "\n";
  same = same && text.find(header) != std::string::npos;
  if (same) return text.empty() || text.back() == '\n' ? text : text + "\n";
  std::string comments;
  for (const std::string& comment : table.comments) comments += "#" + comment + "\n";
  return comments + header + plain;
}

}  // namespace powderlink
