// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/csv/csv_dialect.h"
#include "base/csv/csv_record.h"
#include "base/csv/csv_units.h"
#include "base/invalid_input.h"
#include "base/text/text_encoding.h"

namespace powderlink {

namespace {

constexpr std::size_t kLinesToName = 5;

/// "lines 3, 5 and 7 more"
std::string lines_text(const std::vector<int>& lines) {
  std::vector<int> named(lines.begin(),
                         lines.begin() + static_cast<long>(std::min(lines.size(), kLinesToName)));
  std::string text = fmt::format("line{} {}", lines.size() == 1 ? "" : "s", fmt::join(named, ", "));
  if (lines.size() > named.size()) text += fmt::format(" and {} more", lines.size() - named.size());
  return text;
}

/// A line as a message shows it.
std::string shown(std::string_view line) {
  constexpr std::size_t most = 100;
  return "'" + for_terminal(std::string(line.substr(0, most))) + (line.size() > most ? "..." : "") +
         "'";
}

bool is_number(const std::string& cell) { return number_form(cell).number; }

bool is_empty(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const std::string& c) { return c.empty(); });
}

std::string without_line_ends(std::string name) {
  std::replace(name.begin(), name.end(), '\n', ' ');
  return name;
}

class TableReader {
 public:
  TableReader(CsvTable& table, const CsvFormat& format, std::string_view text)
      : table_(table), format_(format), reader_(text), separator_(find_separator(reader_)) {}

  void read() {
    while (!reader_.at_end()) {
      const std::string_view line = reader_.line_ahead();
      if (is_aside(line)) {
        if (const std::size_t mark = line.find('#'); mark != std::string_view::npos)
          table_.comments.emplace_back(line.substr(mark + 1));
        reader_.skip_line();
        continue;
      }
      CsvRecord record = reader_.read(separator_);
      check(record);
      if (is_empty(record.cells)) continue;
      if (table_.columns.empty()) {
        read_header(record);
      } else {
        read_row(record);
      }
    }
    if (!wrong_lines_.empty()) refuse_lengths();
    if (!table_.rows.empty() && is_row_of_units(table_.rows.front().cells)) {
      for (const std::string& cell : table_.rows.front().cells)
        table_.units.push_back(unit_in_brackets(cell));
      table_.rows.erase(table_.rows.begin());
    }
    if (table_.rows.empty()) {
      throw InvalidInput(fmt::format("{}, line {}", table_.file, std::max(reader_.line() - 1, 1)),
                         table_.columns.empty() ? "an empty file" : "a header without rows",
                         "a header line and at least one row, separated by commas", format_.empty);
    }
    drop_empty_columns();
    check_names();
    table_.find_decimal_marks(separator_);
  }

 private:
  std::string place(const CsvRecord& record) const {
    return fmt::format("{}, line {}", table_.file, record.line);
  }

  void check(const CsvRecord& record) const {
    if (record.fault == CsvRecord::Fault::none) return;
    const std::string_view first = record.text.substr(0, record.text.find('\n'));
    if (record.fault == CsvRecord::Fault::open_quotes) {
      throw InvalidInput(place(record), shown(first), "cells in two quotes", "close the quotes");
    }
    throw InvalidInput(place(record), shown(first), "a separator after a cell in quotes",
                       "double the quotes within a cell in quotes, and close every cell");
  }

  /// Without a comment behind the last cell.
  static std::string_view uncommented(std::string_view line) {
    for (std::size_t mark = line.find('#'); mark != std::string_view::npos;
         mark = line.find('#', mark + 1)) {
      if (mark > 0 && (line[mark - 1] == ' ' || line[mark - 1] == '\t'))
        return without_blanks(line.substr(0, mark));
    }
    return line;
  }

