// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_table.h
/// A comma-separated file: '#' comment lines, one header line, rows of equal length.
/// Cells are kept as text, quotes as in RFC 4180. Every error is InvalidInput and names file, line and column.
/// Tests: tests/analysis/measurements_test.cpp, tests/psd/particle_table_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

/// What a table is for, as errors say it, and how its cells are separated.
struct CsvFormat {
  const char* what = "measurement file";
  const char* absent = "check the path; a relative one starts at the study file's folder";
  const char* empty = "fill the file, or correct its path in the study";
  /// Whether a header with tabs, or without commas but with semicolons, is separated by these.
  bool any_separator = false;
};

struct CsvTable {
  struct Row {
    int line = 0;  ///< in the file, from 1
    std::vector<std::string> cells;
  };
  std::string file;
  std::vector<std::string> comments;  ///< lines that begin with '#', without it
  std::vector<std::string> columns;
  std::vector<Row> rows;

  std::optional<std::size_t> find_column(const std::string& name) const;
  /// "drop.csv, line 4, column 'impact_velocity_m_s'"
  std::string place(const Row& row, std::size_t column) const;
  /// Throws unless the whole cell is a finite number.
  double number(const Row& row, std::size_t column) const;
};

/// Throws for a file that cannot be read, is empty, has rows of another length than its header, or
/// two columns of the same name.
CsvTable read_csv(const std::filesystem::path& file, const CsvFormat& format = {});

}  // namespace powderlink::analysis
