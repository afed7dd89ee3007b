// SPDX-License-Identifier: GPL-3.0-or-later
/// \file csv_number.h
/// Numbers as programs and countries write them in cells of a table.
///
///   decimal mark   '.' or ','; the other one, a space (no-break too) or an apostrophe may part groups
///                  of three digits: 1399.5, 1,399.5, 1.399,5, 1 399,5, 1'399.5
///   sign, power    '+', '-' and U+2212; e or E with a whole number
///
/// "1.399" is 1.399 or 1399, "1,8" is 1.8 in any country: what one cell leaves open the others of its
/// column decide, and then those of the other columns (csv_table.h).
/// Tests: tests/base/csv_table_test.cpp
#pragma once

#include <optional>
#include <string>

namespace powderlink {

/// What a cell, or a column, can be.
struct NumberForm {
  bool number = false;    ///< in one of the two forms at least
  bool as_point = false;  ///< a number whose decimal mark is '.'
  bool as_comma = false;  ///< ... or ','
  bool same = false;      ///< both with the same value: no mark at all
  bool grouped = false;   ///< one mark with three digits behind: 1.399
  bool spaced = false;    ///< holds separators of groups that are no decimal marks
};

NumberForm number_form(const std::string& cell);

enum class DecimalMark { point, comma };

/// The whole cell as a number; nothing where it is none in this form, or not finite.
std::optional<double> number_of(const std::string& cell, DecimalMark mark);

}  // namespace powderlink
