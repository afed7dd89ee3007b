// SPDX-License-Identifier: GPL-3.0-or-later
/// \file strict_table.h
/// One table of a TOML file that knows its keys: unknown keys, wrong types and missing values are
/// InvalidInput with file, line, table and key.
/// Tests: tests/analysis/kat/study_test.cpp
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace powderlink {

/// A TOML file in any encoding of text_encoding.h, or InvalidInput: one that is not there, named
/// `what`, or with line and column.
toml::table read_toml(const std::filesystem::path& file, const std::string& what,
                      const std::string& to_do);
/// The same of a text; `where` it was given.
toml::table parse_toml(const std::string& text, const std::string& where);

class StrictTable {
 public:
  /// \param table  nullptr: every value is absent
  /// \param file   for messages
  /// \param name   of the table in the file, such as "kat"; empty for the top level
  /// \param keys   allowed; nothing is checked when empty
  StrictTable(const toml::table* table, std::string file, std::string name,
              std::vector<std::string> keys);

  bool present() const { return table_ != nullptr; }
  bool has(const std::string& key) const { return find(key) != nullptr; }
  bool is_list(const std::string& key) const { return has(key) && find(key)->is_array(); }
  std::vector<std::string> keys() const;

  std::optional<double> number(const std::string& key) const;
  std::optional<long> integer(const std::string& key) const;
  std::optional<std::string> text(const std::string& key) const;
  std::optional<std::vector<double>> numbers(const std::string& key) const;
  std::optional<std::vector<std::string>> texts(const std::string& key) const;
  StrictTable table(const std::string& key, std::vector<std::string> keys) const;

  /// "study.toml, line 12, [kat] wall"
  std::string place(const std::string& key) const;

 private:
  const toml::node* find(const std::string& key) const;
  [[noreturn]] void wrong_type(const std::string& key, const std::string& allowed) const;

  const toml::table* table_;
  std::string file_;
  std::string name_;
};

}  // namespace powderlink
