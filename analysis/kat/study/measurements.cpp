// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/study/measurements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/kat/experiment/grain_drops.h"
#include "analysis/kat/study/checks.h"
#include "analysis/kat/study/measurement_names.h"
#include "base/invalid_input.h"

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

double require_sigma_m_s(double value, const std::string& where) {
  if (!(value > 0.0)) {
    throw InvalidInput(where + ": standard deviation", fmt::format("{:g} m/s", value), "> 0 m/s",
                       "give the standard deviation of the speed, or drop the column");
  }
  return value;
}

double require_count(double value, const std::string& where) {
  if (!(value >= 0.0 && value == std::floor(value))) {
    throw InvalidInput(where + ": count of grains", fmt::format("{:g}", value),
                       "a whole number, 0 or more", "give counts, not shares");
  }
  return value;
}

double require_speed_m_s(double value, const std::string& where) {
  return value == 0.0 ? value : require_velocity_m_s(value, where);
}

std::vector<Column> common_columns() {
  return {{"impact_velocity_m_s", true, require_velocity_m_s,
           [](KatRow& r, double x) { r.impact_velocity_m_s = x; }},
          {"contact_time_us", false, require_contact_time_us,
           [](KatRow& r, double x) { r.contact_time_us = x; }},
          {"adhesive_energy_J_m2", false, require_adhesive_energy_J_m2,
           [](KatRow& r, double x) { r.adhesive_energy_J_m2 = x; }}};
}

std::vector<Column> columns_of(KatRow::Kind kind) {
  std::vector<Column> list = common_columns();
  const Column diameter = {"diameter_um", true, require_diameter_um,
                           [](KatRow& r, double x) { r.diameter_um = x; }};
  if (kind == KatRow::Kind::critical_diameter) {
    list.push_back({"critical_diameter_um", true, require_diameter_um,
                    [](KatRow& r, double x) { r.critical_diameter_um = x; }});
    list.push_back({"critical_diameter_sigma_um", false, require_sigma_um,
                    [](KatRow& r, double x) { r.critical_diameter_sigma_um = x; }});
  } else if (kind == KatRow::Kind::retained_share) {
    list.push_back(diameter);
    list.push_back({"diameter_low_um", false, require_diameter_um,
                    [](KatRow& r, double x) { r.diameter_low_um = x; }});
    list.push_back({"diameter_high_um", false, require_diameter_um,
                    [](KatRow& r, double x) { r.diameter_high_um = x; }});
    list.push_back(
        {"count_before", true, require_count, [](KatRow& r, double x) { r.count_before = x; }});
    list.push_back(
        {"count_after", true, require_count, [](KatRow& r, double x) { r.count_after = x; }});
  } else {
    list.push_back(diameter);
    list.push_back({"residual_velocity_m_s", true, require_speed_m_s,
                    [](KatRow& r, double x) { r.residual_velocity_m_s = x; }});
    list.push_back({"residual_velocity_sigma_m_s", false, require_sigma_m_s,
                    [](KatRow& r, double x) { r.residual_velocity_sigma_m_s = x; }});
  }
  return list;
}

/// Every name that any kind of table knows.
std::vector<std::string> known_names() {
  std::vector<std::string> names = grain_drop_columns();
  for (const auto kind : {KatRow::Kind::critical_diameter, KatRow::Kind::retained_share,
                          KatRow::Kind::residual_speed})
    for (const Column& c : columns_of(kind)) names.emplace_back(c.name);
  return names;
}

KatRow::Kind kind_of(const CsvTable& table) {
  if (table.find_column("count_before") || table.find_column("count_after"))
    return KatRow::Kind::retained_share;
  return table.find_column("residual_velocity_m_s") ? KatRow::Kind::residual_speed
                                                    : KatRow::Kind::critical_diameter;
}

/// A sigma in another unit than the diameter passes as a number, and would decide every verdict.
void check_sigmas(const Measurements& m) {
  constexpr double least = 1e-5;  // of the diameter: below what any microscope resolves
  for (std::size_t i = 0; i < m.rows.size(); ++i) {
    const KatRow& row = m.rows[i];
    if (!row.critical_diameter_um || !row.critical_diameter_sigma_um) continue;
    const double part = *row.critical_diameter_sigma_um / *row.critical_diameter_um;
    if (part >= least && part < 1.0) continue;
    throw InvalidInput(fmt::format("{}, line {}, column 'critical_diameter_sigma_um'", m.table.file,
                                   m.table.rows[i].line),
                       fmt::format("{:g} um of {:g} um", *row.critical_diameter_sigma_um,
                                   *row.critical_diameter_um),
                       "1e-5 of the diameter up to less than the diameter",
                       part < least ? "were metres given where micrometres are meant?"
                                    : "give one standard deviation in micrometres");
  }
}

