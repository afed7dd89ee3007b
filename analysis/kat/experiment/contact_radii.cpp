// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/experiment/contact_radii.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/kat/study/measurement_names.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

struct Column {
  const char* name;
  double low, high;
  double unit;
  double ContactRadius::*value;
};

const Column kRadiusColumns[] = {
    {"contact_radius_um", 0.01, 1e3, 1e-6, &ContactRadius::contact_radius_m},
    {"radius_um", 0.1, 1e4, 1e-6, &ContactRadius::radius_m},
    {"wavelength_nm", 200.0, 2000.0, 1e-9, &ContactRadius::wavelength_m},
};

}  // namespace

std::vector<ContactRadius> read_contact_radii(const std::filesystem::path& file) {
  CsvTable table = read_csv(file);
  std::vector<std::string> names;
  for (const Column& c : kRadiusColumns) names.emplace_back(c.name);
  name_columns(table, names);
  std::vector<ContactRadius> list(table.rows.size());
  for (const Column& c : kRadiusColumns) {
    const auto column = table.find_column(c.name);
    if (!column) {
      throw InvalidInput(table.file + ": column '" + c.name + "'",
                         fmt::format("columns {}", fmt::join(table.columns, ", ")),
                         "contact_radius_um, radius_um and wavelength_nm",
                         "add the column or rename the one that holds it");
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double value = table.number(table.rows[i], *column);
      if (!(value >= c.low && value <= c.high)) {
        throw InvalidInput(table.place(table.rows[i], *column), fmt::format("{:g}", value),
                           fmt::format("{:g} to {:g}", c.low, c.high), "correct value or unit");
      }
      list[i].*c.value = value * c.unit;
    }
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].contact_radius_m < list[i].radius_m) continue;
    throw InvalidInput(fmt::format("{}, line {}", table.file, table.rows[i].line),
                       fmt::format("a contact of {:g} um under a grain of {:g} um",
                                   1e6 * list[i].contact_radius_m, 1e6 * list[i].radius_m),
                       "a contact radius below the grain's radius",
                       "exchange the columns, or correct the row");
  }
  return list;
}

}  // namespace powderlink::analysis
