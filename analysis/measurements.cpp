// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measurements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "analysis/checks.h"
#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

using Check = std::function<double(double, const std::string&)>;

struct Column {
  const char* name;
  bool needed;
  Check check;
  std::function<void(KatRow&, double)> store;
};

double require_sigma_um(double value, const std::string& where) {
  if (!(value > 0.0)) {
    throw InvalidInput(where + ": standard deviation", fmt::format("{:g} um", value), "> 0 um",
                       "give the standard deviation of the critical diameter, or drop the column");
  }
  return value;
}

const std::vector<Column>& columns() {
  static const std::vector<Column> list = {
      {"impact_velocity_m_s", true, require_velocity_m_s,
       [](KatRow& r, double x) { r.impact_velocity_m_s = x; }},
      {"critical_diameter_um", true, require_diameter_um,
       [](KatRow& r, double x) { r.critical_diameter_um = x; }},
      {"critical_diameter_sigma_um", false, require_sigma_um,
       [](KatRow& r, double x) { r.critical_diameter_sigma_um = x; }},
      {"contact_time_us", false, require_contact_time_us,
       [](KatRow& r, double x) { r.contact_time_us = x; }},
      {"adhesive_energy_J_m2", false, require_adhesive_energy_J_m2,
       [](KatRow& r, double x) { r.adhesive_energy_J_m2 = x; }},
  };
  return list;
}

void keep_numbers(Measurements& m, const std::string& name) {
  const std::size_t column = *m.table.find_column(name);
  std::vector<double> values;
  try {
    for (const CsvTable::Row& row : m.table.rows) values.push_back(m.table.number(row, column));
  } catch (const InvalidInput&) {
    return;  // a column of words
  }
  for (std::size_t i = 0; i < values.size(); ++i) m.rows[i].other[name] = values[i];
}

}  // namespace

Measurements read_measurements(const std::filesystem::path& file) {
  Measurements m;
  m.table = read_csv(file);
  m.rows.resize(m.table.rows.size());
  for (const Column& c : columns()) {
    const auto column = m.table.find_column(c.name);
    if (!column) {
      if (!c.needed) continue;
      const bool semicolons =
          m.table.columns.size() == 1 && m.table.columns[0].find(';') != std::string::npos;
      throw InvalidInput(m.table.file + ": column '" + c.name + "'",
                         fmt::format("columns {}", fmt::join(m.table.columns, ", ")),
                         "impact_velocity_m_s and critical_diameter_um are needed",
                         semicolons ? "separate the cells by commas, not semicolons"
                                    : "add the column or rename the one that holds it");
    }
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
      const CsvTable::Row& row = m.table.rows[i];
      c.store(m.rows[i], c.check(m.table.number(row, *column), m.table.place(row, *column)));
    }
  }
  for (const std::string& name : m.table.columns) {
    const auto known = [&](const Column& c) { return name == c.name; };
    if (std::none_of(columns().begin(), columns().end(), known)) m.unknown_columns.push_back(name);
  }
  for (const std::string& name : m.unknown_columns) keep_numbers(m, name);
  return m;
}

}  // namespace powderlink::analysis
