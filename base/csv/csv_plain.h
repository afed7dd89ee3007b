// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_plain.h
/// A table in the program's own form, to which rows may be added: UTF-8, commas, decimal points.
/// Tests: tests/analysis/program/table_commands_test.cpp
#pragma once

#include <string>

#include "base/csv/csv_table.h"

namespace powderlink {

/// The cells of a row between commas; numbers in columns of numbers as the shortest that reads back.
std::string plain_row(const CsvTable& table, const CsvTable::Row& row);

/// `text`, of which the table was read, when it has this form already; else comments, header and rows.
std::string plain_csv(const CsvTable& table, const std::string& text);

}  // namespace powderlink
