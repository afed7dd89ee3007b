// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/inline_svg.h"

#include <regex>

#include "base/invalid_input.h"

namespace powderlink::analysis {

std::string inline_svg(const std::string& svg, const std::string& id) {
  const std::size_t begin = svg.find("<svg");
  const std::size_t end = svg.find('>', begin);
  if (begin == std::string::npos || end == std::string::npos)
    throw InvalidInput("figure " + id, "no <svg> element", "an SVG drawing", "draw it again");
  static const std::regex size(R"(\s(width|height)="[^"]*")");
  static const std::regex ids(R"(\sid=(["']))");
  static const std::regex links(R"((href=["']|url\()#)");
  const std::string tag = std::regex_replace(svg.substr(begin, end - begin), size, "");
  std::string rest = std::regex_replace(svg.substr(end), ids, " id=$1" + id + "-");
  rest = std::regex_replace(rest, links, "$1#" + id + "-");
  return tag + rest;
}

}  // namespace powderlink::analysis
