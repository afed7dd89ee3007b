// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/measurement_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <utility>

#include "base/csv/csv_units.h"
#include "base/invalid_input.h"
#include "base/text/units.h"

namespace powderlink::analysis {

namespace {

/// Small letters and digits: "Impact velocity" is impact_velocity.
std::string bare(const std::string& name) {
  std::string text;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Name and unit of a column: from brackets, else from the row of units, else from the name's end.
std::pair<std::string, std::string> name_and_unit(const CsvTable& table, std::size_t column) {
  static const std::regex bracketed(R"((.*\S)\s*[\[({]\s*([^\[\](){}]*?)\s*[\])}])");
  const std::string& name = table.columns[column];
  std::smatch found;
  if (std::regex_match(name, found, bracketed)) return {found[1], plain_unit(found[2])};
  const auto [rest, unit] = split_unit(name);
  if (unit != "-") return {rest, plain_unit(unit)};
  return {name, table.units.empty() ? "" : plain_unit(table.units[column])};
}

bool is_stated(const std::string& unit) { return !unit.empty() && unit != "-"; }

}  // namespace

void name_columns(CsvTable& table, const std::vector<std::string>& known) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto [name, unit] = name_and_unit(table, c);
    const std::string below = table.units.empty() ? "" : plain_unit(table.units[c]);
    if (is_stated(below) && is_stated(unit) && below != unit) {
      throw InvalidInput(fmt::format("{}, row of units, column '{}'", table.file, table.columns[c]),
                         table.units[c], unit + ", as the column's name says",
                         "give the values in " + unit + ", or correct the row of units");
    }
    for (const std::string& wanted : known) {
      const auto [wanted_name, wanted_unit] = split_unit(wanted);
      const bool same_unit = wanted_unit == "-" || plain_unit(wanted_unit) == unit;
      if (!same_unit || bare(name) != bare(wanted_name) || table.find_column(wanted)) continue;
      table.columns[c] = wanted;
    }
  }
}

std::string same_in_other_unit(const CsvTable& table, const std::string& missing) {
  const auto [wanted_name, wanted_unit] = split_unit(missing);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto [name, unit] = name_and_unit(table, c);
    if (bare(name) != bare(wanted_name)) continue;
    return fmt::format("; '{}' {}", table.columns[c],
                       is_stated(unit) ? "is in " + unit + ", not " + wanted_unit
                                       : "has no unit: name it " + missing);
  }
  return "";
}

}  // namespace powderlink::analysis
