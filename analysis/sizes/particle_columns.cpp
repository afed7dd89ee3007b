// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sizes/particle_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <map>
#include <regex>

#include "base/csv/csv_units.h"
#include "base/invalid_input.h"

namespace powderlink::analysis {

namespace {

constexpr double kPixels = 0.0;  // as a unit

struct Name {
  std::string quantity;
  std::optional<double> unit_um;  ///< kPixels; empty: not stated
};

std::string if_encoding_is_wrong(const CsvTable& table) {
  if (table.encoding.compare(0, 3, "UTF") == 0) return "";
  return "; its text was taken for " + table.encoding + ": save it as UTF-8 if that is wrong";
}

double unit_named(const CsvTable& table, const std::string& text, const std::string& place) {
  static const std::map<std::string, double> units = {
      {"nm", 1e-3}, {"um", 1.0}, {"mm", 1e3}, {"cm", 1e4}, {"pixel", kPixels}};
  std::string unit = plain_unit(text);
  if (!unit.empty() && unit.back() == '2') unit.pop_back();
  if (const auto found = units.find(unit); found != units.end()) return found->second;
  throw InvalidInput(place, "the unit '" + text + "'", "um, mm, cm, nm or pixel",
                     "give the table in um or in pixels" + if_encoding_is_wrong(table));
}

/// "Perim." -> perim; "area_um2", "Area (µm²)" -> area in um.
Name parsed(const CsvTable& table, std::size_t c, const std::string& place) {
  const std::string column = boost::algorithm::to_lower_copy(table.columns[c]);
  static const std::regex own("(area|perimeter|feret)_(nm|um|mm|cm)2?");
  static const std::regex bracketed(R"((area|perim\.?|perimeter|feret)\s*[\[(]\s*(.+?)\s*[\])])");
  static const std::regex length("area|perim|perimeter|feret");
  std::smatch found;
  if (std::regex_match(column, found, own)) return {found[1], unit_named(table, found[2], place)};
  if (std::regex_match(column, found, bracketed)) {
    return {boost::algorithm::trim_right_copy_if(found[1].str(), boost::is_any_of(".")),
            unit_named(table, found[2], place)};
  }
  Name name{boost::algorithm::trim_right_copy_if(column, boost::is_any_of(".")), std::nullopt};
  if (!table.units.empty() && !table.units[c].empty() && std::regex_match(name.quantity, length))
    name.unit_um = unit_named(table, table.units[c], table.file + ", row of units");
  return name;
}

void refuse_summary(const CsvTable& table) {
  if (!table.find_column("Count") ||
      (!table.find_column("Total Area") && !table.find_column("Average Size")))
    return;
  throw InvalidInput(table.file + ", header", "ImageJ's table Summary, with one row per picture",
                     "its table Results, with one row per grain",
                     "in Analyze Particles tick \"Display results\", and save the table Results");
}

}  // namespace

ParticleColumns find_particle_columns(const CsvTable& table) {
  refuse_summary(table);
  std::map<std::string, std::size_t> at;
  std::optional<double> unit;
  const std::string header = table.file + ", header";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Name name = parsed(table, c, header);
    at.emplace(name.quantity, c);
    static const std::regex length("area|perim|perimeter|feret");
    if (!std::regex_match(name.quantity, length)) continue;
    const double stated = name.unit_um.value_or(kPixels);
    if (unit && *unit != stated) {
      throw InvalidInput(
          header, "lengths in different units: " + boost::algorithm::join(table.columns, ", "),
          "Area, Perim. and Feret all in pixels or all in um",
          "export the table again with one unit");
    }
    unit = stated;
  }
  const auto find = [&](std::initializer_list<const char*> names) {
    std::optional<std::size_t> column;
    for (const char* name : names) {
      if (const auto found = at.find(name); found != at.end() && !column) column = found->second;
    }
    return column;
  };
  ParticleColumns columns;
  columns.perimeter = find({"perim", "perimeter"});
  columns.circularity = find({"circ", "circularity"});
  columns.aspect_ratio = find({"ar", "aspect_ratio"});
  columns.roundness = find({"round", "roundness"});
  columns.feret = find({"feret"});
  columns.pixel_size = find({"pixel_size_um"});
  if (unit && *unit != kPixels) columns.unit_um = unit;
  // Units in the names are their users'.
  const auto named = [&](const char* start) {
    return std::any_of(table.columns.begin(), table.columns.end(), [&](const std::string& name) {
      return boost::algorithm::starts_with(name, start);
    });
  };
  columns.imagej = named("Area") && (named("Perim.") || named("Circ."));
  const auto area = find({"area"});
  if (!area || (!columns.perimeter && !columns.circularity)) {
    throw InvalidInput(header, "the columns " + boost::algorithm::join(table.columns, ", "),
                       "'Area' and 'Perim.' or 'Circ.' (also read: AR or Round, Feret)",
                       "in ImageJ tick Area, Perimeter and Shape descriptors "
                       "in Analyze > Set Measurements, measure again and save with column headers" +
                           if_encoding_is_wrong(table));
  }
  columns.area = *area;
  return columns;
}

std::optional<double> number_or_nothing(const CsvTable& table, const CsvTable::Row& row,
                                        const std::optional<std::size_t>& column) {
  if (!column || row.cells[*column].empty() || boost::algorithm::iequals(row.cells[*column], "nan"))
    return std::nullopt;
  return table.number(row, *column);
}

std::optional<double> stated_pixel_size_um(const CsvTable& table) {
  static const std::regex stated(R"(\s*pixel[ _]size(?:_um)?\s*[:=]\s*(\S+)\s*(?:um|µm|μm)?\s*)",
                                 std::regex::icase);
  for (const std::string& comment : table.comments) {
    std::smatch found;
    if (!std::regex_match(comment, found, stated)) continue;
    CsvTable cell;
    cell.file = table.file;
    cell.columns = {"# pixel_size_um"};
    cell.rows = {{0, {found[1]}}};
    cell.find_decimal_marks(';');
    return cell.number(cell.rows.front(), 0);
  }
  return std::nullopt;
}

}  // namespace powderlink::analysis
