// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/particles/particle_columns.h"

#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <map>
#include <regex>

#include "models/invalid_input.h"

namespace powderlink::analysis {

namespace {

enum class Unit { none, pixel, um };

struct Name {
  std::string quantity;
  Unit unit = Unit::none;
};

Unit unit_named(const std::string& text, const std::string& place) {
  static const std::regex um("(um|µm|μm|microns?)(\\^?2|²)?");
  static const std::regex pixel("(px|pixels?)(\\^?2|²)?");
  if (std::regex_match(text, um)) return Unit::um;
  if (std::regex_match(text, pixel)) return Unit::pixel;
  throw InvalidInput(place, "the unit '" + text + "'", "um or pixel",
                     "give the table in um or in pixels");
}

/// "Perim." -> perim; "area_um2", "Area (µm²)" -> area in um.
Name parsed(std::string column, const std::string& place) {
  boost::algorithm::to_lower(column);
  static const std::regex own("(area|perimeter|feret)_um2?");
  static const std::regex bracketed(R"((area|perim\.?|perimeter|feret)\s*[\[(]\s*(.+?)\s*[\])])");
  std::smatch found;
  if (std::regex_match(column, found, own)) return {found[1], Unit::um};
  if (std::regex_match(column, found, bracketed)) {
    return {boost::algorithm::trim_right_copy_if(found[1].str(), boost::is_any_of(".")),
            unit_named(found[2], place)};
  }
  boost::algorithm::trim_right_if(column, boost::is_any_of("."));
  return {column, Unit::none};
}

}  // namespace

ParticleColumns find_particle_columns(const CsvTable& table) {
  std::map<std::string, std::size_t> at;
  std::optional<Unit> unit;
  const std::string header = table.file + ", header";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Name name = parsed(table.columns[c], header);
    at.emplace(name.quantity, c);
    static const std::regex length("area|perim|perimeter|feret");
    if (!std::regex_match(name.quantity, length)) continue;
    if (unit && *unit != name.unit) {
      throw InvalidInput(
          header, "lengths in different units: " + boost::algorithm::join(table.columns, ", "),
          "Area, Perim. and Feret all in pixels or all in um",
          "export the table again with one unit");
    }
    unit = name.unit;
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
  columns.in_um = unit == Unit::um;
  const auto area = find({"area"});
  if (!area || (!columns.perimeter && !columns.circularity)) {
    throw InvalidInput(header, "the columns " + boost::algorithm::join(table.columns, ", "),
                       "'Area' and 'Perim.' or 'Circ.' (also read: AR or Round, Feret)",
                       "in ImageJ tick Area, Perimeter and Shape descriptors in Analyze > Set "
                       "Measurements, measure "
                       "again and save with column headers");
  }
  columns.area = *area;
  return columns;
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
    return cell.number({0, {found[1]}}, 0);
  }
  return std::nullopt;
}

}  // namespace powderlink::analysis
