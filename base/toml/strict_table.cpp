// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/toml/strict_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/files/file_text.h"
#include "base/invalid_input.h"
#include "base/text/text_encoding.h"

namespace powderlink {

toml::table parse_toml(const std::string& text, const std::string& where) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& e) {
    throw InvalidInput(fmt::format("{}, line {}, column {}", where, e.source().begin.line,
                                   e.source().begin.column),
                       std::string(e.description()), "TOML", "correct the line");
  }
}

toml::table read_toml(const std::filesystem::path& file, const std::string& what,
                      const std::string& to_do) {
  if (!std::filesystem::is_regular_file(file))
    throw InvalidInput(what, file.string(), "a TOML file that can be read", to_do);
  return parse_toml(decoded(file_text(file), file).utf8, file.string());
}

StrictTable::StrictTable(const toml::table* table, std::string file, std::string name,
                         std::vector<std::string> allowed)
    : table_(table), file_(std::move(file)), name_(std::move(name)) {
  if (allowed.empty()) return;
  for (const std::string& key : keys()) {
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) {
      throw InvalidInput(place(key), "unknown key '" + key + "'",
                         fmt::format("{}", fmt::join(allowed, ", ")), "correct or remove the key");
    }
  }
}

std::vector<std::string> StrictTable::keys() const {
  std::vector<std::string> names;
  if (table_ != nullptr) {
    for (const auto& entry : *table_) names.emplace_back(entry.first.str());
  }
  return names;
}

const toml::node* StrictTable::find(const std::string& key) const {
  return table_ != nullptr ? table_->get(key) : nullptr;
}

std::string StrictTable::place(const std::string& key) const {
  const toml::node* node = find(key);
  std::string text = file_;
  if (node != nullptr) text += fmt::format(", line {}", node->source().begin.line);
  return text + (name_.empty() ? ", " : ", [" + name_ + "] ") + key;
}

void StrictTable::wrong_type(const std::string& key, const std::string& allowed) const {
  std::ostringstream given;
  const toml::node* node = find(key);
  node->visit([&](const auto& value) { given << value; });
  throw InvalidInput(place(key), given.str(), allowed, "correct the value");
}

std::optional<double> StrictTable::number(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) wrong_type(key, "a finite number");
  return value;
}

std::optional<long> StrictTable::integer(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_integer()) wrong_type(key, "a whole number");
  return static_cast<long>(*node->value<int64_t>());
}

std::optional<std::string> StrictTable::text(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) wrong_type(key, "a text in quotes");
  return node->value<std::string>();
}

std::optional<std::vector<double>> StrictTable::numbers(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const char* allowed = "a list of finite numbers, such as [1.0, 2.0]";
  if (!node->is_array()) wrong_type(key, allowed);
  std::vector<double> values;
  for (const toml::node& element : *node->as_array()) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) wrong_type(key, allowed);
    values.push_back(*value);
  }
  return values;
}

std::optional<std::vector<std::string>> StrictTable::texts(const std::string& key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const char* allowed = "a list of texts, such as [\"finite_stop_pulse\"]";
  if (!node->is_array()) wrong_type(key, allowed);
  std::vector<std::string> values;
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_string()) wrong_type(key, allowed);
    values.push_back(*element.value<std::string>());
  }
  return values;
}

StrictTable StrictTable::table(const std::string& key, std::vector<std::string> keys) const {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_table()) wrong_type(key, "a table [" + key + "]");
  return {node != nullptr ? node->as_table() : nullptr, file_,
          name_.empty() ? key : name_ + "." + key, std::move(keys)};
}

}  // namespace powderlink
