// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <charconv>
#include <cmath>
#include <fstream>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

/// Cells of a line by RFC 4180: a cell in quotes may hold separators, and a quote in it is doubled;
/// a backslash is a character as any other. Spaces around a cell are dropped.
std::vector<std::string> split(const std::string& line, char separator, const std::string& place) {
  std::vector<std::string> cells(1);
  enum { outside, inside, after } quotes = outside;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    std::string& cell = cells.back();
    if (quotes == inside) {
      const bool doubled = c == '"' && i + 1 < line.size() && line[i + 1] == '"';
      if (c == '"' && !doubled) {
        quotes = after;
        continue;
      }
      if (doubled) ++i;
      cell += c;
    } else if (c == separator) {
      cells.emplace_back();
      quotes = outside;
    } else if (quotes == after) {
      if (c != ' ' && c != '\t') {
        throw InvalidInput(place, "'" + line + "'", "a separator after a cell in quotes",
                           "double the quotes within a cell in quotes");
      }
    } else if (c == '"' && cell.find_first_not_of(" \t") == std::string::npos) {
      cell.clear();
      quotes = inside;
    } else {
      cell += c;
    }
  }
  if (quotes == inside) {
    throw InvalidInput(place, "'" + line + "'", "cells in two quotes, on one line",
                       "close the quotes");
  }
  for (std::string& cell : cells) boost::algorithm::trim(cell);
  return cells;
}

char separator_of(const std::string& header) {
  if (header.find('\t') != std::string::npos) return '\t';
  return header.find(',') == std::string::npos && header.find(';') != std::string::npos ? ';' : ',';
}

}  // namespace

std::optional<std::size_t> CsvTable::find_column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::string CsvTable::place(const Row& row, std::size_t column) const {
  return fmt::format("{}, line {}, column '{}'", file, row.line, columns.at(column));
}

double CsvTable::number(const Row& row, std::size_t column) const {
  const std::string& cell = row.cells.at(column);
  const char* begin = cell.c_str() + (!cell.empty() && cell[0] == '+' ? 1 : 0);
  const char* end = cell.c_str() + cell.size();
  double value = 0.0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    throw InvalidInput(place(row, column), cell.empty() ? "an empty cell" : "'" + cell + "'",
                       "a finite number with a decimal point",
                       "correct the cell or remove the row");
  }
  return value;
}

CsvTable read_csv(const std::filesystem::path& file, const CsvFormat& format) {
  CsvTable table;
  table.file = file.string();
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw InvalidInput(format.what, table.file, "a CSV file that can be read", format.absent);
  }
  int line_number = 0;
  char separator = ',';
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line_number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t text = line.find_first_not_of(" \t");
    if (text == std::string::npos) continue;
    if (line[text] == '#') {
      table.comments.push_back(line.substr(text + 1));
      continue;
    }
    if (table.columns.empty() && format.any_separator) separator = separator_of(line);
    const std::string place = fmt::format("{}, line {}", table.file, line_number);
    std::vector<std::string> cells = split(line, separator, place);
    if (table.columns.empty()) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (std::find(cells.begin(), cells.begin() + static_cast<long>(i), cells[i]) !=
            cells.begin() + static_cast<long>(i)) {
          throw InvalidInput(place + ", header", "column '" + cells[i] + "' twice",
                             "every column once", "rename or remove one of them");
        }
      }
      table.columns = std::move(cells);
    } else if (cells.size() != table.columns.size()) {
      const bool comma = cells.size() > table.columns.size();
      throw InvalidInput(
          fmt::format("{}, column {}", place, std::min(cells.size(), table.columns.size()) + 1),
          fmt::format("{} cells ('{}')", cells.size(), line),
          fmt::format("{} cells, as in the header", table.columns.size()),
          comma ? "decimal commas? write decimal points"
                : "fill the missing cells or remove the row");
    } else {
      table.rows.push_back({line_number, std::move(cells)});
    }
  }
  if (table.rows.empty()) {
    throw InvalidInput(fmt::format("{}, line {}", table.file, std::max(line_number, 1)),
                       table.columns.empty() ? "an empty file" : "a header without rows",
                       "a header line and at least one row, separated by commas", format.empty);
  }
  return table;
}

}  // namespace powderlink::analysis
