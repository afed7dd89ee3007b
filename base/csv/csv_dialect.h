// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_dialect.h
/// How the cells of a table are separated, told by the table itself: a line `sep=X` on top, as Excel
/// knows it; else the first of tab, semicolon, comma and bar that gives the header and the rows below
/// it the same number of cells; else runs of spaces, if they do.
/// Tests: tests/base/csv_table_test.cpp
#pragma once

#include <string_view>

#include "base/csv/csv_record.h"

namespace powderlink {

/// Whether the line that comes next holds no record: blank, or a comment.
bool is_aside(std::string_view line);

/// The separator; moves `reader` behind a line `sep=X`, and no further.
char find_separator(CsvReader& reader);

}  // namespace powderlink
