// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/grain_drops.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>

#include "analysis/kat/experiment/grain_files.h"
#include "analysis/kat/experiment/retention_analysis.h"
#include "analysis/kat/experiment/retention_classes.h"
#include "analysis/kat/study/checks.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kDropColumns = {
    "impact_velocity_m_s", "before_files",        "after_files",     "pixel_size_um",
    "area_ratio",          "class_width_percent", "contact_time_us", "adhesive_energy_J_m2"};
constexpr std::size_t kNeeded = 3;

/// One row of the table, by name of the column.
class Cells {
 public:
  Cells(const CsvTable& table, const CsvTable::Row& row) : table_(table), row_(row) {}

  std::vector<std::string> patterns(const char* name) const {
    std::vector<std::string> list;
    const std::string& cell = row_.cells[*table_.find_column(name)];
    boost::algorithm::split(list, cell, boost::algorithm::is_any_of(";"));
    for (std::string& pattern : list) {
      boost::algorithm::trim(pattern);
      pattern = (fs::path(table_.file).parent_path() / pattern).string();
    }
    return list;
  }
  std::optional<double> number(const char* name) const {
    const auto column = table_.find_column(name);
    return column ? std::optional(table_.number(row_, *column)) : std::nullopt;
  }
  double within(const char* name, double value, double low, double high) const {
    if (value >= low && value <= high) return value;
    throw InvalidInput(place(name), fmt::format("{:g}", value),
                       fmt::format("{:g} to {:g}", low, high), "correct the cell");
  }
  std::string place(const char* name) const {
    return table_.place(row_, *table_.find_column(name));
  }

 private:
  const CsvTable& table_;
  const CsvTable::Row& row_;
};

void add_drop(const Cells& cells, std::vector<KatRow>& rows, std::vector<std::string>& notes) {
  KatRow drop;
  drop.impact_velocity_m_s = require_velocity_m_s(*cells.number("impact_velocity_m_s"),
                                                  cells.place("impact_velocity_m_s"));
  drop.contact_time_us = cells.number("contact_time_us");
  if (drop.contact_time_us)
    require_contact_time_us(*drop.contact_time_us, cells.place("contact_time_us"));
  drop.adhesive_energy_J_m2 = cells.number("adhesive_energy_J_m2");
  if (drop.adhesive_energy_J_m2)
    require_adhesive_energy_J_m2(*drop.adhesive_energy_J_m2, cells.place("adhesive_energy_J_m2"));

  const GrainDiameters grains =
      read_grains({cells.patterns("before_files"), cells.patterns("after_files"),
                   cells.number("pixel_size_um")});
  for (const std::string& note : grains.notes)
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  RetentionOptions options;
  options.nominal_ratio = grains.ratio_of_files();
  options.pixel_um = grains.pixel_size_um.value_or(0.0);
  options.area_ratio = cells.number("area_ratio");
  if (options.area_ratio) cells.within("area_ratio", *options.area_ratio, 1e-3, 1e3);
  double width = kClassWidth;
  if (const auto percent = cells.number("class_width_percent"))
    width = 0.01 * cells.within("class_width_percent", *percent, 1.0, 50.0);
  drop.area_ratio = fit_retention(grains.before_um, grains.after_um, options).area_ratio;
  for (const RetentionClass& c : retention_classes(grains.before_um, grains.after_um, width)) {
    drop.diameter_um = c.middle_um();
    drop.diameter_low_um = c.low_um;
    drop.diameter_high_um = c.high_um;
    drop.count_before = c.before;
    drop.count_after = c.after;
    rows.push_back(drop);
  }
}

}  // namespace

bool is_grain_drops(const CsvTable& table) {
  return table.find_column("before_files") || table.find_column("after_files");
}

const std::vector<std::string>& grain_drop_columns() { return kDropColumns; }

std::vector<KatRow> grain_drop_rows(const CsvTable& table, std::vector<std::string>& unknown,
                                    std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < kNeeded; ++i) {
    if (table.find_column(kDropColumns[i])) continue;
    throw InvalidInput(table.file + ": column '" + kDropColumns[i] + "'",
                       fmt::format("columns {}", fmt::join(table.columns, ", ")),
                       "impact_velocity_m_s, before_files and after_files are needed",
                       "add the column");
  }
  for (const std::string& name : table.columns)
    if (std::find(kDropColumns.begin(), kDropColumns.end(), name) == kDropColumns.end())
      unknown.push_back(name);
  std::vector<KatRow> rows;
  for (const CsvTable::Row& row : table.rows) add_drop(Cells(table, row), rows, notes);
  return rows;
}

}  // namespace powderlink::analysis
