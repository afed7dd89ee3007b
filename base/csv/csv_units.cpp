// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_units.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <map>
#include <set>

namespace powderlink {

std::string unit_in_brackets(const std::string& cell) {
  std::string unit = boost::algorithm::trim_copy(cell);
  for (const char* brackets : {"[]", "()", "{}"}) {
    if (unit.size() >= 2 && unit.front() == brackets[0] && unit.back() == brackets[1])
      unit = boost::algorithm::trim_copy(unit.substr(1, unit.size() - 2));
  }
  return unit;
}

std::string plain_unit(const std::string& given) {
  std::string unit = unit_in_brackets(given);
  // The micro sign (U+00B5) and the Greek letter (U+03BC) look the same.
  for (const auto& [from, to] :
       {std::pair("\u00B5", "u"), std::pair("\u03BC", "u"), std::pair("\u00B2", "2"),
        std::pair("\u00B3", "3"), std::pair("\u207B\u00B9", "-1"), std::pair("\u00B7", " "),
        std::pair("*", " "), std::pair("^", "")})
    boost::algorithm::replace_all(unit, from, to);
  if (unit == "m s-1" || unit == "m s -1") return "m/s";
  if (unit == "J m-2") return "J/m2";
  static const std::map<std::string, std::string> words = {
      {"micron", "um"},     {"microns", "um"},     {"micrometer", "um"},  {"micrometers", "um"},
      {"micrometre", "um"}, {"micrometres", "um"}, {"mum", "um"},         {"px", "pixel"},
      {"pixels", "pixel"},  {"px2", "pixel2"},     {"pixels2", "pixel2"}, {"microns2", "um2"},
      {"micron2", "um2"},   {"millimetre", "mm"},  {"millimeter", "mm"},  {"mus", "us"}};
  const auto found = words.find(boost::algorithm::to_lower_copy(unit));
  return found == words.end() ? unit : found->second;
}

bool is_row_of_units(const std::vector<std::string>& cells) {
  static const std::set<std::string> known = {
      "m", "cm",    "mm",     "um",  "nm",  "m2",   "cm2",  "mm2",    "um2",     "nm2",  "inch",
      "s", "ms",    "us",     "ns",  "m/s", "mm/s", "cm/s", "um/s",   "km/h",    "J/m2", "mJ/m2",
      "N", "mN",    "uN",     "nN",  "Pa",  "kPa",  "MPa",  "GPa",    "g",       "kg",   "mg",
      "%", "pixel", "pixel2", "1/s", "Hz",  "kHz",  "deg",  "\u00B0", "\u00B0C", "C",    "K"};
  bool any = false;
  for (const std::string& cell : cells) {
    if (cell.empty() || cell == "-" || cell == "\u2013" || cell == "\u2014") continue;
    if (known.count(plain_unit(cell)) == 0 && unit_in_brackets(cell) == cell) return false;
    any = true;
  }
  return any;
}

}  // namespace powderlink
