// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/column_title.h"

#include <algorithm>
#include <regex>

#include "analysis/report/typeset.h"
#include "base/text/units.h"

namespace powderlink::analysis {

std::string column_words(const std::string& name) {
  std::string words = without_unit(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  static const std::regex gamma(R"(\bgamma\b)");
  return std::regex_replace(words, gamma, "Γ");
}

std::string column_title(const std::string& name) {
  const std::string unit = unit_of(name);
  return unit == "-" ? column_words(name) : column_words(name) + " (" + typeset(unit) + ")";
}

}  // namespace powderlink::analysis