  void read_header(CsvRecord& record) {
    const auto numbers = static_cast<std::size_t>(
        std::count_if(record.cells.begin(), record.cells.end(), is_number));
    if (numbers > 0 && 2 * numbers >= record.cells.size()) {
      std::vector<std::string> names;
      if (!table_.comments.empty()) names = cells_of(table_.comments.back(), separator_);
      if (names.size() == record.cells.size() &&
          std::none_of(names.begin(), names.end(), is_number) && !is_empty(names)) {
        table_.columns = std::move(names);
        table_.comments.pop_back();
        return read_row(record);
      }
      throw InvalidInput(place(record) + ", header",
                         "numbers where names are expected (" + shown(record.text) + ")",
                         "a first line with the names of the columns", format_.no_header);
    }
    const std::string_view line = uncommented(record.text);
    if (line.size() < record.text.size()) record.cells = cells_of(line, separator_);
    for (std::string& name : record.cells) name = without_line_ends(std::move(name));
    header_line_ = record.line;
    table_.columns = std::move(record.cells);
  }

  void read_row(CsvRecord& record) {
    const std::size_t width = table_.columns.size();
    if (record.text.find('#') != std::string_view::npos) {
      // A '#' of a label leaves too few cells before it.
      const std::string_view line = uncommented(record.text);
      std::vector<std::string> cells = cells_of(line, separator_);
      if (line.size() < record.text.size() && cells.size() == width)
        record.cells = std::move(cells);
    }
    while (record.cells.size() > width && record.cells.back().empty()) record.cells.pop_back();
    if (record.cells == table_.columns) return;
    if (record.cells.size() == width) {
      table_.rows.push_back({record.line, std::move(record.cells)});
      return;
    }
    if (wrong_lines_.empty()) {
      wrong_cells_ = record.cells.size();
      wrong_text_ = shown(record.text);
    }
    wrong_lines_.push_back(record.line);
  }

  [[noreturn]] void refuse_lengths() const {
    const std::size_t width = table_.columns.size();
    const char* to_do = "fill the missing cells or remove the row";
    if (wrong_cells_ > width)
      to_do =
          "decimal commas? write decimal points, or separate the cells by semicolons; "
          "quote a cell that holds a separator";
    if (width == 1)
      to_do =
          "is a title above the names of the columns? "
          "begin its line with '#'; else separate the names as the cells";
    std::string given = fmt::format("{} cells ({})", wrong_cells_, wrong_text_);
    if (wrong_lines_.size() > 1) {
      given += "; the same in " + lines_text({wrong_lines_.begin() + 1, wrong_lines_.end()});
    }
    throw InvalidInput(fmt::format("{}, line {}, column {}", table_.file, wrong_lines_.front(),
                                   std::min(wrong_cells_, width) + 1),
                       given, fmt::format("{} cells, as in the header", width), to_do);
  }

  /// Spreadsheets save columns beside the table that once held something.
  void drop_empty_columns() {
    const auto is_free = [&](const CsvTable::Row& row) { return row.cells.back().empty(); };
    while (table_.columns.size() > 1 && table_.columns.back().empty() &&
           std::all_of(table_.rows.begin(), table_.rows.end(), is_free)) {
      table_.columns.pop_back();
      if (!table_.units.empty()) table_.units.pop_back();
      for (CsvTable::Row& row : table_.rows) row.cells.pop_back();
    }
  }

  void check_names() const {
    const std::vector<std::string>& names = table_.columns;
    for (auto name = names.begin(); name != names.end(); ++name) {
      if (std::find(names.begin(), name, *name) == name) continue;
      throw InvalidInput(fmt::format("{}, line {}, header", table_.file, header_line_),
                         "column '" + *name + "' twice", "every column once",
                         name->empty() ? "is a title above the names of the columns? "
                                         "begin its line with '#'; else name every column"
                                       : "rename or remove one of them");
    }
  }

  CsvTable& table_;
  const CsvFormat& format_;
  CsvReader reader_;
  char separator_;
  int header_line_ = 1;
  std::size_t wrong_cells_ = 0;
  std::string wrong_text_;
  std::vector<int> wrong_lines_;
};

}  // namespace

std::optional<std::size_t> CsvTable::find_column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::string CsvTable::place(const Row& row, std::size_t column) const {
  return fmt::format("{}, line {}, column '{}'", file, row.line, columns.at(column));
}

