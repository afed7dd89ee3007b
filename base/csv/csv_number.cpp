// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv/csv_number.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace powderlink {

namespace {

constexpr int kGroup = 3;  // digits

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A no-break space (U+00A0), a narrow (U+202F) or thin one (U+2009), an apostrophe (' or U+2019).
std::size_t group_space(std::string_view text) {
  for (const std::string_view s : {" ", "'", "\u00A0", "\u202F", "\u2009", "\u2019"})
    if (text.substr(0, s.size()) == s) return s.size();
  return 0;
}

std::size_t sign_length(std::string_view text) {
  for (const std::string_view s : {"+", "-", "\u2212"})
    if (text.substr(0, s.size()) == s) return s.size();
  return 0;
}

}  // namespace

NumberForm number_form(const std::string& cell) {
  std::string_view rest(cell);
  rest.remove_prefix(sign_length(rest));
  int digits = 0, before_first = 0;  // of this run; of the first one
  bool zero_first = !rest.empty() && rest.front() == '0';
  int points = 0, commas = 0, spaces = 0, all_digits = 0;
  char last_mark = 0;
  bool groups_fit =
      true;  // all runs but the first and the last have three digits, the first 1 to 3
  bool first = true;
  bool power = false;
  std::size_t i = 0;
  while (i < rest.size()) {
    const char c = rest[i];
    if (is_digit(c)) {
      ++digits;
      ++all_digits;
      ++i;
      continue;
    }
    if ((c == 'e' || c == 'E') && all_digits > 0) {
      std::string_view tail = rest.substr(i + 1);
      tail.remove_prefix(sign_length(tail));
      power = !tail.empty() && tail.find_first_not_of("0123456789") == std::string_view::npos;
      if (!power) return {};
      break;
    }
    const std::size_t space = c == '.' || c == ',' ? 0 : group_space(rest.substr(i));
    if (c != '.' && c != ',' && space == 0) return {};
    if (first) {
      before_first = digits;
      first = false;
    } else {
      groups_fit = groups_fit && digits == kGroup;
    }
    points += c == '.' ? 1 : 0;
    commas += c == ',' ? 1 : 0;
    spaces += space > 0 ? 1 : 0;
    last_mark = space > 0 ? ' ' : c;
    digits = 0;
    i += space > 0 ? space : 1;
  }
  if (all_digits == 0) return {};
  NumberForm form;
  form.spaced = spaces > 0;
  const int marks = points + commas + spaces;
  if (marks == 0) {
    form.number = form.as_point = form.as_comma = form.same = true;
    return form;
  }
  const bool first_fits = before_first >= 1 && before_first <= kGroup && !zero_first;
  const bool last_is_group = digits == kGroup && !power;
  const auto fits = [&](char decimal, int decimals, int others) {
    if (decimals > 1 || (decimals == 1 && last_mark != decimal)) return false;
    if (others > 0 && spaces > 0) return false;
    if (others + spaces == 0) return true;
    return first_fits && groups_fit && (decimals == 1 || last_is_group);
  };
  form.as_point = fits('.', points, commas);
  form.as_comma = fits(',', commas, points);
  form.number = form.as_point || form.as_comma;
  form.same = form.as_point && form.as_comma && points + commas == 0;
  form.grouped = form.as_point && form.as_comma && !form.same;
  return form;
}

std::optional<double> number_of(const std::string& cell, DecimalMark mark) {
  double value = 0.0;
  const auto parsed = [&](const char* begin, const char* end) {
    const auto [rest, error] = std::from_chars(begin, end, value);
    return error == std::errc() && rest == end && std::isfinite(value);
  };
  const char decimal = mark == DecimalMark::point ? '.' : ',';
  const bool plain = cell.find_first_not_of("0123456789.eE-") == std::string::npos;
  if (plain && mark == DecimalMark::point)
    return parsed(cell.data(), cell.data() + cell.size()) ? std::optional(value) : std::nullopt;
  const NumberForm form = number_form(cell);
  if (mark == DecimalMark::point ? !form.as_point : !form.as_comma) return std::nullopt;
  std::string text;
  std::string_view rest(cell);
  if (const std::size_t sign = sign_length(rest); sign > 0) {
    if (rest.front() != '+') text += '-';
    rest.remove_prefix(sign);
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const char c = rest[i];
    if (c == decimal) text += '.';
    if (is_digit(c) || c == 'e' || c == 'E' || c == '-') text += c;
    if (rest.substr(i, 3) == "\u2212") text += '-';  // of the power
  }
  return parsed(text.data(), text.data() + text.size()) ? std::optional(value) : std::nullopt;
}

}  // namespace powderlink
