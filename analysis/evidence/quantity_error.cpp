// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/evidence/quantity_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/evidence/quantity.h"

namespace powderlink::analysis {

namespace {

std::string value_text(const QuantityError& e, int decimals) {
  return e.kind == KatRow::Kind::critical_diameter
             ? fmt::format("{:.{}f} %", 100.0 * e.rms, decimals)
             : fmt::format("{:.2g}{}", e.rms, quantity_of(e.kind).unit);
}

}  // namespace

std::vector<QuantityError> rms_errors(const Observations& observations,
                                      const std::vector<double>& errors) {
  std::map<KatRow::Kind, std::pair<double, double>> sums;  // squares and rows
  for (std::size_t i = 0; i < errors.size(); ++i) {
    auto& [squares, rows] = sums[observations.list[i].row.kind()];
    squares += errors[i] * errors[i];
    rows += 1.0;
  }
  std::vector<QuantityError> list;
  for (const auto& [kind, sum] : sums) list.push_back({kind, std::sqrt(sum.first / sum.second)});
  return list;
}

AxisError axis_error(const std::vector<QuantityError>& errors) {
  const QuantityError& e = errors.front();
  const char* unit = e.kind == KatRow::Kind::critical_diameter ? "%"
                     : e.kind == KatRow::Kind::retained_share  ? "points of share"
                                                               : "cm/s";
  return {100.0 * e.rms, unit};
}

double rms_relative_error(const std::vector<QuantityError>& errors) {
  for (const QuantityError& e : errors) {
    if (e.kind == KatRow::Kind::critical_diameter) return e.rms;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string rms_text(const std::vector<QuantityError>& errors, int decimals) {
  std::vector<std::string> texts;
  for (const QuantityError& e : errors) texts.push_back(value_text(e, decimals));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string rms_sentence(const std::vector<QuantityError>& errors) {
  std::vector<std::string> texts;
  for (const QuantityError& e : errors) {
    const bool relative = e.kind == KatRow::Kind::critical_diameter;
    const std::string of =
        errors.size() == 1 && relative ? "" : fmt::format(" of {}", quantity_of(e.kind).plural);
    texts.push_back(
        fmt::format("rms {}error{} {}", relative ? "relative " : "", of, value_text(e, 2)));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace powderlink::analysis
