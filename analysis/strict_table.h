// SPDX-License-Identifier: GPL-3.0-or-later
/// \file strict_table.h
/// One table of a TOML file that knows its keys: unknown keys, wrong types and missing values are
/// InvalidInput with file, line, table and key.
/// Tests: tests/analysis/study_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace powderlink::analysis {

class StrictTable {
 public:
  /// \param table  may be nullptr: then every value is absent
  /// \param where  such as "study.toml [kat]"
  StrictTable(const toml::table* table, std::string where, const std::vector<std::string>& keys);

  bool has(const std::string& key) const;
  std::optional<double> number(const std::string& key) const;
  std::optional<long> integer(const std::string& key) const;
  std::optional<std::string> text(const std::string& key) const;
  std::optional<std::vector<double>> numbers(const std::string& key) const;
  std::optional<std::vector<std::string>> texts(const std::string& key) const;
  StrictTable table(const std::string& key, const std::vector<std::string>& keys) const;
  std::vector<std::string> keys() const;

  /// Throws "missing" with the text that would be right.
  [[noreturn]] void missing(const std::string& key, const std::string& allowed,
                            const std::string& to_do) const;
  /// "study.toml, line 12: [kat] wall"
  std::string place(const std::string& key) const;

 private:
  const toml::node* find(const std::string& key) const;
  [[noreturn]] void wrong_type(const std::string& key, const std::string& allowed) const;

  const toml::table* table_;
  std::string where_;
};

}  // namespace powderlink::analysis