void CsvTable::find_decimal_marks(char separator) {
  marks_.assign(columns.size(), {});
  constexpr auto none = static_cast<std::size_t>(-1);
  struct Evidence {
    std::size_t point = none, comma = none, open = none, open_point = none;
  };
  std::vector<Evidence> found(columns.size());
  bool any_point = false, any_comma = false;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Evidence& e = found[c];
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::string& cell = rows[r].cells[c];
      if (cell.find_first_of(".,") == std::string::npos) continue;
      const NumberForm form = number_form(cell);
      if (!form.number) continue;
      std::size_t& first = form.grouped ? e.open : form.as_point ? e.point : e.comma;
      if (first == none) first = r;
      if (form.grouped && e.open_point == none && cell.find('.') != std::string::npos)
        e.open_point = r;
    }
    any_point = any_point || e.point != none;
    any_comma = any_comma || e.comma != none;
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const Evidence& e = found[c];
    ColumnMark& m = marks_[c];
    if (e.point != none && e.comma != none) {
      m = {DecimalMark::point, ColumnMark::Doubt::two_marks, e.point, e.comma};
    } else if (e.point != none || e.comma != none) {
      m.mark = e.point != none ? DecimalMark::point : DecimalMark::comma;
    } else if (any_point != any_comma) {
      m.mark = any_point ? DecimalMark::point : DecimalMark::comma;
      // Points that group beside commas in quotes: seldom enough to ask.
      if (any_comma && e.open_point != none && separator == ',')
        m = {DecimalMark::comma, ColumnMark::Doubt::open, e.open_point, e.open_point};
    } else if (e.open != none && rows[e.open].cells[c].find(',') != std::string::npos) {
      // Semicolons separate cells where the comma is the decimal mark.
      m.mark = DecimalMark::comma;
      if (separator != ';') m = {DecimalMark::comma, ColumnMark::Doubt::open, e.open, e.open};
    }
  }
}

void CsvTable::refuse_mark(std::size_t column) const {
  const ColumnMark& m = marks_[column];
  const Row &first = rows[m.first], &second = rows[m.second];
  if (m.doubt == ColumnMark::Doubt::open) {
    throw InvalidInput(place(first, column), "'" + first.cells[column] + "'",
                       "a number that has one meaning",
                       "save the table with decimal points and without separators of thousands");
  }
  throw InvalidInput(fmt::format("{}, lines {} and {}, column '{}'", file, first.line, second.line,
                                 columns[column]),
                     fmt::format("'{}' and '{}'", first.cells[column], second.cells[column]),
                     "one decimal mark in a column, and one separator of thousands",
                     "save the table with decimal points and without separators of thousands");
}

void CsvTable::refuse_cell(const Row& row, std::size_t column) const {
  const std::string& cell = row.cells[column];
  const DecimalMark mark = column < marks_.size() ? marks_[column].mark : DecimalMark::point;
  std::string given = cell.empty() ? "an empty cell" : "'" + cell + "'";
  std::vector<int> others;
  for (const Row& other : rows)
    if (other.line > row.line && !number_of(other.cells[column], mark))
      others.push_back(other.line);
  if (!others.empty()) given += ", and no number in " + lines_text(others) + " either";
  throw InvalidInput(place(row, column), given,
                     mark == DecimalMark::point ? "a finite number with a decimal point"
                                                : "a finite number with a decimal comma, as above",
                     "correct the cell or remove the row");
}

double CsvTable::number(const Row& row, std::size_t column) const {
  DecimalMark mark = DecimalMark::point;
  if (column < marks_.size()) {
    if (marks_[column].doubt != ColumnMark::Doubt::none) refuse_mark(column);
    mark = marks_[column].mark;
  }
  const auto value = number_of(row.cells.at(column), mark);
  if (!value) refuse_cell(row, column);
  return *value;
}

CsvTable read_csv(const std::filesystem::path& file, const CsvFormat& format) {
  CsvTable table;
  table.file = file.string();
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InvalidInput(format.what, table.file, "a CSV file that can be read", format.absent);
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  const Text text = decoded(bytes.str(), file);
  table.encoding = text.encoding;
  TableReader(table, format, text.utf8).read();
  return table;
}

}  // namespace powderlink
