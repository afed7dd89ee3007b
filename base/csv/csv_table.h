// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_table.h
/// The one reader of tables that users bring: measurements, grains, contact radii.
///
///   text       text_encoding.h: encodings and ends of lines
///   cells      csv_dialect.h, csv_record.h: separators, quotes
///   numbers    csv_number.h; the decimal mark is one per column
///   '#'        begins a comment line, and a comment behind the last cell of a row. Names behind '#' are
///              the header where rows of as many numbers follow at once, as numpy writes it
///   units      a row of units under the header is no row
///
/// Left out: empty rows, the header again, columns without name and cells at the right end.
/// Cells are kept as text. Every error is InvalidInput and names file, line and column.
/// Tests: tests/base/csv_table_test.cpp, tests/analysis/kat/measurements_test.cpp,
/// tests/analysis/sizes/particle_table_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/csv/csv_number.h"

namespace powderlink {

/// What a table is for, as errors say it.
struct CsvFormat {
  const char* what = "measurement file";
  const char* absent = "check the path; a relative one starts at the study file's folder";
  const char* empty = "fill the file, or correct its path in the study";
  const char* no_header = "write the names of the columns into the first line, separated by commas";
};

struct CsvTable {
  struct Row {
    int line = 0;  ///< in the file, from 1
    std::vector<std::string> cells;
  };
  std::string file;
  std::string encoding;
  std::vector<std::string> comments;  ///< lines that begin with '#', without it
  std::vector<std::string> columns;
  std::vector<std::string> units;  ///< of a row of units, without brackets; else empty
  std::vector<Row> rows;

  std::optional<std::size_t> find_column(const std::string& name) const;
  /// "drop.csv, line 4, column 'impact_velocity_m_s'"
  std::string place(const Row& row, std::size_t column) const;
  /// Throws unless the whole cell is a finite number, and where two rows of the column contradict each
  /// other in their decimal mark, or nothing tells 1399 from 1.399.
  double number(const Row& row, std::size_t column) const;

  /// Takes the decimal marks from the rows.
  void find_decimal_marks(char separator);

 private:
  struct ColumnMark {
    DecimalMark mark = DecimalMark::point;
    enum class Doubt { none, two_marks, open } doubt = Doubt::none;
    std::size_t first = 0, second = 0;  ///< rows that show it
  };
  std::vector<ColumnMark> marks_;

  [[noreturn]] void refuse_mark(std::size_t column) const;
  [[noreturn]] void refuse_cell(const Row& row, std::size_t column) const;
};

/// Throws for a file that cannot be read, is empty, has no header, rows of another length than its
/// header, or two columns of the same name.
CsvTable read_csv(const std::filesystem::path& file, const CsvFormat& format = {});

}  // namespace powderlink
