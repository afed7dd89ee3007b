// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_dialect.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <optional>
#include <string>
#include <vector>

namespace powderlink {

namespace {

constexpr std::string_view kSeparators = "\t;,|";  // in the order of how sure they are
constexpr int kRowsToAsk = 20;

std::optional<char> declared(std::string_view line) {
  std::string_view text = without_blanks(line);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  constexpr std::string_view word = "sep=";
  if (!boost::algorithm::istarts_with(text, word)) return std::nullopt;
  const std::string_view rest = text.substr(word.size());
  if (rest.empty() && line.find('\t') != std::string_view::npos) return '\t';  // was trimmed
  return rest.size() == 1 ? std::optional(rest.front()) : std::nullopt;
}

/// Cells of the header and of the rows that are asked; empty cells at the end do not count.
bool all_rows_agree(CsvReader reader, char separator) {
  std::size_t header = 0;
  for (int row = 0; row <= kRowsToAsk && !reader.at_end();) {
    if (is_aside(reader.line_ahead())) {
      reader.skip_line();
      continue;
    }
    CsvRecord record = reader.read(separator);
    if (record.fault != CsvRecord::Fault::none) return false;
    if (row > 0) {
      while (record.cells.size() > header && record.cells.back().empty()) record.cells.pop_back();
    }
    if (row == 0) header = record.cells.size();
    if (record.cells.size() != header) return false;
    ++row;
  }
  return header > 1;
}

}  // namespace

bool is_aside(std::string_view line) {
  const std::size_t text = line.find_first_not_of(" \t");
  return text == std::string_view::npos || line[text] == '#';
}

char find_separator(CsvReader& reader) {
  while (!reader.at_end() && without_blanks(reader.line_ahead()).empty()) reader.skip_line();
  if (!reader.at_end()) {
    if (const auto separator = declared(reader.line_ahead())) {
      reader.skip_line();
      return *separator;
    }
  }
  CsvReader header = reader;
  while (!header.at_end() && is_aside(header.line_ahead())) header.skip_line();
  if (header.at_end()) return ',';
  const std::string_view line = header.line_ahead();
  std::vector<char> candidates;
  for (const char c : kSeparators)
    if (line.find(c) != std::string_view::npos) candidates.push_back(c);
  if (candidates.empty()) return all_rows_agree(header, kBlanks) ? kBlanks : ',';
  if (candidates.size() == 1) return candidates.front();
  for (const char c : candidates)
    if (all_rows_agree(header, c)) return c;
  return line.find('\t') != std::string_view::npos  ? '\t'
         : line.find(',') != std::string_view::npos ? ','
                                                    : candidates.front();
}

}  // namespace powderlink