void check_counts(const Measurements& m) {
  for (std::size_t i = 0; i < m.rows.size(); ++i) {
    const KatRow& row = m.rows[i];
    const std::string where = fmt::format("{}, line {}", m.table.file, m.table.rows[i].line);
    if (row.count_before && (*row.count_before < 1.0 || *row.count_after > *row.count_before)) {
      throw InvalidInput(
          where + ": counts",
          fmt::format("{:g} before, {:g} after", *row.count_before, *row.count_after),
          "at least one before, and no more after than before",
          "correct the counts, or remove an empty class");
    }
    if (row.diameter_low_um && row.diameter_high_um &&
        !(*row.diameter_low_um < *row.diameter_high_um)) {
      throw InvalidInput(
          where + ": size class",
          fmt::format("{:g} to {:g} um", *row.diameter_low_um, *row.diameter_high_um), "low < high",
          "correct the limits");
    }
  }
}

void require_columns(const CsvTable& table, const std::vector<Column>& columns) {
  std::vector<std::string> missing;
  for (const Column& c : columns)
    if (c.needed && !table.find_column(c.name)) missing.push_back(fmt::format("'{}'", c.name));
  if (missing.empty()) return;
  std::string given = fmt::format("columns {}", fmt::join(table.columns, ", "));
  std::string to_do = "add the column or rename the one that holds it";
  for (const Column& c : columns) {
    if (!c.needed || table.find_column(c.name)) continue;
    const std::string other = same_in_other_unit(table, c.name);
    if (!other.empty()) to_do = "give the values in the unit of the needed name, under that name";
    given += other;
  }
  if (table.columns.size() == 1) to_do = "separate the cells by commas, semicolons or tabs";
  throw InvalidInput(fmt::format("{}: column{} {}", table.file, missing.size() == 1 ? "" : "s",
                                 fmt::join(missing, ", ")),
                     given,
                     kind_of(table) == KatRow::Kind::critical_diameter
                         ? "impact_velocity_m_s and critical_diameter_um are needed"
                         : "see the columns of each kind of table in docs/reference.md",
                     to_do);
}

/// Numbers that are possible, and a thousand times off what such tests have.
void doubt_units(Measurements& m) {
  const auto doubt = [&](const char* column, const UsualRange& usual, auto value) {
    std::vector<double> values;
    for (const KatRow& row : m.rows)
      if (const std::optional<double> x = value(row)) values.push_back(*x);
    std::string question = unit_question(values, usual);
    if (question.empty()) question = mixed_unit_question(values, usual);
    if (!question.empty())
      m.notes.push_back(fmt::format("{}, column '{}': {}", m.table.file, column, question));
  };
  doubt("impact_velocity_m_s", kUsualVelocity,
        [](const KatRow& r) { return std::optional(r.impact_velocity_m_s); });
  doubt("critical_diameter_um", kUsualDiameter,
        [](const KatRow& r) { return r.critical_diameter_um; });
  doubt("diameter_um", kUsualDiameter, [](const KatRow& r) { return r.diameter_um; });
  doubt("contact_time_us", kUsualContactTime, [](const KatRow& r) { return r.contact_time_us; });
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
  name_columns(m.table, known_names());
  if (is_grain_drops(m.table)) {
    m.rows = grain_drop_rows(m.table, m.unknown_columns, m.notes);
    return m;
  }
  m.rows.resize(m.table.rows.size());
  const std::vector<Column> columns = columns_of(kind_of(m.table));
  require_columns(m.table, columns);
  for (const Column& c : columns) {
    const auto column = m.table.find_column(c.name);
    if (!column) continue;
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
      const CsvTable::Row& row = m.table.rows[i];
      c.store(m.rows[i], c.check(m.table.number(row, *column), m.table.place(row, *column)));
    }
  }
  for (const std::string& name : m.table.columns) {
    const auto known = [&](const Column& c) { return name == c.name; };
    if (std::none_of(columns.begin(), columns.end(), known)) m.unknown_columns.push_back(name);
  }
  for (const std::string& name : m.unknown_columns) keep_numbers(m, name);
  check_counts(m);
  check_sigmas(m);
  doubt_units(m);
  return m;
}

}  // namespace powderlink::analysis
